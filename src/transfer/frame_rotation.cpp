// SPDX-License-Identifier: MIT
#include "transfer/frame_rotation.hpp"

#include <algorithm>

namespace nicol {

FrameRotation::FrameRotation(const LightLayout& layout)
    : order_(layout.order()),
      rotation_(layout.order()),
      in_world_(layout, LightFields::Form::coefficients),
      in_frame_(layout, LightFields::Form::rotated) {}

template <class Rotate>
void FrameRotation::rotate(const LightFields& from, const LightFields& to, std::span<const glm::vec3> normals,
                           std::span<Lanes* const> channels, const Rotate& one_part) const {
    thread_local LaneRotation::Work work;
    thread_local int order = -1;  // that it is for
    if (order != order_) work = rotation_.work();
    order = order_;
    rotation_.set_normals(normals, work);
    for (std::size_t p = 0; p < from.parts().size(); ++p) {
        for (std::size_t first = 0; first < channels.size(); first += LaneRotation::kMostFields) {
            const std::size_t count = std::min(LaneRotation::kMostFields, channels.size() - first);
            for (std::size_t f = 0; f < count; ++f)
                LightFields::from_light(from.parts()[p], channels[first + f], count, f, work.fields());
            one_part(from.parts()[p].kind, count, work);
            for (std::size_t f = 0; f < count; ++f)
                LightFields::to_light(to.parts()[p], work.fields(), count, f, channels[first + f]);
        }
    }
}

void FrameRotation::into_frames(std::span<const glm::vec3> normals, std::span<Lanes* const> channels) const {
    rotate(in_world_, in_frame_, normals, channels,
           [&](LaneRotation::Field kind, std::size_t fields, LaneRotation::Work& work) {
               rotation_.rotate(kind, fields, work);
           });
}

void FrameRotation::into_world(std::span<const glm::vec3> normals, std::span<Lanes* const> channels) const {
    rotate(in_frame_, in_world_, normals, channels,
           [&](LaneRotation::Field kind, std::size_t fields, LaneRotation::Work& work) {
               rotation_.rotate_back(kind, fields, work);
           });
}

}  // namespace nicol
