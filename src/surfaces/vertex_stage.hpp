// SPDX-License-Identifier: MIT
// A stage whose result has a part for each vertex.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "surfaces/surface_state.hpp"

namespace nicol {

/// The vertices whose part of a result is still valid: those that a change of the surfaces left as they were.
class CurrentVertices {
public:
    /// 1 for each vertex whose part of the result is current.
    [[nodiscard]] std::span<const std::uint8_t> current() const noexcept { return current_; }
    [[nodiscard]] bool any_current() const;

    /// To be called once the parts of the vertices that were not current have been computed, all of them or
    /// those with computed[v] != 0.
    void complete();
    void complete(std::span<const std::uint8_t> computed);
    /// No vertex is current.
    void reset() noexcept { surfaces_.reset(); }

protected:
    /// What a vertex' part depends on beside its normal and visibility.
    struct Dependence {
        bool on_places = false;
        bool on_materials = false;
    };

    explicit CurrentVertices(Dependence dependence) : dependence_(dependence) {}
    /// Returns whether there is anything to compute.
    bool update(const SurfaceState& surfaces, bool same_inputs);

private:
    void discard_ranges(const std::vector<VertexRange>& ranges);

    Dependence dependence_;
    std::optional<SurfaceVersions> surfaces_;
    std::vector<VertexRange> ranges_;
    std::vector<std::uint8_t> current_;
    bool complete_ = false;
};

/// As Stage, for results with a part for each vertex that depends on that vertex alone and on inputs that all
/// vertices share.
template <class... Inputs>
class VertexStage : public CurrentVertices {
public:
    using CurrentVertices::Dependence;

    explicit VertexStage(Dependence dependence) : CurrentVertices(dependence) {}

    /// Determines current(). Returns whether there is anything to compute: the caller then computes the parts
    /// of the vertices with current()[v] == 0 and calls complete(). If it throws instead, the parts of the
    /// other vertices must still be valid.
    bool update(const SurfaceState& surfaces, const Inputs&... inputs) {
        const bool same = inputs_ && *inputs_ == std::tie(inputs...);
        if (!same) inputs_.emplace(inputs...);
        return CurrentVertices::update(surfaces, same);
    }

private:
    std::optional<std::tuple<Inputs...>> inputs_;
};

}  // namespace nicol
