// SPDX-License-Identifier: MIT
#include "transfer/receivers.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <unordered_map>

#include "visibility/hidden_light.hpp"

namespace nicol {
namespace {

// A receiver reaches a vertex if their differences, each relative to its bound, have a sum below 1. Bound of
// the distance, relative to the distance of the surfaces that the receiver sees; and of sqrt(1 - cos(angle))
// of the normals.
constexpr float kReach = 0.3F;
constexpr float kBend = 0.4F;
// Bound of the difference in hidden light, relative to the sum of the larger hidden light and kLittleHidden.
// Bounced light comes from the directions of hidden light. A receiver that sees distant surfaces alone
// reaches far, and some of the vertices that it reaches see much more of them.
constexpr float kUnlike = 0.5F;
constexpr float kLittleHidden = 0.05F;
// Vertices per receiver at least. The reach of receivers grows by a factor, a few times at most, while there
// are fewer.
constexpr std::size_t kVerticesOfReceiver = 4;
constexpr std::size_t kFewReceivers = 2048;  // that may be any share of the vertices
constexpr float kGrowth = 1.5F;
constexpr int kMostGrowths = 4;
// Vertices between two reports of progress.
constexpr std::size_t kTogether = 4096;

/// Properties of a vertex that decide which receivers reach it.
struct Place {
    glm::vec3 position, normal;
    glm::vec4 hidden;  // see HiddenLight
};

float difference_of(const Place& a, const Place& b) {
    const auto difference = static_cast<float>(HiddenLight::magnitude(a.hidden - b.hidden));
    return std::sqrt(std::max(0.0F, 1 - glm::dot(a.normal, b.normal))) / kBend +
           difference / (kUnlike * (std::max(a.hidden.x, b.hidden.x) + kLittleHidden));
}

/// Receivers by the places that they reach.
class ReceiverGrid {
public:
    /// scale: factor of all three bounds.
    explicit ReceiverGrid(float scale) : scale_(scale) {}

    void add(std::uint32_t receiver, const Place& place, float distance) {
        entries_.push_back({receiver, place, 1 / distance});
        const float reach = scale_ * kReach * distance;
        if (!(reach > 0)) return;
        // A cell of twice the reach, so that the sphere around the position lies in eight cells.
        const int level = std::ilogb(reach) + 2;
        if (std::ranges::find(levels_, level) == levels_.end()) levels_.push_back(level);
        const float size = std::ldexp(1.0F, level);
        const Cell low = cell_of(place.position - reach, size, level),
                   high = cell_of(place.position + reach, size, level);
        const auto index = static_cast<std::uint32_t>(entries_.size() - 1);
        for (std::int64_t x = low.x; x <= high.x; ++x)
            for (std::int64_t y = low.y; y <= high.y; ++y)
                for (std::int64_t z = low.z; z <= high.z; ++z) cells_[{x, y, z, level}].push_back(index);
    }

    /// Calls found(receiver, weight) for receivers that reach a point; weight: above 0, falls to 0 where the
    /// reach ends. Receivers are denser and reach less far where other surfaces are near, and the weights
    /// make up for both: near a corner, where density and reach go by the distance from it, the weighted mean
    /// of the receivers' places is about the point itself, so that light which changes evenly is interpolated
    /// right.
    template <class Found>
    void near(const Place& place, const Found& found) const {
        for (const int level : levels_) {
            const auto cell = cells_.find(cell_of(place.position, std::ldexp(1.0F, level), level));
            if (cell == cells_.end()) continue;
            for (const std::uint32_t index : cell->second) {
                const Entry& entry = entries_[index];
                const float distance =
                    glm::length(place.position - entry.place.position) * entry.nearness / kReach;
                if (!(distance < scale_)) continue;  // most entries of a cell
                const float away = (distance + difference_of(place, entry.place)) / scale_;
                if (away < 1) found(entry.receiver, (1 - away) * entry.nearness * entry.nearness);
            }
        }
    }

