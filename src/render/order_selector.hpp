// SPDX-License-Identifier: MIT
// The orders that an image needs for a given error.
#pragma once

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "material/response_power.hpp"
#include "scene/scene.hpp"
#include "stage/options.hpp"
#include "surfaces/surface_state.hpp"
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
        double rms = 0;    ///< of s0, at the vertices, of light of scale 1
    };

    /// The fastest orders for the factored method with a predicted error of at most the options' tolerance,
    /// or where there are none those of the least error; high ones where they are split. A low order above
    /// that of the options needs no more than memory_limit bytes in all, nor than kMostBytes of transfer.
    /// `projected`: the part of the scene's environment that has orders; the error is relative to all of it.
    Orders choose(const Scene& scene, const EnvironmentPtr& projected, const SurfaceState& surfaces,
                  const RenderOptions& options, std::uint64_t memory_limit);

    static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;

private:
    static constexpr std::size_t kOutputs = ResponsePower::kOutputs;
    using Spectrum = ResponsePower::Spectrum;

    // A material, whatever its light and shadows.
    struct Response {
        ResponsePower power;
        // By low and high order, the part of the energy that high orders do not catch.
        std::map<std::pair<int, int>, std::array<double, kOutputs>> missed;
    };

    // What a material has in the mean square of the image's Stokes components, by order of the light.
    struct Share {
        MaterialPtr material;
        Response* response;
        std::array<Spectrum, kOutputs> all;
        std::array<Spectrum, kOutputs> seen;  // without what shadows move here from other orders
        // By low order, of light up to it: what shadows leave to responses above it.
        std::array<std::array<double, kHighestLow + 1>, kOutputs> left;
    };

    [[nodiscard]] Orders cheapest(double tolerance, bool split);
    [[nodiscard]] static int highest_low(const Scene& scene, RenderOptions options,
                                         std::uint64_t memory_limit);
    void measure(const Scene& scene, const EnvironmentPtr& projected, const SurfaceState& surfaces);
    // Adds what a part of the light has, its energies by order, reflected with these energies; `coupling`:
    // VisibilityPower's.
    static void add_part(const Spectrum& light, const Spectrum& power, std::span<const double> coupling,
                         double fraction, std::size_t output, Share& share);
    double error(int low, int high);
    const std::array<double, kOutputs>& missed(const Share& share, int low, int high);

    Stage<EnvironmentPtr, EnvironmentPtr, Version, SurfaceVersions> measuring_;
    LightKind kind_ = LightKind::unpolarized;
    Stage<LightKind, int> responding_;  // kind and channels
    std::map<MaterialPtr, Response> responses_;
    // Energies by order, of each channel: of the light that is projected, and of all light.
    using LightPower = std::vector<std::array<Spectrum, ResponsePower::kParts>>;
    Stage<EnvironmentPtr, EnvironmentPtr> projecting_;
    LightPower light_;
    LightPower all_light_;
    std::vector<Share> shares_;
    double mean_square_ = 0;  // of s0, times `values_`
    double values_ = 0;       // vertices times channels
    // Geometry, light, the options that matter for memory, and its limit.
    Stage<Version, EnvironmentPtr, bool, bool, int, HighOrders, std::uint64_t> limiting_;
    int highest_low_ = kHighestLow;
    Stage<double, bool, int> choosing_;
    Orders chosen_;
};

}  // namespace nicol
