// SPDX-License-Identifier: MIT
#include "visibility/stepwise_refinement.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <stdexcept>
#include <utility>

#include "geometry/edge_bisection.hpp"
#include "geometry/key_table.hpp"
#include "geometry/largest_coordinate.hpp"
#include "geometry/ray_scene.hpp"
#include "geometry/unit.hpp"
#include "visibility/bake_origins.hpp"
#include "visibility/blocked_lengths.hpp"
#include "visibility/extent_of_triangles.hpp"
#include "visibility/point_tracer.hpp"
#include "visibility/points_in_pixels.hpp"
#include "visibility/ray_start.hpp"

namespace nicol {
namespace {

// Largest number of rounds. Each round halves edges, so that floats run out of precision before the rounds
// end.
constexpr int kRounds = 32;
// Shortest edge in units of the distance between the edge and the start of rays.
constexpr double kOffsets = 64;
// Lengths as fractions of the shadowed region's extent: edges up to kShortest are not split. Edges below
// kShort may err by more, in inverse proportion to their length, because there is less area at them.
constexpr double kShortest = 1.0 / 256;
constexpr double kShort = 1.0 / 32;
// Length of edges, relative to the shortest one that a picture resolves, up to which ends that agree speak
// for the middle. Larger triangles may hide details between their vertices.
constexpr double kAgreeing = 4;
// Smallest share of the tolerance that is asked for where little light arrives.
constexpr double kStrictest = 0.25;

}  // namespace

class StepwiseRefinement::Refiner {
public:
    Refiner(const BakeGeometry& geometry, const DirectionSet& directions, const Visibility& baked,
            const RefineOptions& options, const FormerRefinement* former)
        : geometry_(geometry),
          directions_(directions),
          baked_(baked),
          options_(options),
          tracer_(geometry_, directions, former),
          mesh_(geometry.positions, geometry.triangles),
          normals_(geometry.normals.begin(), geometry.normals.end()),
          in_pixels_(geometry.every_ray ? 0 : options.shortest_edge) {
        std::vector<glm::vec3> units(normals_.size());
        hidden_.resize(normals_.size(), glm::vec4(0));
        tbb::parallel_for(std::size_t{0}, normals_.size(), [&](std::size_t v) {
            units[v] = unit(normals_[v]);
            if (geometry_.needs(v)) hidden_[v] = tracer_.light().at(baked_, v, units[v]);
        });
        shifts_ = bake_origins(geometry, units);
        rows_.reserve(shifts_.size());
        for (std::uint32_t v = 0; v < shifts_.size(); ++v) {
            shifts_[v] -= geometry.positions[v];
            rows_.push_back(v);
            if (geometry_.needs(v)) in_pixels_.add(geometry.positions[v], units[v], v);
        }
    }

    bool step(std::size_t points) {
        if (next_ < fresh_.size()) {
            trace(std::min(points, fresh_.size() - next_));
            return true;
        }
        switch (phase_) {
            case Phase::start:
                find_wanted_lengths();
                phase_ = Phase::follow;
                return true;
            case Phase::follow:
                take_rows();
                if (round_++ < kRounds && split(long_edges())) return true;
                wanted_.clear();
                find_extent();
                round_ = 0;
                phase_ = Phase::suspect;
                return true;
            case Phase::suspect:
                take_rows();
                if (round_++ == kRounds) break;
                find_suspects();
                phase_ = Phase::split;
                return true;
            case Phase::split:
                if (!split(wrong_edges())) break;
                phase_ = Phase::suspect;
                return true;
            case Phase::done:
                return false;
        }
        phase_ = Phase::done;
        return false;
    }

    // Estimates that each queue is half of what is left.
    [[nodiscard]] double fraction() const {
        const double left = std::exp2(-std::max(queues_, 0));
        const std::size_t all = std::max(fresh_.size(), std::size_t{1});
        return 1 - left + left / 2 * static_cast<double>(next_) / static_cast<double>(all);
    }

    [[nodiscard]] Refinement result(BakeStatistics& statistics) {
        statistics.rays += rays_;
        statistics.rays_skipped += skipped_;
        statistics.vertices += traced_;
        Refinement out;
        if (!mesh_.parents().empty())
            out = {.parents = mesh_.parents(),
                   .triangles = mesh_.triangles(),
                   .sources = mesh_.sources(),
                   .visibility = points_.appended_to(baked_, rows_)};
        out.points = std::move(points_);
        return out;
    }

private:
    // Work after the queued points have been traced.
    enum class Phase {
        start,    // find the wanted lengths at hit points of blocked rays
        follow,   // split edges that are longer than wanted
        suspect,  // find edges along which interpolation may err
        split,    // split the edges among them that do
        done,
    };

