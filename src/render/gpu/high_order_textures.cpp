// SPDX-License-Identifier: MIT
#include "render/gpu/high_order_textures.hpp"

#include <algorithm>

#include "render/framebuffer.hpp"

namespace nicol {
namespace {

constexpr int kGroup = Framebuffer::kGroup;

int group_count(int channels) {
    return (channels + kGroup - 1) / kGroup;
}

int group_size(int channels, int group) {
    return std::min(kGroup, channels - group * kGroup);
}

// The layers that glsl/high_order.glsl wants of a group; a map of one channel serves all.
gl::Texture2D texture_of(const std::shared_ptr<gl::Context>& context, const LobeMap& map, int group,
                         int channels) {
    const bool single = map.channels() == 1;
    const int layers = map.polarized() ? 2 * channels : 1;
    const gl::TextureDescription size{.width = map.columns(), .height = layers * map.rows()};
    const int first = group * (map.polarized() ? 2 * kGroup : 1);
    if (!single) return {context, size, map.layers_apart(first, layers)};
    std::vector<float> texels;
    for (int c = 0; c < (map.polarized() ? channels : 1); ++c) {
        const std::vector<float> from = map.layers_apart(0, map.polarized() ? 2 : 1);
        texels.insert(texels.end(), from.begin(), from.end());
    }
    if (!map.polarized()) {
        for (std::size_t i = 0; i < texels.size(); i += 4) {
            texels[i + 1] = texels[i + 2] = texels[i + 3] = texels[i];
        }
    }
    return {context, size, texels};
}

}  // namespace

void HighOrderTextures::update(const HighOrderTransfer& transfer, int channels) {
    copying_.run(transfer.parts().version(), channels, [&] { copy(transfer, channels); });
}

void HighOrderTextures::copy(const HighOrderTransfer& transfer, int channels) {
    parts_.clear();
    maps_.clear();
    for (const auto& [material, from] : *transfer.parts()) {
        polarized_ = from.maps.central->polarized();
        Part part{.factors = {},
                  .central = textures(from.maps.central, channels),
                  .outer = textures(from.maps.outer, channels),
                  .base = textures(from.maps.base, channels),
                  .spread = static_cast<float>(from.factors.spread()),
                  .has_base = from.maps.base != nullptr};
        // A sampler wants a texture, used or not.
        if (part.outer == nullptr) part.outer = part.central;
        if (part.base == nullptr) part.base = part.central;
        for (int g = 0; g < group_count(channels); ++g) {
            const std::vector<float> texels =
                from.factors.texels(g * kGroup, group_size(channels, g), polarized_);
            const gl::TextureDescription size{
                .width = HighOrderFactors::kAngles,
                .height = static_cast<int>(texels.size() / 4 / HighOrderFactors::kAngles)};
            part.factors.emplace_back(context_, size, texels);
        }
        parts_.emplace(material, std::move(part));
    }
}

const HighOrderTextures::Textures* HighOrderTextures::textures(const LobeMap* map, int channels) {
    if (map == nullptr) return nullptr;
    const auto [found, made] = maps_.try_emplace(map);
    for (int g = 0; made && g < group_count(channels); ++g) {
        found->second.push_back(texture_of(context_, *map, g, group_size(channels, g)));
    }
    return &found->second;
}

void HighOrderTextures::bind(gl::Program& program, const Part& part, std::size_t group) {
    program.set("spread", part.spread);
    program.set("has_base", part.has_base ? 1 : 0);
    part.factors[group].bind(0);
    (*part.central)[group].bind(1);
    (*part.outer)[group].bind(2);
    (*part.base)[group].bind(3);
}

}  // namespace nicol
