// SPDX-License-Identifier: MIT
#include "transfer/frame_rotation.hpp"

#include <algorithm>

#include "simd/zero_lanes.hpp"

namespace nicol {

FrameRotation::FrameRotation(const LightLayout& layout)
    : rotation_(layout.order()),
      in_world_(layout, LightFields::Form::coefficients),
      in_frame_(layout, LightFields::Form::rotated) {}

template <class Rotate>
void FrameRotation::rotate(const LightFields& from, const LightFields& to, std::span<const glm::vec3> normals,
                           VertexLight& light, std::size_t block, const Rotate& one_part) const {
    LaneRotation::Work& work = rotation_.work_of_thread();
    const auto channels = static_cast<std::size_t>(light.channels());
    const auto numbers = [&](std::size_t c) { return light.block(block, static_cast<int>(c)).data(); };
    rotation_.set_normals(normals, work);
    for (std::size_t p = 0; p < from.parts().size(); ++p) {
        for (std::size_t first = 0; first < channels; first += LaneRotation::kMostFields) {
            const std::size_t count = std::min(LaneRotation::kMostFields, channels - first);
            const std::size_t begin = from.parts()[p].begin, size = from.parts()[p].to_light.size();
            bool zero = true;
            for (std::size_t f = 0; f < count && zero; ++f)
                zero = all_zero(std::span(numbers(first + f) + begin, size));
            if (zero) continue;
            for (std::size_t f = 0; f < count; ++f)
                LightFields::from_light(from.parts()[p], numbers(first + f), count, f, work.fields());
            one_part(from.parts()[p].kind, count, work);
            for (std::size_t f = 0; f < count; ++f)
                LightFields::to_light(to.parts()[p], work.fields(), count, f, numbers(first + f));
        }
    }
}

void FrameRotation::into_frames(std::span<const glm::vec3> normals, VertexLight& light,
                                std::size_t block) const {
    rotate(in_world_, in_frame_, normals, light, block,
           [&](LaneRotation::Field kind, std::size_t fields, LaneRotation::Work& work) {
               rotation_.rotate(kind, fields, work);
           });
}

void FrameRotation::into_world(std::span<const glm::vec3> normals, VertexLight& light,
                               std::size_t block) const {
    rotate(in_frame_, in_world_, normals, light, block,
           [&](LaneRotation::Field kind, std::size_t fields, LaneRotation::Work& work) {
               rotation_.rotate_back(kind, fields, work);
           });
}

}  // namespace nicol