    struct Wrong {
        double weight;
        EdgeBisection::Edge edge;
        // NOLINTNEXTLINE(modernize-use-nullptr): the zero is the comparison's own
        auto operator<=>(const Wrong&) const = default;
    };

    [[nodiscard]] double length(std::uint32_t a, std::uint32_t b) const {
        return glm::distance(glm::dvec3(mesh_.positions()[a]), glm::dvec3(mesh_.positions()[b]));
    }

    // Returns the length up to which an edge is not split.
    [[nodiscard]] double shortest(std::uint32_t a, std::uint32_t b) const {
        return std::max({shortest_, options_.shortest_edge, kOffsets * std::max(offset(a), offset(b))});
    }

    // Returns the distance between a vertex and the start of rays beside it.
    [[nodiscard]] double offset(std::uint32_t v) const {
        return kRayOffset * static_cast<double>(largest_coordinate(mesh_.positions()[v]));
    }

    [[nodiscard]] bool occluded(std::uint32_t v) const { return hidden_[rows_[v]].x > 0; }

    // Returns whether triangles at a vertex are split.
    [[nodiscard]] bool wants(std::uint32_t v) const {
        return geometry_.needs(v) && (v >= options_.wanted.size() || options_.wanted[v] != 0);
    }

    // Returns whether the interpolation error of an edge is too large.
    [[nodiscard]] bool wrong(double error, std::uint32_t a, std::uint32_t b) const {
        const double here = length(a, b);
        return here > shortest(a, b) && error * std::min(here, short_) > tolerance(a, b) * short_;
    }

    // Returns the tolerance at an edge: relative to the light that arrives there, because a picture of the
    // inside of a box holds no other light.
    [[nodiscard]] double tolerance(std::uint32_t a, std::uint32_t b) const {
        const double hidden = static_cast<double>(hidden_[rows_[a]].x + hidden_[rows_[b]].x) / 2;
        return options_.tolerance * std::clamp(1 - hidden, kStrictest, 1.0);
    }

    // Returns the start of rays beside the middle of two vertices.
    [[nodiscard]] RayStart middle(std::uint32_t a, std::uint32_t b) const {
        return middle_of({normals_[a], shifts_[a]}, {normals_[b], shifts_[b]});
    }

    // Queues the middles of those pairs of vertices that have not been traced yet.
    void queue(std::span<const glm::uvec2> pairs) {
        fresh_.clear();
        next_ = 0;
        ++queues_;
        for (const glm::uvec2& pair : pairs) {
            const std::size_t row = hidden_.size() + fresh_.size();
            if (middles_.try_emplace(pair_key(pair.x, pair.y), row).second) fresh_.push_back(pair);
        }
    }

