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

// The first channel alone where all are equal.
PshVector without_repeats(PshVector light) {
    for (int c = 1; c < light.channels(); ++c) {
        if (!std::ranges::equal(light.channel(c), light.channel(0))) return light;
    }
    PshVector single(light.order(), 1);
    std::ranges::copy(light.channel(0), single.channel(0).begin());
    return single;
}

void suppress_ringing(PshVector& light, double strength) {
    std::vector<double> gains;
    for (int l = 0; l <= light.order(); ++l) {
        const double curvature = l * (l + 1.0);
        gains.push_back(1 / (1 + strength * curvature * curvature));
    }
    scale_orders(light, gains);
}

// The last order with anything in it but rounding.
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

void LightProjection::update(const Scene& scene, const RenderOptions& options, const glm::dmat3& rotation,
                             Statistics& statistics) {
    const Stopwatch watch;
    const int high = options.high_orders == HighOrders::none ? options.order_low : options.order_high;
    const LightKind kind = (options.disabled_optimisations & skip_light_components) != 0
                               ? LightKind::full
                               : light_kind(scene.environment().get());
    const bool same_layout = layout_ && layout_->order() == options.order_low && layout_->kind() == kind;
    if (!projected_ || environment_ != scene.environment() || !same_layout || light_.order() != high ||
        dering_ != options.dering || disabled_optimisations_ != options.disabled_optimisations) {
        projected_ = false;
        scale_ = -1;
        environment_ = scene.environment();
        light_ = environment_ ? environment_->project(high) : PshVector(high, 1);
        if ((options.disabled_optimisations & skip_channels) == 0)
            light_ = without_repeats(std::move(light_));
        dering_ = options.dering;
        suppress_ringing(light_, dering_);
        disabled_optimisations_ = options.disabled_optimisations;
        layout_.emplace(options.order_low, kind);
        last_order_ = (options.disabled_optimisations & skip_orders) != 0
                          ? high
                          : std::max(options.order_low, last_order_of(light_));
        projected_ = true;
        ++statistics.lights_projected;
        statistics.project_ms += watch.milliseconds();
    }
    const bool same_scale = scale_ == scene.light_scale();
    if (same_scale && rotated_by_ == rotation && rotated_from_ == distant_revision_) return;
    const Stopwatch relight_watch;
    if (!same_scale) {
        distant_ = light_;
        for (double& coefficient : distant_.data()) coefficient *= scene.light_scale();
        scale_ = scene.light_scale();
        ++distant_revision_;
    }
    rotated_from_ = 0;
    rotated_ = nicol::rotated(with_order(distant_, options.order_low), rotation);
    ++rotated_revision_;
    rotated_by_ = rotation;
    rotated_from_ = distant_revision_;
    statistics.relight_ms += relight_watch.milliseconds();
}

}  // namespace nicol
