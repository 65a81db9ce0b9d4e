// SPDX-License-Identifier: MIT
#include "draw/variation_buffers.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "error.hpp"
#include "gl/context.hpp"
#include "gl/storage.hpp"

namespace nicol {
namespace {

// Sizes of the layout of glsl/texture.glsl and glsl/pixel_texture.comp.
constexpr std::size_t kHeaderWords = 8;
constexpr std::size_t kTextureWords = 24;
// With one texture the compiler of NVIDIA's driver (580) crashes. No textures are fewer than an array can
// have.
constexpr std::size_t kFewestTextures = 2;

std::uint32_t word(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

// List of textures, in which a texture's factors precede it.
class Textures {
public:
    std::uint32_t number_of(const TexturePtr& texture) {
        const auto known = std::ranges::find(textures_, texture);
        if (known != textures_.end()) return static_cast<std::uint32_t>(known - textures_.begin());
        const TextureDescription description = texture->describe();
        std::array<std::uint32_t, 2> factors{};
        if (description.kind == TextureDescription::Kind::product)
            for (std::size_t i = 0; i < 2; ++i) factors[i] = number_of(description.factors[i]);
        textures_.push_back(texture);
        descriptions_.push_back(description);
        factors_.push_back(factors);
        return static_cast<std::uint32_t>(textures_.size() - 1);
    }

    [[nodiscard]] std::size_t count() const { return textures_.size(); }

    // Appends the textures' words, which begin at `begin`, and their texels.
    void write(std::size_t begin, std::vector<std::uint32_t>& table, std::vector<float>& texels) const {
        table.resize(begin + kTextureWords * count());
        for (std::size_t t = 0; t < count(); ++t) {
            const TextureDescription& from = descriptions_[t];
            const std::size_t at = begin + kTextureWords * t;
            const auto channels = static_cast<std::uint32_t>(textures_[t]->channels());
            table[at] = static_cast<std::uint32_t>(from.kind);
            table[at + 1] = channels;
            table[at + 2] = static_cast<std::uint32_t>(from.sampling.filter);
            table[at + 3] = static_cast<std::uint32_t>(from.sampling.wrap);
            table[at + 4] = static_cast<std::uint32_t>(from.levels.size());
            table[at + 5] = static_cast<std::uint32_t>(table.size());
            std::size_t next = at + 6;
            for (glm::length_t column = 0; column < 3; ++column)
                for (glm::length_t row = 0; row < 2; ++row)
                    table[next++] = word(static_cast<float>(from.sampling.to_uv[column][row]));
            for (const glm::vec4& color : from.colors)
                for (glm::length_t c = 0; c < 4; ++c) table[next++] = word(color[c]);
            if (from.kind == TextureDescription::Kind::product)
                std::ranges::copy(factors_[t], table.begin() + static_cast<std::ptrdiff_t>(at + 12));
            for (const TextureImage& level : from.levels) {
                const auto width = static_cast<std::uint32_t>(level.width);
                const auto height = static_cast<std::uint32_t>(level.height);
                table.insert(table.end(), {static_cast<std::uint32_t>(texels.size()), width, height});
                const auto numbers = std::ptrdiff_t{1} * width * height * channels;
                texels.insert(texels.end(), level.values.begin(), level.values.begin() + numbers);
            }
        }
    }

private:
    std::vector<TexturePtr> textures_;
    std::vector<TextureDescription> descriptions_;
    std::vector<std::array<std::uint32_t, 2>> factors_;
};

}  // namespace

VariationBuffers::VariationBuffers(const std::shared_ptr<gl::Context>& context,
                                   const SpatialVariation& variation)
    : layers_(variation.layers.size()) {
    Textures textures;
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
