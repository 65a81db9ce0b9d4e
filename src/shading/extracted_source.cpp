// SPDX-License-Identifier: MIT
#include "shading/extracted_source.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "shading/rotated_light.hpp"

namespace nicol {
namespace {

glm::vec3 of_lane(const LaneVectors& v, std::size_t lane) {
    return {v.x[lane], v.y[lane], v.z[lane]};
}

// Calls visit(light, lane) for light samples at the centres of across x across cells of u and v, row by row;
// across is a multiple of kLanes.
template <class Visit>
void for_samples(const ExtractedLight& extracted_light, std::size_t across, const Visit& visit) {
    const float cell = 1 / static_cast<float>(across);
    LaneLight light;
    for (std::size_t row = 0; row < across; ++row) {
        for (std::size_t first = 0; first < across; first += kLanes) {
            Lanes u, v;
            for (std::size_t i = 0; i < kLanes; ++i) {
                u[i] = (static_cast<float>(first + i) + 0.5F) * cell;
                v[i] = (static_cast<float>(row) + 0.5F) * cell;
            }
            extracted_light.sample(u, v, light);
            for (std::size_t i = 0; i < kLanes; ++i) visit(light, i);
        }
    }
}

// Returns the mean s0 of each channel.
std::vector<double> mean_irradiance(const ExtractedLight& extracted_light, std::size_t across) {
    std::vector<double> means(static_cast<std::size_t>(extracted_light.channels()));
    for_samples(extracted_light, across, [&](const LaneLight& light, std::size_t lane) {
        for (std::size_t c = 0; c < means.size(); ++c)
            means[c] +=
                static_cast<double>(light.irradiance[c][0][lane]) / static_cast<double>(across * across);
    });
    return means;
}

}  // namespace

ExtractedSource::ExtractedSource(std::shared_ptr<const ExtractedLight> extracted_light,
                                 const glm::dmat3& axes, double scale)
    : extracted_light_(std::move(extracted_light)),
      axes_(axes),
      scale_(static_cast<float>(scale)),
      radius_(static_cast<float>(extracted_light_->angular_radius())),
      components_(extracted_light_->circular()    ? 4
                  : extracted_light_->polarized() ? 3
                                                  : 1),
      channels_(static_cast<std::size_t>(extracted_light_->channels())) {
    // The mean over few samples differs slightly from that over many. The samples are scaled so that no light
    // is lost.
    const std::vector<double> few = mean_irradiance(*extracted_light_, kAcross);
    const std::vector<double> many = mean_irradiance(*extracted_light_, 4 * kAcross);
    std::vector<float> scales;
    for (std::size_t c = 0; c < channels_; ++c)
        scales.push_back(static_cast<float>(few[c] > 0 ? scale * many[c] / few[c] : 0));
    brightness_ = static_cast<float>(scale * std::ranges::max(many));
    for_samples(*extracted_light_, kAcross, [&](const LaneLight& light, std::size_t lane) {
        samples_.push_back(
            {.towards = axes_ * of_lane(light.towards, lane), .x = axes_ * of_lane(light.x, lane)});
        for (std::size_t c = 0; c < channels_; ++c)
            for (std::size_t p = 0; p < components_; ++p)
                irradiance_.push_back(scales[c] * light.irradiance[c][p][lane]);
    });
}

void ExtractedSource::sample(const LaneVectors& /*points*/, const Lanes& u, const Lanes& v,
                             LaneLight& out) const {
    out.points = (std::uint32_t{1} << kLanes) - 1;
    out.components = components_;
    out.irradiance.resize(channels_);
    constexpr float across = kAcross;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const auto column = static_cast<std::size_t>(u[i] * across);
        const auto row = static_cast<std::size_t>(v[i] * across);
        const std::size_t index = row * kAcross + column;
        put(out.towards, i, samples_[index].towards);
        put(out.x, i, samples_[index].x);
        out.distance[i] = std::numeric_limits<float>::infinity();
        const float* const values = irradiance_.data() + index * channels_ * components_;
        for (std::size_t c = 0; c < channels_; ++c)
            for (std::size_t p = 0; p < components_; ++p)
                out.irradiance[c][p][i] = values[c * components_ + p];
    }
}

void ExtractedSource::intersect(const LaneVectors& /*points*/, const LaneVectors& directions,
                                LaneLight& out) const {
    out.towards = directions;
    look_up_rotated(axes_, scale_, out, [&] { extracted_light_->intersect(out.towards, out); });
}

}  // namespace nicol
