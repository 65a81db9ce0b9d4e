// SPDX-License-Identifier: MIT
// A sphere seen along -z, and its reflected light by response rows at the exact angles.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "harmonics/light_coefficients.hpp"
#include "harmonics/rotation.hpp"
#include "material/conductor.hpp"
#include "material/material.hpp"
#include "material/matrix_rows.hpp"
#include "material/row_integral.hpp"
#include "polarization/viewpoint.hpp"
#include "specular/high_order.hpp"

namespace nicol::test {

/// Stokes vectors in the camera's frame, [channel][vertex].
using Image = std::vector<std::vector<glm::vec4>>;

inline MaterialPtr plastic(double alpha) {
    return pplastic({.diffuse_reflectance = {0.6, 0.35, 0.1},
                     .int_ior = 1.5,
                     .ext_ior = 1,
                     .alpha = alpha,
                     .distribution = Distribution::ggx});
}

inline MaterialPtr gold(double alpha) {
    return rough_conductor({.eta = metal_index("Au"), .alpha = alpha, .distribution = Distribution::ggx});
}

/// Evaluates the high orders at one vertex at the origin: [channel].
inline std::vector<glm::vec4> look_up(const HighOrder& high, const Viewpoint& view, const glm::vec3& normal,
                                      const glm::vec2& visible_fraction, std::size_t channels) {
    std::vector<glm::vec4> out(channels, glm::vec4(0));
    std::vector<std::span<glm::vec4>> each;
    for (glm::vec4& stokes : out) each.emplace_back(&stokes, 1);
    const glm::vec3 position(0);
    const std::uint8_t visible = 1;
    high.run(view, {&position, 1}, {&normal, 1}, {&visible, 1}, {.fractions = {&visible_fraction, 1}}, 0, 1,
             each);
    return out;
}

/// Points on rings, so that few outgoing angles occur, spread evenly over the disc of radius 0.95.
struct SphereView {
    SphereView(int rings, int per_ring) {
        view.orthographic = true;
        view.forward = {0, 0, -1};
        view.up = {0, 1, 0};
        view.right = {1, 0, 0};
        for (int i = 0; i < rings; ++i) {
            const double radius = 0.95 * std::sqrt((i + 0.5) / rings);
            angles.push_back(std::asin(radius));
            for (int k = 0; k < per_ring; ++k) {
                const double phi = 2 * std::numbers::pi * (k + 0.37 * i) / per_ring;
                ring.push_back(static_cast<std::size_t>(i));
                normals.emplace_back(radius * std::cos(phi), radius * std::sin(phi),
                                     std::sqrt(1 - radius * radius));
            }
        }
        visible.assign(normals.size(), 1);
    }

    /// Light in the frames of the vertices, each with the viewer at azimuth 0.
    struct LocalLight {
        LightLayout layout;
        int channels;
        std::vector<std::vector<std::complex<double>>> pairs;  // [vertex * channels + channel]
    };
    [[nodiscard]] LocalLight local(const PshVector& light, LightKind kind) const {
        LocalLight out{LightLayout(light.order(), kind), light.channels(), {}};
        for (const glm::vec3& normal : normals) {
            const PshVector rotated_light = rotated(light, glm::transpose(surface(normal)));
            for (int c = 0; c < light.channels(); ++c)
                out.pairs.push_back(light_pairs(out.layout, rotated_light.channel(c)));
        }
        return out;
    }

