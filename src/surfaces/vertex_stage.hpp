// SPDX-License-Identifier: MIT
// Stage whose result has a part for each vertex.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "surfaces/surface_state.hpp"

namespace nicol {

/// Vertices whose part of a result is still valid because a change of the surfaces did not affect them.
class CurrentVertices {
public:
    /// Returns, for each vertex, 1 if its part of the result is current, else 0.
    [[nodiscard]] std::span<const std::uint8_t> current() const noexcept { return current_; }
    [[nodiscard]] bool any_current() const;
    /// Returns whether there is nothing to compute for the blocks of sixteen vertices in which a vertex has
    /// needed[v] != 0: all of their vertices are current under the indices that they had.
    [[nodiscard]] bool suffices(std::span<const std::uint8_t> needed) const;

    /// Returns the index of each current vertex at the last complete() or renumbered(), under which its part
    /// of the result is kept; kNoVertex for other vertices.
    [[nodiscard]] std::span<const std::uint32_t> former() const noexcept { return former_; }
    /// Returns whether any current vertex had another index.
    [[nodiscard]] bool has_renumbered() const noexcept { return has_renumbered_; }
    /// Must be called once the kept parts have been moved to the vertices' indices.
    void renumbered();
    /// Marks all vertices as not current, if their parts cannot be moved.
    void discard();

    /// Marks vertices as current. Must be called once their parts have been computed: the parts of all
    /// vertices, or of those with computed[v] != 0.
    void complete();
    void complete(std::span<const std::uint8_t> computed);
    /// Marks all vertices as not current.
    void reset() noexcept { surfaces_.reset(); }

protected:
    /// Inputs of a vertex's part besides its normal and visibility.
    struct Dependence {
        bool on_places = false;
        bool on_materials = false;
        bool renumbers = false;  ///< whether the caller moves parts of vertices whose index changes
        bool turns = false;      ///< whether a part turns with its vertex's normal
    };

    explicit CurrentVertices(Dependence dependence) : dependence_(dependence) {}
    /// Returns whether there is anything to compute.
    bool update(const SurfaceState& surfaces, bool same_inputs);

private:
    void follow(const SurfaceChange& change);
    void discard_ranges(const std::vector<VertexRange>& ranges);

    Dependence dependence_;
    std::optional<SurfaceVersions> surfaces_;
    std::vector<VertexRange> ranges_;
    std::vector<std::uint8_t> current_;
    std::vector<std::uint32_t> former_;
    bool has_renumbered_ = false;
    bool complete_ = false;
};

/// Stage whose result has a part for each vertex. A part depends on its vertex alone and on inputs that all
/// vertices share.
template <class... Inputs>
class VertexStage : public CurrentVertices {
public:
    using CurrentVertices::Dependence;

    explicit VertexStage(Dependence dependence) : CurrentVertices(dependence) {}

    /// Determines current(). Returns whether there is anything to compute. If so, the caller computes the
    /// parts of the vertices with current()[v] == 0 and calls complete(). If the caller throws instead, the
    /// parts of the other vertices must still be valid.
    bool update(const SurfaceState& surfaces, const Inputs&... inputs) {
        const bool same = inputs_ && *inputs_ == std::tie(inputs...);
        if (!same) inputs_.emplace(inputs...);
        return CurrentVertices::update(surfaces, same);
    }

private:
    std::optional<std::tuple<Inputs...>> inputs_;
};

}  // namespace nicol
