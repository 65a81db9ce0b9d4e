// SPDX-License-Identifier: MIT
#include "visibility/bake_cache.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "files/cache_file.hpp"
#include "files/content_hash.hpp"
#include "material/key.hpp"

namespace nicol {
namespace {

constexpr std::string_view kMagic("NICOLVIS", 8);
// Raise it whenever the same geometry and directions give other bits.
constexpr std::uint32_t kVersion = 1;

template <class T>
std::string hash_of(std::span<const T> numbers) {
    return ContentHash().add(bytes_of(numbers)).text();
}

std::string key_of(const BakeGeometry& geometry, const DirectionSet& directions) {
    return Key("visibility")
        .add("vertices", static_cast<double>(geometry.positions.size()))
        .add("triangles", static_cast<double>(geometry.triangles.size()))
        .add("positions", hash_of(geometry.positions))
        .add("normals", hash_of(geometry.normals))
        .add("corners", hash_of(geometry.triangles))
        .add("directions", hash_of(directions.directions()))
        .text();
}

// What the file holds, if it can be used.
std::optional<Visibility> read(const CacheFile& file, std::size_t directions, std::size_t vertices,
                               const CacheNotice& notice) {
    std::vector<std::uint64_t> bits((directions + 63) / 64 * vertices);
    std::vector<std::uint8_t> open(vertices);
    const CacheFile::Outcome outcome =
        file.read(std::array{writable_bytes_of(std::span(bits)), writable_bytes_of(std::span(open))});
    if (outcome.state == CacheFile::State::complete) {
        return Visibility(directions, std::move(bits), std::move(open));
    }
    if (outcome.state == CacheFile::State::unfit && notice) {
        notice(file.path().string() + ": " + outcome.reason + "; visibility is baked anew");
    }
    return std::nullopt;
}

}  // namespace

Visibility load_or_bake(const BakeGeometry& geometry, const DirectionSet& directions,
                        const std::filesystem::path& folder, const CacheNotice& notice,
                        const BakeProgress& progress, BakeStatistics* statistics) {
    if (folder.empty()) return bake(geometry, directions, progress, statistics);
    const CacheFile file(folder, kMagic, kVersion, key_of(geometry, directions), ".visibility");
    if (std::optional<Visibility> kept = read(file, directions.size(), geometry.positions.size(), notice)) {
        if (statistics != nullptr) *statistics = {.unoccluded = kept->unoccluded_count(), .from_cache = true};
        return std::move(*kept);
    }
    Visibility visibility = bake(geometry, directions, progress, statistics);
    const std::string failure =
        file.write(std::array{bytes_of(visibility.bits()), bytes_of(visibility.unoccluded())});
    if (!failure.empty() && notice) notice(failure);
    return visibility;
}

}  // namespace nicol