    [[nodiscard]] bool reaches(const Place& place) const {
        bool any = false;
        near(place, [&](std::uint32_t /*receiver*/, float /*weight*/) { any = true; });
        return any;
    }

private:
    struct Entry {
        std::uint32_t receiver;
        Place place;
        float nearness;  // inverse distance of the surfaces around
    };
    struct Cell {
        std::int64_t x, y, z;
        int level;
        bool operator==(const Cell&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Cell& cell) const {
            auto hash = static_cast<std::uint64_t>(cell.level);
            for (const std::int64_t number : {cell.x, cell.y, cell.z}) {
                hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
                hash ^= hash >> 32U;
            }
            return hash;
        }
    };
    static Cell cell_of(const glm::vec3& position, float size, int level) {
        const auto along = [size](float x) { return static_cast<std::int64_t>(std::floor(x / size)); };
        return {along(position.x), along(position.y), along(position.z), level};
    }

    float scale_;
    std::vector<Entry> entries_;
    std::vector<int> levels_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

// Returns the occluded vertices in an order as if by chance, so that early receivers lie far apart.
std::vector<std::uint32_t> shuffled(const Visibility& visibility) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t v = 0; v < visibility.vertices(); ++v)
        if (!visibility.unoccluded(v)) out.push_back(v);
    const auto key = [](std::uint32_t v) { return (std::uint64_t{v} + 1) * 0x9e3779b97f4a7c15U; };
    std::ranges::sort(out, {}, key);
    return out;
}

/// Places of vertices.
class Places {
public:
    Places(const BakeGeometry& geometry, const LinkSearch& search, const Visibility& visibility,
           std::span<const std::uint32_t> occluded, const BakeProgress& progress)
        : positions_(geometry.positions), normals_(search.normals()), hidden_(normals_.size()) {
        const HiddenLight hidden(search.directions());
        for (std::size_t first = 0; first < occluded.size(); first += kTogether) {
            if (progress) progress(0);
            tbb::parallel_for(first, std::min(first + kTogether, occluded.size()), [&](std::size_t k) {
                const std::uint32_t v = occluded[k];
                hidden_[v] = hidden.at(visibility, v, normals_[v]);
            });
        }
    }

    [[nodiscard]] Place at(std::uint32_t vertex) const {
        return {positions_[vertex], normals_[vertex], hidden_[vertex]};
    }

private:
    std::span<const glm::vec3> positions_;
    std::span<const glm::vec3> normals_;
    std::vector<glm::vec4> hidden_;
};

// Keeps the receivers of largest weight with smooth weights: each is the weight beyond the largest that is
// left out, so that it is 0 where another receiver takes its place.
Receivers::Blend blend_of(std::vector<std::pair<float, std::uint32_t>>& near) {
    constexpr std::size_t most = Receivers::Blend::kMost;
    Receivers::Blend out{};
    std::ranges::sort(near, std::greater());
    const std::size_t count = std::min(most, near.size());
    const float left_out = near.size() > most ? near[most].first : 0;
    float sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += near[k].first - left_out;
    for (std::size_t k = 0; k < count; ++k) {
        out.receivers[k] = near[k].second;
        // Receivers of equal weight share the light.
        out.weights[k] = sum > 0 ? (near[k].first - left_out) / sum : 1 / static_cast<float>(count);
    }
    return out;
}

/// A choice of receivers, in the order of their vertices.
struct Choice {
    struct Receiver {
        std::uint32_t vertex;
        float distance;  // of the surfaces that it sees
        std::vector<SurfaceLink> links;
    };
    std::vector<Receiver> receivers;
    bool complete = true;  // false: there would be more than the limit
};

// former: receivers of a choice with a smaller scale, whose links the new choice takes over.
Choice choose(const Places& places, const LinkSearch& search, std::span<const std::uint32_t> order,
              float scale, std::size_t limit, Choice former, const BakeProgress& progress) {
    constexpr std::size_t least = 64;  // vertices that are examined together
    // Index in former of each of its vertices.
    std::vector<std::uint32_t> found(search.normals().size(), kNoVertex);
    for (std::size_t k = 0; k < former.receivers.size(); ++k)
        found[former.receivers[k].vertex] = static_cast<std::uint32_t>(k);
    Choice out;
    ReceiverGrid grid(scale);
    std::vector<std::vector<SurfaceLink>> links(kTogether);
    std::vector<float> distances(kTogether);
    for (std::size_t first = 0; first < order.size();) {
        if (progress) progress(static_cast<double>(first) / static_cast<double>(order.size()));
        const std::size_t count = std::min({std::max(least, first), kTogether, order.size() - first});
        const auto reached = [&](std::uint32_t v) { return grid.reaches(places.at(v)); };
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
            const std::uint32_t v = order[first + k];
            links[k].clear();
            if (reached(v)) return;
            if (found[v] == kNoVertex) {
                distances[k] = search.find(v, links[k]);
            } else {
                Choice::Receiver& known = former.receivers[found[v]];
                distances[k] = known.distance;
                links[k] = std::move(known.links);
            }
        });
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t v = order[first + k];
            if (links[k].empty() || reached(v)) continue;
            grid.add(0, places.at(v), distances[k]);
            out.receivers.push_back({v, distances[k], std::move(links[k])});
        }
        out.complete = out.receivers.size() <= limit;
        if (!out.complete) return out;
        first += count;
    }
    // Neighbours in the list are neighbours in the mesh, and so use the same memory.
    std::ranges::sort(out.receivers, {}, &Choice::Receiver::vertex);
    return out;
}

}  // namespace

