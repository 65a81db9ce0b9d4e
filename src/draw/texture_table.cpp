// SPDX-License-Identifier: MIT
#include "draw/texture_table.hpp"

#include <algorithm>
#include <bit>

namespace nicol {

std::uint32_t TextureTable::number_of(const TexturePtr& texture) {
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

std::size_t TextureTable::texels() const {
    std::size_t sum = 0;
    for (std::size_t t = 0; t < count(); ++t)
        for (const TextureImage& level : descriptions_[t].levels)
            sum += static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) *
                   static_cast<std::size_t>(textures_[t]->channels());
    return sum;
}

void TextureTable::write(std::size_t begin, std::vector<std::uint32_t>& table,
                         std::vector<float>& texels) const {
    const auto word = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    table.resize(begin + kWords * count());
    texels.reserve(texels.size() + this->texels());
    for (std::size_t t = 0; t < count(); ++t) {
        const TextureDescription& from = descriptions_[t];
        const std::size_t at = begin + kWords * t;
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

}  // namespace nicol
