// SPDX-License-Identifier: MIT
#include "shading/focused_light.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/vector_int3_sized.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>

#include "simd/lanes.hpp"

namespace nicol {
namespace {

// Number of neighbours that the disc of a photon reaches to. More of them blur caustics, fewer leave noise.
constexpr std::size_t kNeighbours = 48;

// Cells that a photon reaches into, at most.
constexpr std::size_t kMostCells = 8;
// Sizes of cells that are tried.
constexpr int kCoarsest = 8;

// Smallest cosine between the mean direction of the light and the normal: irradiance is divided by it.
constexpr float kGrazing = 0.05F;

/// Balanced tree of photons by position.
class PhotonTree {
public:
    explicit PhotonTree(std::span<const Photon> photons)
        : photons_(photons), order_(photons.size()), axes_(photons.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        split(0, order_.size());
    }

    // Returns the distance of the farthest of kNeighbours around a photon, itself included.
    [[nodiscard]] float reach(const glm::vec3& from) const {
        Nearest nearest;
        nearest.fill(std::numeric_limits<float>::infinity());
        search(from, 0, order_.size(), nearest);
        return std::sqrt(*std::ranges::find_if(nearest.rbegin(), nearest.rend(),
                                               [](float square) { return std::isfinite(square); }));
    }

private:
    using Nearest = std::array<float, kNeighbours>;  // squared distances, in order

    [[nodiscard]] const glm::vec3& at(std::size_t place) const { return photons_[order_[place]].position; }

    void split(std::size_t first, std::size_t last) {
        if (last - first < 2) return;
        glm::vec3 low = at(first), high = low;
        for (std::size_t i = first; i < last; ++i) {
            low = glm::min(low, at(i));
            high = glm::max(high, at(i));
        }
        const glm::vec3 extent = high - low;
        glm::length_t axis = extent.y > extent.x ? 1 : 0;
        if (extent.z > extent[axis]) axis = 2;
        const std::size_t middle = first + (last - first) / 2;
        const auto begin = order_.begin();
        std::ranges::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                                 begin + static_cast<std::ptrdiff_t>(middle),
                                 begin + static_cast<std::ptrdiff_t>(last), {},
                                 [&](std::uint32_t photon) { return photons_[photon].position[axis]; });
        axes_[middle] = static_cast<std::uint8_t>(axis);
        constexpr std::size_t at_once = 4096;
        if (last - first < at_once) {
            split(first, middle);
            split(middle + 1, last);
        } else {
            tbb::parallel_invoke([&] { split(first, middle); }, [&] { split(middle + 1, last); });
        }
    }

    void search(const glm::vec3& from, std::size_t first, std::size_t last, Nearest& nearest) const {
        if (first == last) return;
        const std::size_t middle = first + (last - first) / 2;
        const glm::vec3 way = from - at(middle);
        const float square = glm::dot(way, way);
        if (square < nearest.back()) {
            std::size_t place = kNeighbours - 1;
            for (; place > 0 && square < nearest[place - 1]; --place) nearest[place] = nearest[place - 1];
            nearest[place] = square;
        }
        if (last - first == 1) return;
        const float across = way[axes_[middle]];
        const bool below = across < 0;
        search(from, below ? first : middle + 1, below ? middle : last, nearest);
        if (across * across < nearest.back())
            search(from, below ? middle + 1 : first, below ? last : middle, nearest);
    }

    std::span<const Photon> photons_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint8_t> axes_;  // axis that the photon at each place splits
};

using Cell = glm::i64vec3;

std::uint64_t cell_key(const Cell& cell, int level) {
    std::uint64_t hash = 0;
    for (const std::int64_t number : {std::int64_t{level}, cell.x, cell.y, cell.z}) {
        hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 32U;
    }
    return hash;
}

// Returns the cell of a point. Cells of points that lie too far from any photon of the level are others'.
Cell cell_of(const glm::vec3& position, int level) {
    constexpr float most = 0x1p62F;
    const glm::vec3 place = glm::floor(position * std::ldexp(1.0F, -level));
    const auto number = [&](float of) {
        return static_cast<std::int64_t>(std::max(-most, std::min(of, most)));
    };
    return {number(place.x), number(place.y), number(place.z)};
}

}  // namespace

FocusedLight::FocusedLight(std::vector<Photon> photons, std::vector<float> powers, std::size_t channels)
    : photons_(std::move(photons)), powers_(std::move(powers)), channels_(channels) {
    find_radii();
    fill_cells();
}

void FocusedLight::find_radii() {
    radii_.resize(photons_.size());
    const PhotonTree tree(photons_);
    tbb::parallel_for(std::size_t{0}, photons_.size(), [&](std::size_t i) {
        const glm::vec3& at = photons_[i].position;
        // Places that many photons share have a size by rounding.
        const float least = 0x1p-20F * std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z), 1e-30F});
        radii_[i] = std::max(least, tree.reach(at));
    });
}

