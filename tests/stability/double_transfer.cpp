// SPDX-License-Identifier: MIT
#include "stability/double_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

#include "directions.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/light_coefficients.hpp"
#include "harmonics/product.hpp"
#include "harmonics/rotation.hpp"
#include "visibility/even_irradiance.hpp"
#include "visibility/visibility_in_double.hpp"

namespace nicol::test {
namespace {

constexpr double pi = std::numbers::pi;

glm::dvec3 across(const glm::dvec3& n) {
    return glm::normalize(glm::cross(n, std::abs(n.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
}

glm::dvec3 towards_at(const glm::dvec3& n, double zenith, double azimuth) {
    const glm::dvec3 x = across(n);
    const glm::dvec3 y = glm::cross(n, x);
    return std::cos(zenith) * n + std::sin(zenith) * (std::cos(azimuth) * x + std::sin(azimuth) * y);
}

// Products of visibility and light, for one visibility after another.
class Product {
public:
    explicit Product(int order) : order_(order) {
        // Uses triple products if their table is affordable, else a grid.
        if (order <= 9) {
            triples_ = std::make_unique<ShadowMatrix>(2 * order, order, order);
        } else {
            grid_ = std::make_unique<PshProduct>(2 * order, order, order);
        }
    }
    void set(std::vector<double> visibility) {
        visibility_ = std::move(visibility);
        if (triples_) matrix_ = triples_->expand(visibility_);
    }
    [[nodiscard]] std::vector<double> times(std::span<const double> light) {
        std::vector<double> out(4 * psh_count(order_));
        if (triples_) {
            matrix_.apply(light, out);
        } else {
            grid_->multiply(visibility_, light, out);
        }
        return out;
    }

private:
    int order_;
    std::unique_ptr<ShadowMatrix> triples_;
    std::unique_ptr<PshProduct> grid_;
    std::vector<double> visibility_;
    CoefficientMatrix matrix_;
};

double mix(double low, double high, double fraction) {
    return low + fraction * (high - low);
}

}  // namespace

Vertices::Vertices(const DirectionSet& directions, double unit, std::size_t normals_anywhere) {
    view.eye = unit * glm::dvec3(4, 3, 2);
    view.forward = glm::normalize(glm::dvec3(-4, -3, -2));
    view.right = glm::normalize(glm::cross(view.forward, glm::dvec3(0, 1, 0)));
    view.up = glm::cross(view.right, view.forward);

    std::mt19937 random(17);
    std::normal_distribution<double> gauss;
    std::vector<glm::dvec3> axes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const double tilt : {1e-3, 1e-6, 1e-9})
        for (const double side : {1.0, -1.0})
            axes.push_back(glm::normalize(glm::dvec3(tilt * 0.6, -tilt * 0.8, side)));
    for (std::size_t i = 0; i < normals_anywhere; ++i) axes.push_back(random_direction(random, gauss));

    const auto add = [&](const glm::dvec3& normal, const glm::dvec3& towards) {
        normals.emplace_back(normal);
        positions.emplace_back(view.eye -
                               unit * (2 + 0.5 * std::sin(static_cast<double>(positions.size()))) * towards);
    };
    for (const glm::dvec3& n : axes) {
        for (const double zenith : {0.0, 1e-6, 1e-3, pi / 3, pi / 2 - 1e-5, pi / 2, pi / 2 + 1e-5, 2.5, pi})
            add(n, towards_at(n, zenith, 7 * gauss(random)));
        add(n, view.up);
        add(n, -view.up);
        normals.emplace_back(n);
        positions.emplace_back(view.eye);
    }
    visible.assign(normals.size(), 1);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const glm::dvec3 towards = view.towards(glm::dvec3(positions[v]));
        const glm::dvec3 n(normals[v]);
        any_azimuth.push_back(glm::dot(n, towards) < 0 && glm::length(glm::cross(n, towards)) < 1e-6);
    }
    visibility = Visibility(directions.size(), normals.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const bool unoccluded = v % 5 == 2;
        const glm::vec3 plane(random_direction(random, gauss));
        const float least = unoccluded ? -2.0F : static_cast<float>(0.3 * gauss(random));
        visibility.set_unoccluded(v, unoccluded);
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const glm::vec3& d = directions.directions()[i];
            if (glm::dot(d, normals[v]) > 0 && glm::dot(d, plane) > least)
                visibility.at(v)[i / 64] |= std::uint64_t{1} << (i % 64);
        }
    }
}

namespace {

// The direction from a vertex to the viewer, in the vertex's frame.
struct Sight {
    Sight(const Viewpoint& view, const glm::vec3& position, const Frame& surface) {
        const glm::dvec3 world = view.towards(glm::dvec3(position));
        const glm::dvec3 towards = world * surface;
        const double rho = std::hypot(towards.x, towards.y);
        zenith = std::atan2(rho, towards.z);
        azimuth = rho > 0 ? std::atan2(towards.y, towards.x) : 0;
        angle = angle_between(surface * theta_phi_frame(towards), view.frame(world));
    }
    double zenith;
    double azimuth;
    double angle;  // to the camera's frame, in radians
};

Stokes respond(const ResponseTable& response, int channel, const LightLayout& layout,
               std::span<const std::complex<double>> light, const Sight& sight) {
    const double position = std::min(sight.zenith / (pi / 2), 1.0) * (ResponseTable::kAngles - 1);
    const int angle = std::min(static_cast<int>(position), ResponseTable::kAngles - 2);
    const int row = response.channels() == 1 ? 0 : channel;
    const std::span<const float> low = response.rows(angle, row);
    const std::span<const float> high = response.rows(angle + 1, row);
    Stokes sum(0.0);
    std::size_t j = 0;
    for (const LightLayout::Run& run : layout.runs()) {
        const auto phase = std::polar(1.0, -static_cast<double>(run.sign) * run.m * sight.azimuth);
        for (const std::size_t end = j + run.count; j < end; ++j) {
            const auto z = light[j] * phase;
            for (std::size_t p = 0; p < 4; ++p) {
                const std::size_t k = p * light.size() + j;
                sum[static_cast<int>(p)] +=
                    mix(static_cast<double>(low[k]), static_cast<double>(high[k]), position - angle) *
                    (p < 2 ? z.real() : z.imag());
            }
        }
    }
    return rotated(sum, sight.angle);
}

}  // namespace

std::vector<Image> shaded_in_double(const Vertices& vertices, const DirectionSet& directions,
                                    const LightLayout& layout, std::span<const PshVector> lights,
                                    std::span<const ResponseTable> responses) {
    const int order = layout.order();
    const int channels = lights.front().channels();
    Product product(order);
    const EvenIrradiance even(directions, order);
    std::vector<Image> out(
        lights.size() * responses.size(),
        Image(static_cast<std::size_t>(channels), std::vector<Stokes>(vertices.normals.size())));
    for (std::size_t v = 0; v < vertices.normals.size(); ++v) {
        const Frame surface = theta_phi_frame(glm::dvec3(vertices.normals[v]));
        const Sight sight(vertices.view, vertices.positions[v], surface);
        std::vector<double> seen =
            visibility_in_double(vertices.visibility, v, vertices.normals[v], directions, 2 * order);
        if (!vertices.visibility.unoccluded(v)) {
            std::vector<float> scaled(seen.begin(), seen.end());
            even.restore(vertices.visibility, v, vertices.normals[v], scaled);
            const double factor = seen[0] > 0 ? static_cast<double>(scaled[0]) / seen[0] : 1;
            for (double& coefficient : seen) coefficient *= factor;
        }
        product.set(seen);
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const PshVector local = rotated(lights[i], glm::transpose(surface));
            for (int c = 0; c < channels; ++c) {
                const auto z = light_pairs(layout, product.times(local.channel(c)));
                for (std::size_t r = 0; r < responses.size(); ++r)
                    out[i * responses.size() + r][static_cast<std::size_t>(c)][v] =
                        respond(responses[r], c, layout, z, sight);
            }
        }
    }
    return out;
}

Deviation deviation(const Vertices& vertices, const std::vector<std::vector<glm::vec4>>& found,
                    const Image& truth, double tolerance) {
    Deviation out;
    for (const auto& channel : truth)
        for (const Stokes& s : channel)
            for (int p = 0; p < 4; ++p) out.largest = std::max(out.largest, std::abs(s[p]));
    for (std::size_t c = 0; c < truth.size(); ++c) {
        for (std::size_t v = 0; v < truth[c].size(); ++v) {
            const Stokes got(found[c][v]);
            for (int p = 0; p < 4; ++p) out.finite = out.finite && std::abs(got[p]) <= 2 * out.largest;
            if (vertices.any_azimuth[v]) continue;
            for (int p = 0; p < 4; ++p) {
                out.worst = std::max(out.worst, std::abs(got[p] - truth[c][v][p]) / out.largest);
            }
            if (got[0] < 0 && truth[c][v][0] > tolerance * out.largest) ++out.negative;
        }
    }
    return out;
}

}  // namespace nicol::test
