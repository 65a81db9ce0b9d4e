// SPDX-License-Identifier: MIT
// The orders that an image needs for an error that is asked for.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "material/response_power.hpp"
#include "render/geometry.hpp"
#include "render/render.hpp"
#include "scene/scene.hpp"
#include "visibility/visibility_power.hpp"

namespace nicol {

/// Predicts from the spectra of light, materials and visibility what the orders left out are worth: the mean
/// square over all rotations between them, every vertex counted alike. Interpolation between vertices and
/// the sampling of visibility are not in it.
class OrderSelector {
public:
    /// Orders of light above this one are taken for nothing.
    static constexpr int kOrder = 64;
    /// The highest low order that is chosen: where tables of responses still are good to 1e-4.
    static constexpr int kHighestLow = 16;

    struct Orders {
        int low = 0;
        int high = 0;      ///< equals low where there are no high orders
        double error = 0;  ///< of s0, or of s1 and s2 where that is more; relative to the RMS of s0
    };

    /// What is shadowed, and by what; null where nothing is.
    struct Shadows {
        const Visibility* visibility;
        const DirectionSet* directions;
        std::uint64_t revision;
    };

    /// The fastest orders for the factored method with a predicted error of at most `tolerance`, or where
    /// there are none those of the least error. split: whether there may be high orders in that form.
    /// `revision` counts the changes of the geometry and its materials.
    Orders choose(const Scene& scene, const WorldGeometry& geometry, std::uint64_t revision,
                  const Shadows& shadows, double tolerance, bool split);

private:
    static constexpr std::size_t kOutputs = ResponsePower::kOutputs;
    using Spectrum = ResponsePower::Spectrum;

    // What a material has in the mean square of the image's Stokes components, by order of the light.
    struct Share {
        MaterialPtr material;
        ResponsePower power;
        std::array<Spectrum, kOutputs> all;
        std::array<Spectrum, kOutputs> seen;  // without what shadows' edges bring in from other orders
    };
    // Everything that the spectra depend on.
    using Key = std::tuple<const Environment*, std::uint64_t, std::uint64_t>;

    void measure(const Scene& scene, const WorldGeometry& geometry, const Shadows& shadows);
    double error(int low, int high);
    const std::array<double, kOutputs>& missed(std::size_t share, int low, int high);

    std::optional<Key> key_;
    EnvironmentPtr environment_;  // keeps the key's alive
    LightKind kind_ = LightKind::unpolarized;
    std::vector<Share> shares_;
    double mean_square_ = 0;  // of s0
    std::map<std::tuple<std::size_t, int, int>, std::array<double, kOutputs>> missed_;
    std::optional<std::pair<double, bool>> asked_;  // that chosen_ is the answer to
    Orders chosen_;
};

}  // namespace nicol
