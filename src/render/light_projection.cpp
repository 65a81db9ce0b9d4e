// SPDX-License-Identifier: MIT
#include "render/light_projection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "harmonics/rotation.hpp"
#include "progress.hpp"

namespace nicol {
namespace {

// Largest difference between a channel and a multiple of another, relative to the largest coefficient, by
// which images of single precision differ from exact multiples.
constexpr double kRounding = 1e-7;

double product(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Returns the ratios of a light's channels to the strongest one, or nothing if they are no multiples of it.
// strongest: its number.
std::vector<double> ratios_of(const PshVector& light, int& strongest) {
    strongest = 0;
    double most = 0;
    for (int c = 0; c < light.channels(); ++c) {
        const double power = product(light.channel(c), light.channel(c));
        if (power <= most) continue;
        most = power;
        strongest = c;
    }
    const std::span<const double> of = light.channel(strongest);
    std::vector<double> ratios(static_cast<std::size_t>(light.channels()), 1.0);
    for (int c = 0; c < light.channels() && most > 0; ++c) {
        const std::span<const double> channel = light.channel(c);
        const double ratio = product(channel, of) / most;
        const double allowed = kRounding * std::abs(of[0]);
        for (std::size_t i = 0; i < channel.size(); ++i)
            if (!(std::abs(channel[i] - ratio * of[i]) <= allowed)) return {};
        ratios[static_cast<std::size_t>(c)] = ratio;
    }
    return ratios;
}

PshVector single_channel(const PshVector& light, int channel) {
    PshVector single(light.order(), 1);
    std::ranges::copy(light.channel(channel), single.channel(0).begin());
    return single;
}

// Repeats the only channel of a light until it has `channels`.
PshVector with_channels(PshVector light, int channels) {
    if (light.channels() >= channels) return light;
    PshVector out(light.order(), channels);
    for (int c = 0; c < channels; ++c) std::ranges::copy(light.channel(0), out.channel(c).begin());
    return out;
}

// Returns the part of a scale that coefficients are multiplied by: the nearest power of a large step, which
// keeps what they light within the range of single precision, whatever the scale.
double coarse(double scale) {
    constexpr int log2_of_step = 20;
    return scale > 0 ? std::exp2(log2_of_step * std::round(std::log2(scale) / log2_of_step)) : 1;
}

// Returns whether a light is the same after a rotation, such as light that is symmetric about its axis.
bool equal_up_to_rounding(std::span<const double> a, std::span<const double> b) {
    constexpr double of_rotation = 1e-12;  // relative to the largest coefficient
    if (a.size() != b.size()) return false;
    double most = 0, difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(b[i]));
        difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    return difference <= of_rotation * most;
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

void suppress_ringing(PshVector& light, double strength) {
    std::vector<double> gains;
    for (int l = 0; l <= light.order(); ++l) {
        const double curvature = l * (l + 1.0);
        gains.push_back(1 / (1 + strength * curvature * curvature));
    }
    scale_orders(light, gains);
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
    const double factor = whole ? 1 : scale / of_coefficients;
    for (std::size_t c = 0; c < factors_.of.size(); ++c)
        factors_.of[c] = static_cast<float>(factor * (ratios_.size() > c ? ratios_[c] : 1.0));
    changed |= rotating_.run(distant_.version(), rotation, [&] {
        PshVector next = nicol::rotated(with_order(*distant_, low), rotation);
        const bool same = rotated_kind_ == layout_->kind() && next.order() == rotated_->order() &&
                          equal_up_to_rounding(next.data(), rotated_->data());
        rotated_kind_ = layout_->kind();
        if (!same) rotated_.change() = std::move(next);
    });
    if (changed) statistics.relight_ms += watch.milliseconds();
}

void LightProjection::project(const EnvironmentPtr& environment, int low, int high, LightKind kind,
                              int channels, const RenderOptions& options, KeptProjection& projection) {
    PshVector& light = light_.change();
    light = projection.project(environment, high);
    ratios_.clear();
    if ((options.disabled_optimisations & skip_channels) == 0 && channels == 1 && light.channels() > 1) {
        int strongest = 0;
        ratios_ = ratios_of(light, strongest);
        if (!ratios_.empty()) light = single_channel(light, strongest);
    }
    light = with_channels(std::move(light), channels);
    suppress_ringing(light, options.dering);
    layout_.emplace(low, kind);
    last_order_ =
        (options.disabled_optimisations & skip_orders) != 0 ? high : std::max(low, last_order_of(light));
}

}  // namespace nicol
