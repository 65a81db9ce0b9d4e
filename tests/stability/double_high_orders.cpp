// SPDX-License-Identifier: MIT
// Lookups of high orders in double precision.
#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "harmonics/order_gains.hpp"
#include "harmonics/scalar_harmonics.hpp"
#include "specular/look_up.hpp"
#include "stability/double_transfer.hpp"

namespace nicol::test {
namespace {

double mix(double low, double high, double fraction) {
    return low + fraction * (high - low);
}

// The stored factor elements of one pairing, interpolated between two angles.
class Elements {
public:
    Elements(const HighOrderFactors& factors, int channel, std::size_t pairing, double cosine) {
        const double x = std::clamp(cosine, 0.0, 1.0) * (HighOrderFactors::kAngles - 1);
        const int angle = std::min(static_cast<int>(x), HighOrderFactors::kAngles - 2);
        const auto at = [&](int a, std::size_t e) {
            const int own = factors.channels() == 1 ? 0 : channel;
            const auto row = static_cast<std::size_t>(a * factors.channels() + own);
            const std::size_t first = (row * factors.pairings() + pairing) * HighOrderFactors::kElements;
            return static_cast<double>(factors.data()[first + e]);
        };
        for (std::size_t e = 0; e < elements_.size(); ++e)
            elements_[e] = mix(at(angle, e), at(angle + 1, e), x - angle);
    }
    // Applies the elements of tap 0 to 3: central, up, down and sum.
    [[nodiscard]] Stokes even(std::size_t tap, const Stokes& s) const {
        const double* a = &elements_[2 * tap];
        const double* b = &elements_[HighOrderFactors::kUnpolarized + 6 * tap];
        return {a[0] * s[0] + b[0] * s[1], a[1] * s[0] + b[1] * s[1], b[2] * s[2] + b[4] * s[3],
                b[3] * s[2] + b[5] * s[3]};
    }
    [[nodiscard]] Stokes difference(const Stokes& s) const {
        const double* a = &elements_[8];
        const double* b = &elements_[HighOrderFactors::kUnpolarized + 24];
        return {b[0] * s[2] + b[4] * s[3], b[1] * s[2] + b[5] * s[3], a[0] * s[0] + b[2] * s[1],
                a[1] * s[0] + b[3] * s[1]};
    }
    [[nodiscard]] Stokes normal(const Stokes& s) const {
        return {elements_[10] * s[0], elements_[11] * s[0], 0, 0};
    }

private:
    std::array<double, HighOrderFactors::kElements> elements_{};
};

}  // namespace

Image high_orders_in_double(const Vertices& vertices, const HighOrderFactors& factors,
                            const HighOrderMaps& maps, const glm::dmat3& light_to_world,
                            std::span<const glm::dvec2> fractions, int channels) {
    Image out(static_cast<std::size_t>(channels), std::vector<Stokes>(vertices.normals.size()));
    const glm::dmat3 to_light = glm::transpose(light_to_world);
    const double cos_spread = std::cos(factors.spread());
    const double sin_spread = std::sin(factors.spread());
    for (std::size_t i = 0; i < vertices.normals.size(); ++i) {
        const glm::dvec3 n(vertices.normals[i]);
        const glm::dvec3 v = vertices.view.towards(glm::dvec3(vertices.positions[i]));
        const Frame camera = vertices.view.frame(v);
        const double cosine = glm::dot(n, v);
        // A vertex seen from behind counts as seen at 90 degrees. From straight behind or straight ahead any
        // plane is valid.
        glm::dvec3 seen = v;
        if (cosine < 0) {
            const glm::dvec3 flat = v - cosine * n;
            seen = glm::length(flat) > 1e-5 ? glm::normalize(flat) : camera[0];
        }
        const glm::dvec3 d = seen - 2 * std::max(cosine, 0.0) * n;
        const glm::dvec3 side = glm::cross(n, seen);
        const glm::dvec3 x = glm::length(side) > 1e-5 ? glm::normalize(side) : camera[0];
        const glm::dvec3 y = glm::cross(d, x);
        const double angle = angle_between(Frame(x, glm::cross(v, x), v), camera);
        for (int c = 0; c < channels; ++c) {
            const auto at = [&](const LobeMap& map, const glm::dvec3& direction, const glm::dvec3& axis) {
                return look_up(map, map.channels() == 1 ? 0 : c, to_light * direction, to_light * axis);
            };
            const auto reflected = [&](const Elements& f) {
                Stokes sum = f.even(0, at(*maps.central, d, x));
                if (factors.spread() > 0) {
                    sum += f.even(1, at(*maps.outer, cos_spread * d + sin_spread * y, x));
                    sum += f.even(2, at(*maps.outer, cos_spread * d - sin_spread * y, x));
                    const Stokes right =
                        at(*maps.outer, cos_spread * d + sin_spread * x, cos_spread * x - sin_spread * d);
                    const Stokes left =
                        at(*maps.outer, cos_spread * d - sin_spread * x, cos_spread * x + sin_spread * d);
                    sum += f.even(3, right + left) + f.difference(right - left);
                }
                const glm::dvec2 fraction = fractions.empty() ? glm::dvec2(1) : fractions[i];
                sum *= fraction[0];
                if (factors.has_base()) sum += fraction[1] * f.normal(at(*maps.base, -n, x));
                return sum;
            };
            Stokes sum = reflected(Elements(factors, c, 0, cosine));
            if (factors.pairings() > 1) {
                const Stokes second = reflected(Elements(factors, c, 1, cosine));
                sum += Stokes(second[2], second[3], second[0], second[1]);
            }
            out[static_cast<std::size_t>(c)][i] = rotated(sum, angle);
        }
    }
    return out;
}

glm::dvec2 fractions_in_double(const Vertices& vertices, std::size_t vertex,
                               std::span<const double> visibility, int order, double width) {
    const Frame frame = theta_phi_frame(glm::dvec3(vertices.normals[vertex]));
    const glm::dvec3 world = vertices.view.towards(glm::dvec3(vertices.positions[vertex]));
    const glm::dvec3 v = world * frame;
    glm::dvec3 d(v.x, v.y, -std::max(v.z, 0.0));
    if (glm::length(d) <= 1e-5) d = vertices.view.frame(world)[0] * frame;
    d = glm::normalize(d);
    const OrderGains lobe = gaussian_gains(std::max(width, 1.7 / (order + 1)), 0, order);
    const OrderGains cosine = cosine_gains(0, order);
    const auto sum = [&](const OrderGains& gains, const glm::dvec3& direction) {
        const std::vector<double> scalar = scalar_harmonics(order, direction);
        double seen = 0;
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                seen += gains[static_cast<std::size_t>(l)] * visibility[psh_index(l, m)] *
                        scalar[psh_index(l, m)];
        // The result is relative to the filtered visibility of an unoccluded vertex, which is 1 everywhere.
        return std::clamp(seen / gains[0], 0.0, 1.0);
    };
    return {sum(lobe, d), sum(cosine, {0, 0, -1})};
}

}  // namespace nicol::test
