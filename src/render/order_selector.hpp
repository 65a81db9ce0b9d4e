// SPDX-License-Identifier: MIT
// The orders that an image needs for a given error.
#pragma once

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "material/response_power.hpp"
#include "render/surface_state.hpp"
#include "scene/scene.hpp"
#include "versioned.hpp"
#include "visibility/visibility_power.hpp"

namespace nicol {

/// Predicts the error of omitted orders from the spectra of light, materials and visibility: the mean square
/// over all rotations between them, with equal weights for all vertices. It does not include interpolation
/// between vertices or the sampling of visibility.
class OrderSelector {
public:
    /// Orders of light above this one count as zero.
    static constexpr int kOrder = 64;
    /// The highest low order that is chosen: up to which response tables are accurate to 1e-4.
    static constexpr int kHighestLow = 16;

    struct Orders {
        int low = 0;
        int high = 0;      ///< equals low where there are no high orders
        double error = 0;  ///< of s0, or of s1 and s2 where that is more; relative to the RMS of s0
    };

    /// The fastest orders for the factored method with a predicted error of at most `tolerance`, or where
    /// there are none those of the least error. split: whether there may be high orders in that form.
    Orders choose(const Scene& scene, const SurfaceState& surfaces, double tolerance, bool split);

private:
    static constexpr std::size_t kOutputs = ResponsePower::kOutputs;
    using Spectrum = ResponsePower::Spectrum;

    // What a material has in the mean square of the image's Stokes components, by order of the light.
    struct Share {
        MaterialPtr material;
        ResponsePower power;
        std::array<Spectrum, kOutputs> all;
        std::array<Spectrum, kOutputs> seen;  // without what shadows move here from other orders
    };

    [[nodiscard]] Orders cheapest(double tolerance, bool split);
    void measure(const Scene& scene, const SurfaceState& surfaces);
    double error(int low, int high);
    const std::array<double, kOutputs>& missed(std::size_t share, int low, int high);

    Stage<EnvironmentPtr, Version, SurfaceVersions> measuring_;
    LightKind kind_ = LightKind::unpolarized;
    std::vector<Share> shares_;
    double mean_square_ = 0;  // of s0
    std::map<std::tuple<std::size_t, int, int>, std::array<double, kOutputs>> missed_;
    Stage<double, bool> choosing_;
    Orders chosen_;
};

}  // namespace nicol
