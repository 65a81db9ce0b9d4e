// SPDX-License-Identifier: MIT
#include "visibility/bake_cache.hpp"

#include <algorithm>
#include <array>
#include <cstring>
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
// Version of visibility files; raise it whenever equal geometry and directions give different bits.
constexpr std::uint32_t kVersion = 4;
// Magic and version of refinement files; raise the version whenever equal input gives a different refinement.
constexpr std::string_view kRefinementMagic("NICOLREF", 8);
constexpr std::uint32_t kRefinementVersion = 7;

template <class T>
std::string hash_of(std::span<const T> numbers) {
    return ContentHash().add(bytes_of(numbers)).text();
}

Key key_of(const char* what, const BakeGeometry& geometry, const DirectionSet& directions) {
    Key key(what);
    if (!geometry.blocking.empty()) key.add("blocking", hash_of(geometry.blocking));
    if (geometry.glass)
        key.add("glass", geometry.glass->key).add("of glass", hash_of(std::span(geometry.glass->triangles)));
    if (!geometry.needed.empty()) key.add("needed", hash_of(geometry.needed));
    if (!geometry.like.empty()) key.add("like", hash_of(geometry.like));
    return key.add("vertices", static_cast<double>(geometry.positions.size()))
        .add("triangles", static_cast<double>(geometry.triangles.size()))
        .add("positions", hash_of(geometry.positions))
        .add("normals", hash_of(geometry.normals))
        .add("corners", hash_of(geometry.triangles))
        .add("directions", hash_of(directions.directions()));
}

// Returns the visibility that the file holds, or nothing if the file cannot be used.
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

// Counts at the start of a refinement file: added vertices, triangles. The arrays follow one after the other.
using Counts = std::array<std::uint64_t, 2>;

// Calls part(array) for each array of a refinement except the arrays of its visibility.
template <class Part>
void for_each_array(auto& refinement, Part&& part) {
    part(std::span(refinement.parents));
    part(std::span(refinement.triangles));
    part(std::span(refinement.sources));
}

std::optional<Refinement> decode(std::span<const unsigned char> bytes, const Visibility& given) {
    Counts counts{};
    if (bytes.size() < sizeof counts) return std::nullopt;
    std::memcpy(counts.data(), bytes.data(), sizeof counts);
    const std::size_t words = given.bits().size() / given.vertices();
    const std::uint64_t each = sizeof(glm::uvec2) + words * sizeof(std::uint64_t) + 1;
    const std::uint64_t of_triangle = sizeof(glm::uvec3) + sizeof(std::uint32_t);
    bytes = bytes.subspan(sizeof counts);
    if (counts[0] > bytes.size() || counts[1] > bytes.size() ||
        bytes.size() != counts[0] * each + counts[1] * of_triangle) {
        return std::nullopt;
    }
    const auto take = [&bytes](auto to) {
        const std::span<unsigned char> part = writable_bytes_of(to);
        std::ranges::copy(bytes.first(part.size()), part.begin());
        bytes = bytes.subspan(part.size());
    };
    Refinement out;
    out.parents.resize(counts[0]);
    out.triangles.resize(counts[1]);
    out.sources.resize(counts[1]);
    for_each_array(out, take);
    const std::size_t vertices = given.vertices() + counts[0];
    std::vector<std::uint64_t> bits(words * vertices);
    std::vector<std::uint8_t> open(vertices);
    std::ranges::copy(given.bits(), bits.begin());
    std::ranges::copy(given.unoccluded(), open.begin());
    take(std::span(bits).last(counts[0] * words));
    take(std::span(open).last(counts[0]));
    out.visibility = Visibility(given.directions(), std::move(bits), std::move(open));
    return out;
}

std::string write(const CacheFile& file, const Refinement& refinement, const Visibility& given) {
    const Counts counts{refinement.parents.size(), refinement.triangles.size()};
    std::vector<std::span<const unsigned char>> parts{bytes_of(std::span<const std::uint64_t>(counts))};
    for_each_array(refinement, [&parts](auto array) { parts.push_back(bytes_of(array)); });
    if (!refinement.parents.empty()) {
        parts.push_back(bytes_of(refinement.visibility.bits().subspan(given.bits().size())));
        parts.push_back(bytes_of(refinement.visibility.unoccluded().subspan(given.vertices())));
    }
    return file.write(parts);
}

}  // namespace

Visibility load_or_bake(const BakeGeometry& geometry, const DirectionSet& directions,
                        const std::filesystem::path& folder, const CacheNotice& notice,
                        const BakeProgress& progress, BakeStatistics* statistics) {
    // Visibility with an alpha mask is not cached, because the key of the file does not cover the mask.
    if (folder.empty() || geometry.present) return bake(geometry, directions, progress, statistics);
    const CacheFile file(folder, kMagic, kVersion, key_of("visibility", geometry, directions).text(),
                         ".visibility");
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

Refinement load_or_refine(const BakeGeometry& geometry, const DirectionSet& directions,
                          const Visibility& visibility, const RefineOptions& options,
                          const std::filesystem::path& folder, const CacheNotice& notice,
                          const BakeProgress& progress, BakeStatistics& statistics) {
    if (folder.empty() || geometry.present || visibility.unoccluded_count() == visibility.vertices())
        return refine(geometry, directions, visibility, options, progress, statistics);
    Key key = key_of("refinement", geometry, directions)
                  .add("tolerance", options.tolerance)
                  .add("max_vertices", static_cast<double>(options.max_vertices))
                  .add("shortest_edge", options.shortest_edge);
    if (!options.wanted.empty()) key.add("wanted", hash_of(options.wanted));
    const CacheFile file(folder, kRefinementMagic, kRefinementVersion, key.text(), ".refinement");
    std::vector<unsigned char> bytes;
    const CacheFile::Outcome outcome = file.read(bytes, std::uint64_t{1} << 40);
    if (outcome.state == CacheFile::State::complete) {
        if (std::optional<Refinement> kept = decode(bytes, visibility)) return std::move(*kept);
    } else if (outcome.state == CacheFile::State::unfit && notice) {
        notice(file.path().string() + ": " + outcome.reason + "; triangles are refined anew");
    }
    Refinement refinement = refine(geometry, directions, visibility, options, progress, statistics);
    const std::string failure = write(file, refinement, visibility);
    if (!failure.empty() && notice) notice(failure);
    return refinement;
}

}  // namespace nicol