std::vector<FocusedLight::Entry> FocusedLight::entries(int coarser) {
    std::vector<Entry> out;
    out.reserve(kMostCells * photons_.size());
    levels_.clear();
    for (std::uint32_t i = 0; i < photons_.size(); ++i) {
        // The sphere around the photon lies in eight cells of at least twice its radius.
        const int level = std::ilogb(radii_[i]) + 2 + coarser;
        if (std::ranges::find(levels_, level) == levels_.end()) levels_.push_back(level);
        const Cell low = cell_of(photons_[i].position - radii_[i], level);
        const Cell high = cell_of(photons_[i].position + radii_[i], level);
        for (std::int64_t x = low.x; x <= high.x; ++x)
            for (std::int64_t y = low.y; y <= high.y; ++y)
                for (std::int64_t z = low.z; z <= high.z; ++z)
                    out.emplace_back(cell_key({x, y, z}, level), i);
    }
    std::ranges::sort(out);
    return out;
}

void FocusedLight::fill_cells() {
    const auto key = [](const Entry& entry) { return entry.first; };
    std::vector<Entry> all;
    std::size_t cells = 0;
    // Neighbours share cells. Where they do not, coarser cells keep the memory small.
    for (int coarser = 0; coarser < kCoarsest; ++coarser) {
        all = entries(coarser);
        cells = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            cells += i == 0 || key(all[i]) != key(all[i - 1]) ? 1 : 0;
        if (cells <= photons_.size()) break;
    }
    buckets_.assign(std::bit_ceil(2 * cells), {});
    in_cells_.reserve(all.size());
    for (const auto& [of, photon] : all) {
        const auto place = static_cast<std::uint32_t>(in_cells_.size());
        in_cells_.push_back(photon);
        Bucket& bucket = buckets_[place_of(of)];
        if (bucket.first == bucket.last) bucket = {.key = of, .first = place, .last = place};
        bucket.last = place + 1;
    }
}

std::size_t FocusedLight::place_of(std::uint64_t key) const {
    std::size_t place = key & (buckets_.size() - 1);
    while (buckets_[place].first != buckets_[place].last && buckets_[place].key != key)
        place = (place + 1) & (buckets_.size() - 1);
    return place;
}

std::size_t FocusedLight::bytes() const noexcept {
    return photons_.size() * sizeof(Photon) + (powers_.size() + radii_.size()) * sizeof(float) +
           in_cells_.size() * sizeof(std::uint32_t) + buckets_.size() * sizeof(Bucket);
}

std::size_t FocusedLight::most_bytes(std::size_t photons, std::size_t channels) {
    return photons * (sizeof(Photon) + (channels + 1) * sizeof(float) + kMostCells * sizeof(std::uint32_t) +
                      4 * sizeof(Bucket));
}

void FocusedLight::gather(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                          LaneLight& out) const {
    out.points = 0;
    out.components = 1;
    out.irradiance.assign(channels_, {});
    out.distance.value.fill(std::numeric_limits<float>::infinity());
    thread_local std::vector<float> sums;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        put(out.towards, i, normals[i]);
        sums.assign(channels_, 0);
        glm::vec3 towards(0);
        for (const int level : levels_) {
            const Bucket& cell = buckets_[place_of(cell_key(cell_of(positions[i], level), level))];
            for (std::uint32_t k = cell.first; k < cell.last; ++k) {
                const std::uint32_t p = in_cells_[k];
                const Photon& photon = photons_[p];
                const glm::vec3 way = positions[i] - photon.position;
                const float square = radii_[p] * radii_[p];
                const float nearness = 1 - glm::dot(way, way) / square;
                // Other surfaces, such as the second wall of a corner, have photons of their own.
                constexpr float flat = 0.25F, alike = 0.5F;
                if (nearness <= 0 || glm::dot(normals[i], photon.normal) < alike ||
                    std::abs(glm::dot(way, photon.normal)) > flat * radii_[p])
                    continue;
                // Epanechnikov's kernel of a disc: the integral over the disc is 1.
                const float density = 2 * std::numbers::inv_pi_v<float> * nearness / square;
                float sum = 0;
                for (std::size_t c = 0; c < channels_; ++c) {
                    const float irradiance = density * powers_[p * channels_ + c];
                    sums[c] += irradiance;
                    sum += irradiance;
                }
                towards += sum * photon.towards;
            }
        }
        const float length = glm::length(towards);
        if (!(length > 0)) continue;
        towards /= length;
        out.points |= 1U << i;
        put(out.towards, i, towards);
        const float cosine = std::max(kGrazing, glm::dot(towards, normals[i]));
        for (std::size_t c = 0; c < channels_; ++c) out.irradiance[c][0][i] = sums[c] / cosine;
    }
}

}  // namespace nicol
