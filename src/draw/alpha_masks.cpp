// SPDX-License-Identifier: MIT
#include "draw/alpha_masks.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace nicol {

void AlphaMasks::update(const WorldGeometry& geometry, Version geometry_version, Version material_version,
                        VertexBuffers& buffers) {
    buffers_ = &buffers;
    copying_.run(geometry_version, material_version, [&] {
        version_ = new_version();
        masks_.clear();
        std::map<TexturePtr, std::shared_ptr<const VariationBuffers>> known;
        for (std::size_t r = 0; r < geometry.ranges.size(); ++r) {
            const TexturePtr opacity = opacity_of(*geometry.ranges[r].material);
            if (opacity == nullptr) continue;
            std::shared_ptr<const VariationBuffers>& of = known[opacity];
            if (of == nullptr) {
                SpatialVariation alone;
                alone.textures = {opacity};
                of = std::make_shared<const VariationBuffers>(context_, alone);
            }
            masks_.resize(geometry.ranges.size());
            masks_[r] = {.opacity = of, .translucent = geometry.ranges[r].material->variation()->translucent};
        }
    });
    if (!masks_.empty()) buffers.corners().update(geometry, geometry_version, material_version);
}

int AlphaMasks::textures(std::size_t range) const {
    return masks_.empty() || masks_[range].opacity == nullptr ? 0 : masks_[range].opacity->textures();
}

std::vector<gl::Define> AlphaMasks::defines(int textures) {
    if (textures == 0) return {};
    return {{.name = "ALPHA_MASK"}, {.name = "TEXTURES", .value = std::to_string(textures)}};
}

void AlphaMasks::bind(gl::Program& program, std::size_t range, std::size_t sample,
                      std::size_t samples) const {
    const CornerBuffers& corners = buffers_->corners();
    corners.bind(0);
    buffers_->indices()->buffer().bind_storage(1);
    buffers_->positions()->bind_storage(2);
    masks_[range].opacity->bind(3, 4);
    program.set("translucent", masks_[range].translucent ? 1 : 0);
    program.set("sample_number", static_cast<std::uint32_t>(sample));
    program.set("samples", static_cast<std::uint32_t>(samples));
    program.set("corner_numbers", corners.numbers());
    program.set("colored", corners.colored() ? 1 : 0);
}

}  // namespace nicol
