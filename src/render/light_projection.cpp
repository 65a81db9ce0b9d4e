// SPDX-License-Identifier: MIT
#include "render/light_projection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "harmonics/rotation.hpp"
#include "progress.hpp"

namespace nicol {
namespace {

// Returns the first channel alone if all channels are equal.
PshVector without_repeats(PshVector light) {
    for (int c = 1; c < light.channels(); ++c) {
        if (!std::ranges::equal(light.channel(c), light.channel(0))) return light;
    }
    PshVector single(light.order(), 1);
    std::ranges::copy(light.channel(0), single.channel(0).begin());
    return single;
}

// Repeats the only channel of a light until it has `channels`.
PshVector with_channels(PshVector light, int channels) {
    if (light.channels() >= channels) return light;
    PshVector out(light.order(), channels);
    for (int c = 0; c < channels; ++c) std::ranges::copy(light.channel(0), out.channel(c).begin());
    return out;
}

void suppress_ringing(PshVector& light, double strength) {
    std::vector<double> gains;
    for (int l = 0; l <= light.order(); ++l) {
        const double curvature = l * (l + 1.0);
        gains.push_back(1 / (1 + strength * curvature * curvature));
    }
    scale_orders(light, gains);
}

// Returns the part of a scale that coefficients are multiplied by: the nearest power of a large step, which
// keeps what they light within the range of single precision, whatever the scale.
double coarse(double scale) {
    constexpr int log2_of_step = 20;
    return scale > 0 ? std::exp2(log2_of_step * std::round(std::log2(scale) / log2_of_step)) : 1;
}

// Returns the last order with coefficients above rounding errors.
int last_order_of(const PshVector& light) {
    const auto largest = [](std::span<const double> coefficients) {
        double most = 0;
        for (const double value : coefficients) most = std::max(most, std::abs(value));
        return most;
    };
    const double threshold = 1e-8 * largest(light.data());
    for (int l = light.order(); l > 0; --l) {
        for (int c = 0; c < light.channels(); ++c) {
            const std::size_t first = 4 * psh_count(l - 1);
            if (largest(light.channel(c).subspan(first, 4 * psh_count(l) - first)) > threshold) return l;
        }
    }
    return 0;
}

}  // namespace

LightKind light_kind(const Environment* light) {
    if (light == nullptr || !light->polarized()) return LightKind::unpolarized;
    return light->circular() ? LightKind::full : LightKind::linear;
}

void LightProjection::update(const EnvironmentPtr& environment, double scale, bool whole,
                             const RenderOptions& options, const LeastLight& least,
                             const glm::dmat3& rotation, KeptProjection& projection, Statistics& statistics) {
    const int low = options.order_low;
    const int high = options.high_orders == HighOrders::none ? low : options.order_high;
    const LightKind kind = (options.disabled_optimisations & skip_light_components) != 0
                               ? LightKind::full
                               : std::max(light_kind(environment.get()), least.kind);
    projecting_.run(environment, low, high, kind, least.channels, options.dering,
                    options.disabled_optimisations, [&] {
                        const Stopwatch watch;
                        project(environment, low, high, kind, least.channels, options, projection);
                        ++statistics.lights_projected;
                        statistics.project_ms += watch.milliseconds();
                    });
    checking_.run(light_.version(), scale, [&] { check_brightness(*light_, scale); });
    const Stopwatch watch;
    const double of_coefficients = whole ? scale : coarse(scale);
    bool changed = scaling_.run(light_.version(), of_coefficients, [&] {
        PshVector& distant = distant_.change();
        distant = *light_;
        for (double& coefficient : distant.data()) coefficient *= of_coefficients;
    });
    factor_ = whole ? 1 : scale / of_coefficients;
    changed |= rotating_.run(distant_.version(), rotation, [&] {
        PshVector next = nicol::rotated(with_order(*distant_, low), rotation);
        const bool same = rotated_kind_ == layout_->kind() && next.order() == rotated_->order() &&
                          std::ranges::equal(next.data(), rotated_->data());
        rotated_kind_ = layout_->kind();
        if (!same) rotated_.change() = std::move(next);
    });
    if (changed) statistics.relight_ms += watch.milliseconds();
}

void LightProjection::project(const EnvironmentPtr& environment, int low, int high, LightKind kind,
                              int channels, const RenderOptions& options, KeptProjection& projection) {
    PshVector& light = light_.change();
    light = projection.project(environment, high);
    if ((options.disabled_optimisations & skip_channels) == 0) light = without_repeats(std::move(light));
    light = with_channels(std::move(light), channels);
    suppress_ringing(light, options.dering);
    layout_.emplace(low, kind);
    last_order_ =
        (options.disabled_optimisations & skip_orders) != 0 ? high : std::max(low, last_order_of(light));
}

}  // namespace nicol
