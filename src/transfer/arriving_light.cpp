// SPDX-License-Identifier: MIT
#include "transfer/arriving_light.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "harmonics/evaluate.hpp"
#include "polarization/stokes.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Sets the layout's numbers of light with this Stokes vector in the theta-phi frame of its propagation.
void project(const LightLayout& layout, const glm::dvec3& propagation, const Stokes& stokes,
             std::span<double> coefficients, std::span<double> numbers) {
    constexpr double weight = 1;
    project_samples(layout.order(), {&propagation, 1}, {&stokes, 1}, {&weight, 1}, coefficients);
    for (std::size_t j = 0; j < numbers.size(); ++j) {
        const auto& [first, second] = layout.terms()[j];
        numbers[j] =
            first.factor * coefficients[first.coefficient] + second.factor * coefficients[second.coefficient];
    }
}

// Adds light times the numbers of its direction.
[[gnu::always_inline]] inline void add_part(const float* of_direction, std::size_t count, float solid_angle,
                                            const Lanes* light, Lanes* numbers, std::size_t step) {
    LaneVector power;
    load(light, power);
    power *= solid_angle;
    for (std::size_t j = 0; j < count; ++j, numbers += step) {
        LaneVector sum;
        load(numbers, sum);
        sum += of_direction[j] * power;
        store(numbers, sum);
    }
}

}  // namespace

ArrivingLight::ArrivingLight(const LightLayout& layout, std::span<const glm::vec3> directions,
                             const Viewpoint& frames)
    : spin_(layout.spin_begin()),
      s3_(layout.kind() == LightKind::unpolarized ? layout.size() : layout.s3_begin()),
      size_(layout.size()),
      stride_(spin_ + 2 * (s3_ - spin_)),
      data_(stride_ * directions.size()) {
    std::vector<double> coefficients(4 * psh_count(layout.order()));
    std::vector<double> numbers(layout.size());
    for (std::size_t d = 0; d < directions.size(); ++d) {
        const glm::dvec3 propagation = -glm::normalize(glm::dvec3(directions[d]));
        const double angle = angle_between(frames.frame(propagation), theta_phi_frame(propagation));
        float* to = data_.data() + d * stride_;
        const auto put = [&](const Stokes& stokes, std::size_t first, std::size_t last) {
            project(layout, propagation, rotated(stokes, angle), coefficients, numbers);
            for (std::size_t j = first; j < last; ++j) *to++ = static_cast<float>(numbers[j]);
        };
        put({1, 0, 0, 0}, 0, spin_);
        put({0, 1, 0, 0}, spin_, s3_);
        put({0, 0, 1, 0}, spin_, s3_);
    }
}

void ArrivingLight::add(std::size_t direction, const SolidAngles& solid_angles, std::size_t components,
                        std::size_t lanes, const Lanes* stokes, Lanes* numbers) const {
    const float* const s0 = data_.data() + direction * stride_;
    const float* const s1 = s0 + spin_;
    const float* const s2 = s1 + (s3_ - spin_);
    for (std::size_t k = 0; k < lanes; ++k) {
        const Lanes* const light = stokes + k;
        dispatch<add_part>(s0, spin_, solid_angles.scalar, light, numbers + k, lanes);
        if (components < 3 || s3_ == spin_) continue;
        Lanes* const spin = numbers + spin_ * lanes + k;
        dispatch<add_part>(s1, s3_ - spin_, solid_angles.polarized, light + lanes, spin, lanes);
        dispatch<add_part>(s2, s3_ - spin_, solid_angles.polarized, light + 2 * lanes, spin, lanes);
        if (components == 4 && size_ > s3_)
            dispatch<add_part>(s0, spin_, solid_angles.polarized, light + 3 * lanes,
                               numbers + s3_ * lanes + k, lanes);
    }
}

void add_mirror_image(const LightLayout& layout, VertexLight& light, std::size_t block) {
    // The mirror keeps s0 of even l + m and e, and s3 of odd l + m because it reverses the handedness. The
    // other numbers of a light and of its image cancel.
    const std::size_t odd = layout.even().size(), spin = layout.spin_begin();
    const std::size_t o = spin + layout.spin().size();
    const std::size_t s3 = layout.kind() == LightKind::unpolarized ? spin : layout.s3_begin();
    const auto kept = [&](std::size_t j) {
        if (j < spin) return j < odd;
        if (j < s3) return j < o;
        return j >= s3 + odd;
    };
    for (int c = 0; c < light.channels(); ++c) {
        const std::span<Lanes> numbers = light.block(block, c);
        for (std::size_t j = 0; j < numbers.size(); ++j) {
            const float factor = kept(j) ? 2.0F : 0.0F;
            for (float& value : numbers[j].value) value *= factor;
        }
    }
}

std::vector<std::size_t> places_in(const LightLayout& part, const LightLayout& whole) {
    std::vector<std::size_t> out;
    const auto add = [&](const std::vector<LightLayout::Harmonic>& of,
                         const std::vector<LightLayout::Harmonic>& in, std::size_t begin) {
        for (const LightLayout::Harmonic& harmonic : of) {
            const auto same = [&](const LightLayout::Harmonic& other) {
                return other.l == harmonic.l && other.m == harmonic.m;
            };
            out.push_back(begin + static_cast<std::size_t>(std::ranges::find_if(in, same) - in.begin()));
        }
    };
    add(part.even(), whole.even(), 0);
    add(part.odd(), whole.odd(), whole.even().size());
    if (part.kind() == LightKind::unpolarized) return out;
    add(part.spin(), whole.spin(), whole.spin_begin());
    add(part.spin(), whole.spin(), whole.spin_begin() + whole.spin().size());
    if (part.kind() == LightKind::linear) return out;
    add(part.even(), whole.even(), whole.s3_begin());
    add(part.odd(), whole.odd(), whole.s3_begin() + whole.even().size());
    return out;
}

}  // namespace nicol