    // Traces the next points of the queue.
    void trace(std::size_t count) {
        const std::span some = std::span(fresh_).subspan(next_, count);
        Visibility seen(directions_.size(), count);
        std::vector<glm::vec4> hides(count);
        std::vector<glm::vec3> origins(count), normals(count);
        std::vector<std::uint32_t> like(count);  // rows of the first points in the same pixels
        const auto first = static_cast<std::uint32_t>(hidden_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto [a, b] = std::pair(some[i].x, some[i].y);
            const RayStart start = middle(a, b);
            const glm::vec3 position = 0.5F * mesh_.positions()[a] + 0.5F * mesh_.positions()[b];
            normals[i] = unit(start.normal);
            origins[i] = position + start.shift;
            like[i] = in_pixels_.add(position, normals[i], first + i);
        }
        const auto trace_one = [&](std::size_t i, std::span<const Seeing> around) {
            const RayCounts of_point =
                tracer_.trace({.origin = origins[i], .normal = normals[i], .given = given_of(some[i].x)},
                              around, i, seen, hides[i]);
            rays_ += of_point.traced;
            skipped_ += of_point.skipped;
            traced_ += of_point.traced + of_point.skipped > 0 ? 1 : 0;
        };
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            if (like[i] == first + i) trace_one(i, ends_of(some[i].x, some[i].y));
        });
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            if (like[i] == first + i) return;
            const std::size_t here = like[i] - first;
            const Seeing near = like[i] < first ? seeing(like[i]) : Seeing{seen.at(here), normals[here]};
            trace_one(i, std::array{near, seeing(rows_[some[i].x]), seeing(rows_[some[i].y])});
        });
        next_ += count;
        hidden_.insert(hidden_.end(), hides.begin(), hides.end());
        points_.add(origins, normals, seen, hides);
    }

    // Returns a vertex before refinement of the same object.
    [[nodiscard]] std::size_t given_of(std::uint32_t v) const {
        while (v >= baked_.vertices()) v = mesh_.parents()[v - baked_.vertices()].x;
        return v;
    }

    // Returns what the ends of an edge see that rays through its middle may be spared for; nothing for all.
    [[nodiscard]] std::vector<Seeing> ends_of(std::uint32_t a, std::uint32_t b) const {
        if (geometry_.every_ray || !(length(a, b) <= kAgreeing * options_.shortest_edge)) return {};
        // Possible blockers are faster still between ends that nothing hides anything from.
        if (!occluded(a) && !occluded(b)) return {};
        return {seeing(rows_[a]), seeing(rows_[b])};
    }
    // Returns what the point of a row of hidden_ sees.
    [[nodiscard]] Seeing seeing(std::size_t row) const {
        const std::size_t given = baked_.vertices();
        if (row < given) return {.bits = baked_.at(row), .normal = unit(normals_[row])};
        return {.bits = points_.bits(row - given), .normal = points_.normal(row - given)};
    }

    [[nodiscard]] std::size_t row_of_middle(std::uint32_t a, std::uint32_t b) const {
        const std::size_t* row = middles_.find(pair_key(a, b));
        if (row == nullptr) throw std::out_of_range("a pair of vertices has no middle");
        return *row;
    }

    // Finds the pairs of vertices between which interpolation may err by more than the tolerance. If the
    // hidden irradiance is monotonic along an edge, the error is at most half of the change; therefore the
    // middle is traced only if half of the change exceeds the tolerance.
    void find_suspects() {
        suspects_.clear();
        for (const glm::uvec3& t : mesh_.triangles()) {
            for (glm::length_t k = 0; k < 3; ++k) {
                const auto [a, b] = std::pair(t[k], t[(k + 1) % 3]);
                if ((!occluded(a) && !occluded(b)) || !wants(a) || !wants(b)) continue;
                const double change = HiddenLight::magnitude(hidden_[rows_[a]] - hidden_[rows_[b]]);
                if (wrong(change / 2, a, b)) suspects_.emplace_back(a, b);
            }
        }
        queue(suspects_);
    }

    // Returns the edges between suspects along which interpolation errs by more than the tolerance.
    [[nodiscard]] std::vector<Wrong> wrong_edges() const {
        std::vector<Wrong> found;
        for (const glm::uvec2& pair : suspects_) {
            const auto [a, b] = std::pair(pair.x, pair.y);
            const glm::vec4 mean = 0.5F * (hidden_[rows_[a]] + hidden_[rows_[b]]);
            const double error = HiddenLight::magnitude(hidden_[row_of_middle(a, b)] - mean);
            if (wrong(error, a, b))
                found.push_back({.weight = error * length(a, b) * length(a, b), .edge = mesh_.edge(a, b)});
        }
        return found;
    }

    // Splits as many of these edges as the bound on vertices allows, heaviest first, and queues the added
    // vertices. Returns whether any edge was split.
    bool split(std::vector<Wrong> wrong) {
        const std::size_t vertices = mesh_.positions().size();
        if (vertices >= options_.max_vertices) return false;
        const std::size_t room = options_.max_vertices - vertices;
        std::ranges::sort(wrong, std::greater());
        EdgeBisection::Edges edges;
        for (std::size_t count = std::min(wrong.size(), room); count > 0; count /= 2) {
            edges = {};
            for (std::size_t i = 0; i < count; ++i) edges.insert(wrong[i].edge);
            mesh_.close(edges);
            if (mesh_.cost(edges) <= room) break;
            edges = {};
        }
        if (edges.empty()) return false;
        mesh_.split(edges, wanted_);
        queue(std::span(mesh_.parents()).subspan(vertices - baked_.vertices()));
        return true;
    }

    // Completes added vertices once they have been traced.
    void take_rows() {
        for (std::size_t v = rows_.size(); v < mesh_.positions().size(); ++v) {
            const glm::uvec2& ends = mesh_.parents()[v - baked_.vertices()];
            rows_.push_back(row_of_middle(ends.x, ends.y));
            const RayStart start = middle(ends.x, ends.y);
            shifts_.push_back(start.shift);
            normals_.push_back(start.normal);
        }
    }

    void find_wanted_lengths() {
        std::vector<std::uint32_t> some;
        for (std::uint32_t v = 0; v < baked_.vertices(); ++v)
            if (geometry_.needs(v) ? occluded(v) : !baked_.unoccluded(v)) some.push_back(v);
        wanted_ = blocked_lengths(geometry_, directions_, baked_, tracer_.scene(), some, shifts_);
        rays_ += wanted_.size();
    }

    // Returns the longest edges of triangles that are larger than wanted. Forgets the points of triangles
    // that are small enough, whose parts are as well.
    [[nodiscard]] std::vector<Wrong> long_edges() {
        KeyTable<double> longest;
        auto kept = wanted_.begin();
        // Points of a triangle follow each other once an edge has been split. The shortest length decides.
        for (auto next = wanted_.begin(); next != wanted_.end();) {
            const auto first = next;
            float wanted = first->length;
            for (; next != wanted_.end() && next->triangle == first->triangle; ++next)
                wanted = std::min(wanted, next->length);
            const glm::uvec3& t = mesh_.triangles()[first->triangle];
            const double here = std::max({length(t.x, t.y), length(t.y, t.z), length(t.z, t.x)});
            if (here <= std::max(static_cast<double>(wanted), options_.shortest_edge)) continue;
            kept = kept == first ? next : std::copy(first, next, kept);
            if (!wants(t.x) || !wants(t.y) || !wants(t.z)) continue;
            const double least = std::max(
                {static_cast<double>(wanted), shortest(t.x, t.y), shortest(t.y, t.z), shortest(t.z, t.x)});
            if (!(here > least)) continue;
            double& weight = *longest.try_emplace(mesh_.longest(t), 0).first;
            weight = std::max(weight, here * here * here / least);
        }
        wanted_.erase(kept, wanted_.end());
        std::vector<Wrong> wrong;
        wrong.reserve(longest.size());
        longest.for_each([&](EdgeBisection::Edge edge, double weight) {
            wrong.push_back({.weight = weight, .edge = edge});
        });
        return wrong;
    }

    void find_extent() {
        const IsVertex known = [this](std::uint32_t v) { return geometry_.needs(v); };
        const double extent = extent_of_triangles(
            mesh_, [this](std::uint32_t v) { return occluded(v); },
            geometry_.needed.empty() ? nullptr : known);
        shortest_ = kShortest * extent;
        short_ = kShort * extent;
    }

    const BakeGeometry geometry_;
    const DirectionSet& directions_;
    const Visibility& baked_;
    const RefineOptions options_;
    const PointTracer tracer_;
    EdgeBisection mesh_;
    std::vector<WantedLength> wanted_;
    std::vector<glm::vec3> normals_;  // by vertex: interpolated normals, of any length
    std::vector<glm::vec3> shifts_;   // by vertex: shifts from the vertices to the start of their rays
    std::vector<std::size_t> rows_;   // by vertex: rows of hidden_
    // HiddenLight of all given vertices, then of points_.
    std::vector<glm::vec4> hidden_;
    TracedPoints points_;            // middles of edges, whether these are split or not
    KeyTable<std::size_t> middles_;  // row of a pair's middle
    std::atomic<std::uint64_t> rays_ = 0;
    std::atomic<std::uint64_t> skipped_ = 0;
    std::atomic<std::uint64_t> traced_ = 0;  // points that any ray was traced from
    double shortest_ = 0, short_ = 0;
    Phase phase_ = Phase::start;
    int round_ = 0;
    PointsInPixels in_pixels_;       // rows of hidden_
    std::vector<glm::uvec2> fresh_;  // queued points: the middles of these pairs of vertices
    std::size_t next_ = 0;           // first of them that has not been traced
    int queues_ = -1;                // queues before this one
    std::vector<glm::uvec2> suspects_;
};

StepwiseRefinement::StepwiseRefinement(const BakeGeometry& geometry, const DirectionSet& directions,
                                       const Visibility& visibility, const RefineOptions& options,
                                       const FormerRefinement* former)
    : refiner_(std::make_unique<Refiner>(geometry, directions, visibility, options, former)) {}
StepwiseRefinement::~StepwiseRefinement() = default;

bool StepwiseRefinement::step(std::size_t points) {
    return refiner_->step(points);
}

double StepwiseRefinement::fraction() const {
    return refiner_->fraction();
}

Refinement StepwiseRefinement::result(BakeStatistics& statistics) {
    return refiner_->result(statistics);
}

}  // namespace nicol
