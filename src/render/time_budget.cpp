// SPDX-License-Identifier: MIT
#include "render/time_budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "draw/sample_pattern.hpp"
#include "scene/path_depth.hpp"

namespace nicol {
namespace {

constexpr double kTooLong = 1.1;  // of the budget: a longer frame lowers the effort
constexpr double kWanted = 0.9;   // of the budget: the most that a chosen effort is expected to take
constexpr double kCalm = 0.7;     // of the budget: frames below it may raise the effort
constexpr int kCalmFrames = 8;
// Factor by which a known time shrinks with each frame at another effort. What took too long is tried again
// when the scene may have changed: twice the budget after about 800 frames.
constexpr double kForgetting = 0.999;

constexpr int kFewestSamples = 4;  // of lights and lobes
constexpr int kMostDoublings = 3;  // of the orders' tolerance

// Rough relative times. They only say which effort is tried first.
constexpr double kAtVertices = 0.4;  // shading at vertices over shading at pixels
constexpr double kCoarser = 0.5;     // relight and shade with the orders of twice the tolerance
constexpr double kFiner = 4;         // the same of half the tolerance, at most
constexpr double kSample = 0.25;     // one more sample that is drawn together with others

int fewer(int pixel_samples, const ReconstructionFilter& filter) {
    const int half = pixel_samples / 2;
    if (filter.kind != ReconstructionFilter::Kind::box) return half;
    if (pixel_samples > 8) return std::max(half, 8);
    return pixel_samples > 4 ? 4 : 1;
}

int part_of(int samples, int part) {
    return std::max(samples / part, std::min(samples, kFewestSamples));
}

double halvings(int most, int samples) {
    return samples > 0 ? std::log2(static_cast<double>(most) / samples) : 0;
}

double loss(const Effort& effort, const Effort& whole) {
    return halvings(whole.pixel_samples, effort.pixel_samples) +
           1.5 * std::max(halvings(whole.light_samples, effort.light_samples),
                          halvings(whole.bsdf_samples, effort.bsdf_samples)) +
           2 * std::log2(effort.order_slack / whole.order_slack) +
           (effort.shade_at != whole.shade_at ? 3 : 0);
}

double images(int pixel_samples, const ReconstructionFilter& filter) {
    return drawn_one_by_one(pixel_samples, filter) ? pixel_samples : 1 + kSample * (pixel_samples - 1);
}

}  // namespace

std::vector<Effort> efforts(const RenderOptions& given, bool at_vertices) {
    std::vector<int> pixel_samples{given.pixel_samples};
    while (pixel_samples.back() > 1) pixel_samples.push_back(fewer(pixel_samples.back(), given.filter));
    std::vector<ShadeAt> places{given.shade_at};
    // Bounces may keep other light for vertices than for pixels, whose bake would take longer than it saves.
    const bool bounces = given.max_depth > kDirectLightDepth;
    if (at_vertices && !bounces && given.shade_at == ShadeAt::automatic) places.push_back(ShadeAt::vertices);
    const int doublings = given.choose_orders && given.tolerance > 0 ? kMostDoublings : 0;

    std::vector<Effort> out;
    for (const int samples : pixel_samples) {
        for (const int part : {1, 2, 4}) {
            for (const ShadeAt place : places) {
                for (int doubling = 0; doubling <= doublings; ++doubling) {
                    const Effort effort{.pixel_samples = samples,
                                        .light_samples = part_of(given.light_samples, part),
                                        .bsdf_samples = part_of(given.bsdf_samples, part),
                                        .shade_at = place,
                                        .order_slack = std::ldexp(given.order_slack, doubling)};
                    if (std::ranges::find(out, effort) == out.end()) out.push_back(effort);
                }
            }
        }
    }
    const Effort whole = out.front();
    std::ranges::stable_sort(out, {}, [&](const Effort& effort) { return loss(effort, whole); });
    return out;
}

double estimated_ms(const Effort& to, const Effort& from, const FrameTime& time,
                    const ReconstructionFilter& filter) {
    const double doublings = std::log2(to.order_slack / from.order_slack);
    const double orders = doublings > 0 ? std::pow(kCoarser, doublings) : std::pow(kFiner, -doublings);
    const bool pixels = to.shade_at != ShadeAt::vertices && (time.at_pixels || to.shade_at != from.shade_at);
    const double place = pixels == time.at_pixels ? 1 : pixels ? 1 / kAtVertices : kAtVertices;
    const double light_samples = static_cast<double>(to.light_samples) / from.light_samples;
    const double lobe_samples =
        from.bsdf_samples > 0 ? static_cast<double>(to.bsdf_samples) / from.bsdf_samples : 1;
    const double lights = time.lights * std::max(light_samples, lobe_samples);
    const double shade = (time.shade - time.lights) * orders;
    const double drawn = time.whole - time.relight - time.shade;
    return time.relight * orders + ((lights + shade) * place + drawn) * images(to.pixel_samples, filter) /
                                       images(from.pixel_samples, filter);
}

RenderOptions TimeBudget::afford(const RenderOptions& given, bool at_vertices) {
    std::vector<Effort> list;
    if (given.time_budget_ms > 0) list = efforts(given, at_vertices);
    if (given.time_budget_ms != budget_ms_ || list != efforts_) {
        budget_ms_ = given.time_budget_ms;
        efforts_ = std::move(list);
        known_.assign(efforts_.size(), {});
        at_ = 0;
        calm_ = 0;
        arrived_ = true;
    }
    filter_ = given.filter;
    if (efforts_.empty()) return given;
    const Effort& effort = efforts_[at_];
    RenderOptions out = given;
    out.pixel_samples = effort.pixel_samples;
    out.light_samples = effort.light_samples;
    out.bsdf_samples = effort.bsdf_samples;
    out.shade_at = effort.shade_at;
    out.order_slack = effort.order_slack;
    return out;
}

void TimeBudget::spend(const FrameTime& time) {
    if (efforts_.empty()) return;
    const bool arrived = std::exchange(arrived_, false);
    for (std::size_t e = 0; e < known_.size(); ++e) {
        if (e == at_ || !known_[e]) continue;
        known_[e]->last *= kForgetting;
        known_[e]->before *= kForgetting;
    }
    // The first frame of an effort also makes what later ones keep.
    if (arrived && time.whole > kTooLong * budget_ms_) return;
    std::optional<Known>& known = known_[at_];
    known =
        Known{.last = time.whole, .before = known ? known->last : std::numeric_limits<double>::infinity()};
    calm_ = time.whole <= kCalm * budget_ms_ ? calm_ + 1 : 0;

    const bool too_long = std::min(known->last, known->before) > kTooLong * budget_ms_;
    if (!too_long && calm_ < kCalmFrames) return;
    calm_ = 0;
    const std::size_t best = affordable(time);
    if (too_long || best < at_) go_to(best);
}

std::size_t TimeBudget::affordable(const FrameTime& time) const {
    for (std::size_t e = 0; e < efforts_.size(); ++e)
        if (expected(e, time) <= kWanted * budget_ms_) return e;
    return efforts_.size() - 1;
}

double TimeBudget::expected(std::size_t effort, const FrameTime& time) const {
    const auto estimate = [&](std::size_t e) {
        return estimated_ms(efforts_[e], efforts_[at_], time, filter_);
    };
    const auto taken = [](const Known& known) { return std::min(known.last, known.before); };
    if (known_[effort]) return taken(*known_[effort]);
    const double estimated = estimate(effort);
    double out = estimated;
    for (std::size_t e = 0; e < known_.size(); ++e)
        if (known_[e] && estimate(e) <= estimated) out = std::max(out, taken(*known_[e]));
    return out;
}

void TimeBudget::go_to(std::size_t effort) {
    if (effort == at_) return;
    at_ = effort;
    calm_ = 0;
    arrived_ = true;
}

}  // namespace nicol