Receivers find_receivers(const BakeGeometry& geometry, const LinkSearch& search, const Visibility& visibility,
                         const BakeProgress& progress) {
    const std::vector<std::uint32_t> order = shuffled(visibility);
    const Places places(geometry, search, visibility, order, progress);
    const std::size_t few = std::max(kFewReceivers, visibility.vertices() / kVerticesOfReceiver);
    float scale = 1;
    Choice choice = choose(places, search, order, scale, few, {}, progress);
    for (int k = 1; !choice.complete; ++k) {
        scale *= kGrowth;
        const std::size_t limit = k < kMostGrowths ? few : visibility.vertices();
        choice = choose(places, search, order, scale, limit, std::move(choice), progress);
    }
    std::size_t links = 0;
    for (std::size_t first = 0; first < choice.receivers.size(); first += kTogether) {
        if (progress) progress(static_cast<double>(first) / static_cast<double>(choice.receivers.size()));
        const std::size_t last = std::min(first + kTogether, choice.receivers.size());
        tbb::parallel_for(first, last, [&](std::size_t k) {
            search.refine(choice.receivers[k].vertex, choice.receivers[k].links);
        });
        for (std::size_t k = first; k < last; ++k) links += choice.receivers[k].links.size();
    }
    Receivers out;
    out.vertices.reserve(choice.receivers.size());
    out.links.reserve(links);
    ReceiverGrid grid(scale);
    std::vector<std::uint32_t> own(visibility.vertices(), kNoVertex);  // receiver of each vertex that is one
    for (Choice::Receiver& chosen : choice.receivers) {
        const auto receiver = static_cast<std::uint32_t>(out.vertices.size());
        own[chosen.vertex] = receiver;
        grid.add(receiver, places.at(chosen.vertex), chosen.distance);
        out.vertices.push_back(chosen.vertex);
        for (SurfaceLink& link : chosen.links) link.receiver = receiver;
        out.links.insert(out.links.end(), chosen.links.begin(), chosen.links.end());
        chosen.links = {};
    }
    out.blends.resize(visibility.vertices());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t k) {
        const std::uint32_t v = order[k];
        std::vector<std::pair<float, std::uint32_t>> near;
        grid.near(places.at(v),
                  [&](std::uint32_t receiver, float weight) { near.emplace_back(weight, receiver); });
        // A receiver beside a touching surface reaches no place but its own.
        if (near.empty() && own[v] != kNoVertex) near.emplace_back(1.0F, own[v]);
        out.blends[v] = blend_of(near);
    });
    return out;
}

}  // namespace nicol
