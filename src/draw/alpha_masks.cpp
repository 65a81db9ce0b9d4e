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
        opacities_.clear();
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
            opacities_.resize(geometry.ranges.size());
            opacities_[r] = of;
        }
    });
    if (!opacities_.empty()) buffers.corners().update(geometry, geometry_version, material_version);
}

int AlphaMasks::textures(std::size_t range) const {
    return opacities_.empty() || opacities_[range] == nullptr ? 0 : opacities_[range]->textures();
}

std::vector<gl::Define> AlphaMasks::defines(int textures) {
    if (textures == 0) return {};
    return {{.name = "ALPHA_MASK"}, {.name = "TEXTURES", .value = std::to_string(textures)}};
}

void AlphaMasks::bind(gl::Program& program, std::size_t range) const {
    const CornerBuffers& corners = buffers_->corners();
    corners.bind(0);
    buffers_->indices()->buffer().bind_storage(1);
    buffers_->positions()->bind_storage(2);
    opacities_[range]->bind(3, 4);
    program.set("corner_numbers", corners.numbers());
    program.set("colored", corners.colored() ? 1 : 0);
}

}  // namespace nicol
