// SPDX-License-Identifier: MIT
#include "draw/variation_buffers.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "draw/texture_table.hpp"
#include "error.hpp"
#include "gl/context.hpp"
#include "gl/storage.hpp"

namespace nicol {
namespace {

// Words before the textures in the layout of glsl/pixel_texture.comp.
constexpr std::size_t kHeaderWords = 8;
// With one texture the compiler of NVIDIA's driver (580) crashes. No textures are fewer than an array can
// have.
constexpr std::size_t kFewestTextures = 2;

std::uint32_t word(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

}  // namespace

VariationBuffers::VariationBuffers(const std::shared_ptr<gl::Context>& context,
                                   const SpatialVariation& variation)
    : layers_(variation.layers.size()) {
    TextureTable textures;
    std::vector<std::uint32_t> numbers;
    for (const TexturePtr& texture : variation.textures) numbers.push_back(textures.number_of(texture));
    const NormalVariation& normal = variation.normal;
    const bool turned = normal.kind != NormalVariation::Kind::none;
    const std::uint32_t normal_number = turned ? textures.number_of(normal.texture) : 0;

    while (textures.count() < kFewestTextures) textures.number_of(constant_texture(glm::vec4(0), 1));

    std::vector<std::uint32_t> table;
    std::vector<float> texels;
    textures.write(kHeaderWords, table, texels);
    table[0] = static_cast<std::uint32_t>(layers_);
    table[1] = static_cast<std::uint32_t>(table.size());
    table[2] = static_cast<std::uint32_t>(normal.kind);
    table[3] = normal_number;
    table[4] = word(static_cast<float>(normal.scale));
    table[5] = normal.mirrored_y ? 1 : 0;
    table[6] = normal.reversed_back ? 1 : 0;
    table[7] = numbers.empty() ? 0 : numbers.back();

    std::vector<std::uint32_t> factors;
    constexpr std::size_t layer_words = 5;
    const std::size_t first_factor = table.size() + layer_words * layers_;
    for (const MaterialLayer& layer : variation.layers) {
        for (glm::length_t c = 0; c < 3; ++c) table.push_back(word(layer.scale[c]));
        table.push_back(static_cast<std::uint32_t>(first_factor + factors.size()));
        table.push_back(static_cast<std::uint32_t>(layer.factors.size()));
        for (const LayerFactor& factor : layer.factors)
            factors.insert(factors.end(), {static_cast<std::uint32_t>(factor.kind), numbers[factor.texture],
                                           word(factor.low), word(factor.middle), word(factor.high)});
    }
    table.insert(table.end(), factors.begin(), factors.end());
    if (texels.empty()) texels.push_back(0);
    const std::size_t most = context->limits().storage_bytes / sizeof(float);
    if (texels.size() > most)
        throw Error(ErrorCode::unsupported,
                    "compute shaders of " + context->info().renderer + " reach " + std::to_string(most) +
                        " numbers of a material's textures, which have " + std::to_string(texels.size()) +
                        "; use smaller images, or set executor to cpu");
    textures_ = static_cast<int>(textures.count());
    table_.emplace(gl::storage(context, table));
    texels_.emplace(gl::storage(context, texels));
}

void VariationBuffers::bind(unsigned table, unsigned texels) const {
    table_->bind_storage(table);
    texels_->bind_storage(texels);
}

}  // namespace nicol