    /// Returns the reflected light of orders 0..top for each top in `tops`.
    [[nodiscard]] std::vector<Image> reflected(const Material& material, const LocalLight& light,
                                               const std::vector<int>& tops) const {
        const LightLayout& layout = light.layout;
        const auto channels = static_cast<std::size_t>(light.channels);
        const auto rows = response_rows(material, layout, light.channels);
        std::vector<Image> out(tops.size(), black(light.channels));
        for (std::size_t v = 0; v < normals.size(); ++v) {
            const Frame frame = surface(normals[v]);
            const glm::dvec3 towards(0, 0, 1);
            const Frame from = frame * theta_phi_frame(glm::transpose(frame) * towards);
            const double angle_to_camera = angle_between(from, view.frame(towards));
            for (std::size_t c = 0; c < channels; ++c) {
                const std::size_t set = rows[ring[v]].size() / channels;
                const auto row = std::span<const double>(rows[ring[v]]).subspan(set * c, set);
                for (std::size_t i = 0; i < tops.size(); ++i) {
                    auto cut = light.pairs[v * channels + c];
                    std::size_t j = 0;
                    for (const LightLayout::Run& run : layout.runs())
                        for (std::size_t k = 0; k < run.count; ++k, ++j)
                            if (run.l + static_cast<int>(k) * run.step > tops[i]) cut[j] = 0;
                    out[i][c][v] = glm::vec4(rotated(rows_times_light(row, cut), angle_to_camera));
                }
            }
        }
        return out;
    }

    [[nodiscard]] Image black(int channels) const {
        return Image(static_cast<std::size_t>(channels), std::vector<glm::vec4>(normals.size()));
    }

    /// Returns `low` plus the high orders.
    [[nodiscard]] Image with(const Image& low, const HighOrder& high) const {
        Image out = low;
        std::vector<std::span<glm::vec4>> channels(out.begin(), out.end());
        high.run(view, normals, normals, visible, {}, 0, normals.size(), channels);
        return out;
    }

    Viewpoint view;
    std::vector<double> angles;      // outgoing angle of each ring, in radians
    std::vector<std::size_t> ring;   // ring of each vertex
    std::vector<glm::vec3> normals;  // normals, which are also the positions
    std::vector<std::uint8_t> visible;

private:
    static Frame surface(const glm::vec3& normal) { return frame_with_x(glm::dvec3(normal), {0, 0, 1}); }

    // Returns the rows [ring][channel][p][pairing][j].
    [[nodiscard]] std::vector<std::vector<double>> response_rows(const Material& material,
                                                                 const LightLayout& layout,
                                                                 int channels) const {
        const std::size_t set = 4 * material.pairings() * layout.row_size();
        std::vector<std::vector<double>> out;
        RowIntegral integral(material, layout);
        for (const double angle : angles) {
            std::vector<double>& rows = out.emplace_back(set * static_cast<std::size_t>(channels));
            if (material.matrix(0) != nullptr) {
                for (int c = 0; c < channels; ++c) {
                    const int own = material.channels() == 1 ? 0 : c;
                    rows_from_matrix(*material.matrix(own), angle, layout, material.pairings(),
                                     std::span(rows).subspan(set * static_cast<std::size_t>(c), set));
                }
                continue;
            }
            const double* of_term = integral.integrate(angle).data();
            for (int t = 0; t < material.terms(); ++t, of_term += set) {
                for (int c = 0; c < channels; ++c) {
                    for (std::size_t j = 0; j < set; ++j)
                        rows[set * static_cast<std::size_t>(c) + j] += material.weight(t, c) * of_term[j];
                }
            }
        }
        return out;
    }
};

/// Returns the RMS difference of each Stokes component relative to that of `truth`, over all channels.
inline std::array<double, 4> relative_error(const Image& found, const Image& truth) {
    std::array<double, 4> error{};
    for (int p = 0; p < 4; ++p) {
        double difference = 0;
        double power = 0;
        for (std::size_t c = 0; c < truth.size(); ++c) {
            for (std::size_t v = 0; v < truth[c].size(); ++v) {
                const double e = static_cast<double>(found[c][v][p]) - static_cast<double>(truth[c][v][p]);
                difference += e * e;
                power += static_cast<double>(truth[c][v][p]) * static_cast<double>(truth[c][v][p]);
            }
        }
        error[static_cast<std::size_t>(p)] = power > 0 ? std::sqrt(difference / power) : difference;
    }
    return error;
}

}  // namespace nicol::test
