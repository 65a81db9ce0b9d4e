// SPDX-License-Identifier: MIT
// Selection of the orders that an image needs for a given error.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "material/response_power.hpp"
#include "material/sampled_terms.hpp"
#include "render/kept_projection.hpp"
#include "render/memory_estimate.hpp"
#include "scene/scene.hpp"
#include "specular/split_fit.hpp"
#include "stage/options.hpp"
#include "surfaces/surface_state.hpp"
#include "versioned.hpp"
#include "visibility/visibility_power.hpp"

namespace nicol {

/// Selector of orders, by the predicted error of the omitted orders. The error is predicted from the spectra
/// of light, materials and visibility: the mean square over all rotations between them, with VertexWeights.
/// The prediction does not include interpolation between vertices or the sampling of
/// visibility.
class OrderSelector {
public:
    /// Orders of light above this one count as zero.
    static constexpr int kOrder = 64;
    /// Highest low order that is chosen. Response tables are accurate to 1e-4 up to this order.
    static constexpr int kHighestLow = 16;

    struct Orders {
        int low = 0;
        int high = 0;  ///< equals low if there are no high orders
        /// Predicted error of s0, or of s1 and s2 if it is larger; relative to the RMS of s0.
        double error = 0;
        double rms = 0;  ///< RMS of s0 at the vertices, for light of scale 1
    };

    /// Light and terms of materials that have orders.
    struct Projected {
        EnvironmentPtr light;  ///< part of the scene's environment
        SampledTerms sampled;  ///< terms of materials that have no orders
        bool operator==(const Projected&) const = default;
    };

    /// Returns the fastest orders for the factored method with a predicted error of at most the options'
    /// tolerance times order_slack, or better ones with which a frame takes about as long. If there are none,
    /// returns those with the least product of squared error and a frame's time among orders that err at most
    /// half as much again as the best ones. High orders are chosen if their form is split. A low order above
    /// the options' needs no more than memory_limit bytes in all, and no more than kMostBytes of transfer.
    /// The error is relative to the reflection of the whole environment by whole materials. settled: whether
    /// the visibility is final. Otherwise a change of vertices or visibility alone changes no orders, so that
    /// pictures do not change between two choices.
    Orders choose(const Scene& scene, const Projected& projected, const SurfaceState& surfaces, bool settled,
                  const RenderOptions& options, std::uint64_t memory_limit, KeptProjection& projection);

    /// Computes what choose() needs of the light and of the instances' materials, which depends on no
    /// surfaces: beside a bake.
    void prepare(const Scene& scene, const Projected& projected, KeptProjection& projection);

    static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;

private:
    static constexpr std::size_t kOutputs = ResponsePower::kOutputs;
    using Spectrum = ResponsePower::Spectrum;

    // Response of a material, independent of light and shadows.
    struct Response {
        ResponsePower whole;
        MaterialPtr projected;  // terms that have orders
        ResponsePower power;    // of these terms
        // Fraction of the energy that high orders do not catch, by low and high order.
        std::map<std::pair<int, int>, std::array<double, kOutputs>> missed;
    };

    // Share of a material in the mean square of the image's Stokes components, by order of the light.
    struct Share {
        Response* response;
        std::array<Spectrum, kOutputs> all;
        std::array<Spectrum, kOutputs> seen;  // without the energy that shadows move here from other orders
        // Energy that shadows move from light up to a low order to responses above this order, by low order.
        std::array<std::array<double, kHighestLow + 1>, kOutputs> left;
    };

    [[nodiscard]] Orders cheapest(double tolerance, bool split, bool local_lights);
    [[nodiscard]] static int highest_low(const Scene& scene, RenderOptions options,
                                         std::uint64_t memory_limit);
    void measure(const Scene& scene, const Projected& projected, const SurfaceState& surfaces,
                 KeptProjection& projection);
    // Finds the weights of materials and the effect of shadows on them, which no light changes.
    void measure_shadows(const SurfaceState& surfaces);
    // Updates the energies of the light, and forgets responses that were computed for another kind of light.
    void project(const Scene& scene, const Projected& projected, KeptProjection& projection);
    [[nodiscard]] Response& response_of(const MaterialPtr& material, const Projected& projected,
                                        int channels);
    // Forgets integrals of terms that no material has. Materials that differ in their weights alone share
    // these integrals, so that a new reflectance needs none.
    void forget_terms();
    // Adds a part of the light to a share. light: its energies by order. power: energies of its reflection by
    // order. coupling: of VisibilityPower.
    static void add_part(const Spectrum& light, const Spectrum& power, std::span<const double> coupling,
                         double fraction, std::size_t output, Share& share);
    // Fits of high orders: a perfect fit misses no energy, so that its error is a lower bound.
    enum class Fit { perfect, made };
    double error(int low, int high, Fit fit);
    const std::array<double, kOutputs>& missed(const Share& share, int low, int high);
    // Data that the fits of all materials share, for a low and a high order.
    struct SharedFit {
        SharedFit(int low, int high) : basis(low, high) {}
        SplitBasis basis;
        std::map<std::string, KnownMoments> known;  // by terms_key(), of the columns for kind_
    };

    Stage<EnvironmentPtr, Projected, Version, SurfaceVersions> measuring_;
    SurfaceVersions measured_;              // versions of the last measuring_
    std::vector<OrderCoupling> couplings_;  // spin 0, spin 2
    // Weight of a material's vertices, and the effect of shadows on its responses, see VisibilityPower.
    struct Shadowed {
        double weight = 0;
        double fraction = 1;
        std::array<std::vector<double>, 2> couplings;  // spin 0, spin 2
        std::vector<std::uint32_t> sample;             // vertices at which shadows were measured
    };
    Stage<Version, SurfaceVersions> shadowing_;  // versions of materials and surfaces
    std::map<MaterialPtr, Shadowed> shadowed_;
    SurfaceVersions shadowed_versions_;  // surfaces of shadowed_
    LightKind kind_ = LightKind::unpolarized;
    Stage<LightKind, SampledTerms, int> responding_;  // kind, sampled terms, channels
    std::map<MaterialPtr, Response> responses_;
    ResponsePower::KnownTerms known_terms_;
    std::map<std::pair<int, int>, SharedFit> fits_;  // by low and high order
    // Energies by order, of each channel: of the projected light, and of all light.
    using LightPower = std::vector<std::array<Spectrum, ResponsePower::kParts>>;
    Stage<EnvironmentPtr, EnvironmentPtr> projecting_;
    LightPower light_;
    LightPower all_light_;
    std::vector<Share> shares_;
    double mean_square_ = 0;                       // mean square of s0, times `values_`
    double values_ = 0;                            // weights of vertices times channels
    Stage<MemoryInputs, std::uint64_t> limiting_;  // and the memory limit
    int highest_low_ = kHighestLow;
    Stage<double, bool, bool, int> choosing_;  // tolerance, split, local lights, highest_low_
    Orders chosen_;
};

}  // namespace nicol
