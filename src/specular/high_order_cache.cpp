// SPDX-License-Identifier: MIT
#include "specular/high_order_cache.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "files/cache_file.hpp"
#include "material/key.hpp"
#include "material/response_table.hpp"

namespace nicol {
namespace {

constexpr std::string_view kMagic("NICOLHO\0", 8);
// Version of the files; raise it whenever the numbers of any fit change.
constexpr std::uint32_t kVersion = 3;

std::string key_of(const std::string& content, int l_low, int l_high, int channels) {
    return Key(content)
        .add("low", l_low)
        .add("high", l_high)
        .add("channels", channels)
        .add("angles", HighOrderFactors::kAngles)
        .add("elements", HighOrderFactors::kElements)
        .text();
}

}  // namespace

HighOrderFactors load_or_fit(const Material& material, const SplitBasis& basis, int channels,
                             KnownMoments* known, const std::filesystem::path& folder,
                             const CacheNotice& notice) {
    const std::string content = folder.empty() ? std::string() : material.content_key();
    if (content.empty()) return {material, basis, channels, known};
    const int factor_channels = ResponseTable::channels_for(material, channels);
    const CacheFile file(folder, kMagic, kVersion,
                         key_of(content, basis.l_low(), basis.l_high(), factor_channels), ".lobes");
    std::array<std::int32_t, 3> stencil{};  // central lobe, outer lobe, base
    std::vector<float> data(material.pairings() * HighOrderFactors::kElements * HighOrderFactors::kAngles *
                            static_cast<std::size_t>(factor_channels));
    CacheFile::Outcome outcome = file.read(
        std::array{writable_bytes_of(std::span<std::int32_t>(stencil)), writable_bytes_of(std::span(data))});
    if (outcome.state == CacheFile::State::complete) {
        std::optional<HighOrderFactors> kept = HighOrderFactors::stored(
            factor_channels, material.pairings(), stencil[0], stencil[1], stencil[2] != 0, std::move(data));
        if (kept) return *std::move(kept);
        outcome = {CacheFile::State::unfit, "is damaged"};
    }
    if (outcome.state == CacheFile::State::unfit && notice) {
        notice(file.path().string() + ": " + outcome.reason + "; the factors are fitted anew");
    }
    HighOrderFactors factors(material, basis, channels, known);
    stencil = {factors.central_lobe(), factors.outer_lobe(), factors.has_base() ? 1 : 0};
    const std::string failure =
        file.write(std::array{bytes_of(std::span<const std::int32_t>(stencil)), bytes_of(factors.data())});
    if (!failure.empty() && notice) notice(failure);
    return factors;
}

}  // namespace nicol
