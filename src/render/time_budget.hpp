// SPDX-License-Identifier: MIT
// Choice of what a frame gives up so that it keeps a budget of time.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stage/options.hpp"

namespace nicol {

/// Options that a budget of time may lower.
struct Effort {
    int pixel_samples = 1;
    int light_samples = 16;
    int bsdf_samples = 32;
    ShadeAt shade_at = ShadeAt::automatic;
    double order_slack = 1;  ///< RenderOptions::order_slack

    bool operator==(const Effort&) const = default;
};

/// Times of a frame in milliseconds, without those that no effort changes: project, bake and the light that
/// smooth surfaces focus.
struct FrameTime {
    double whole = 0;
    double relight = 0;      ///< part of whole
    double shade = 0;        ///< part of whole; includes lights
    double lights = 0;       ///< part of shade: samples of local lights and of lobes
    bool at_pixels = false;  ///< whether pixels were shaded
};

/// Returns the efforts of a render, from the options as given, by growing loss, to the cheapest picture. The
/// loss is a judgement: a halving of the samples of a pixel loses 1, of the samples of lights and lobes 1.5,
/// a doubling of the orders' tolerance 2, shading at vertices 3. at_vertices: whether the scene can be shaded
/// at vertices. Only options that are automatic change the place of shading and the orders.
[[nodiscard]] std::vector<Effort> efforts(const RenderOptions& given, bool at_vertices);

/// Returns the whole time of a frame of effort `to`, as estimated from the time of a frame of effort `from`.
[[nodiscard]] double estimated_ms(const Effort& to, const Effort& from, const FrameTime& time,
                                  const ReconstructionFilter& filter);

/// Controller of the effort by measured times. The efforts of a series of frames depend on their times alone.
/// A frame that exceeds the budget by a tenth, twice in succession, leads to the effort of least loss that is
/// expected to keep 0.9 of it, or to the cheapest one. Eight frames in succession below 0.7 of it lead up to
/// such an effort. An effort is expected to take what it took the last time; otherwise, what is estimated,
/// and no less than any known effort with a smaller estimate.
class TimeBudget {
public:
    /// Returns the options of the next frame: the given ones if they have no budget. Begins again with the
    /// given effort if the budget or the efforts differ from those of the last call.
    [[nodiscard]] RenderOptions afford(const RenderOptions& given, bool at_vertices);

    /// Chooses the effort of the next frame by the time of the last one.
    void spend(const FrameTime& time);

    /// Returns the number of efforts of less loss than that of the next frame.
    [[nodiscard]] int steps() const noexcept { return static_cast<int>(at_); }

private:
    // The last two times of an effort. The smaller one counts, so that a single slow frame changes nothing.
    struct Known {
        double last;
        double before;
    };

    [[nodiscard]] double expected(std::size_t effort, const FrameTime& time) const;
    [[nodiscard]] std::size_t affordable(const FrameTime& time) const;
    void go_to(std::size_t effort);

    double budget_ms_ = 0;
    ReconstructionFilter filter_;
    std::vector<Effort> efforts_;
    std::vector<std::optional<Known>> known_;  // of each effort
    std::size_t at_ = 0;
    int calm_ = 0;         // number of frames in succession that leave room
    bool arrived_ = true;  // whether the next frame is the first of its effort
};

}  // namespace nicol
