// SPDX-License-Identifier: MIT
// Tests of rough boundaries: sampled facets against the scattering function, reciprocity, smooth limit.
#include "shading/rough_boundary.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "polarization/stokes.hpp"
#include "test.hpp"

using namespace nicol;
using std::numbers::pi;

namespace {

/// Polarized light that varies smoothly with the direction it comes from, in frame `incident`.
Stokes light_from(const glm::dvec3& towards_light, const Frame& incident) {
    const double x = towards_light.x, y = towards_light.y, z = towards_light.z;
    const Stokes field(1 + 0.4 * x + 0.3 * y * z, 0.4 + 0.2 * z, -0.3 + 0.2 * x, 0.3 * y + 0.2);
    // The frame of the field: x across a fixed axis.
    const Frame fixed = frame_with_x(-towards_light, glm::cross(glm::dvec3(0.2, 0.9, 0.4), towards_light));
    return rotated(field, angle_between(fixed, incident));
}

/// Returns the integral over all directions of what the boundary scatters, without the front's reflection if
/// `transmitted`, else without the transmission; in the theta-phi frame of the viewer.
Stokes integrated(const SmoothBoundary& boundary, const glm::dvec3& viewer, bool transmitted, int channel) {
    constexpr int rows = 500, columns = 1000;
    Stokes sum(0.0);
    const double sign = (viewer.z < 0) != transmitted ? -1 : 1;
    for (int i = 0; i < rows; ++i) {
        const double z = sign * (i + 0.5) / rows;
        const double rho = std::sqrt(1 - z * z);
        for (int j = 0; j < columns; ++j) {
            const double phi = 2 * pi * (j + 0.5) / columns;
            const glm::dvec3 light(rho * std::cos(phi), rho * std::sin(phi), z);
            const Stokes in = light_from(light, theta_phi_frame(-light));
            sum += std::abs(z) * (rough_scattering(boundary, light, viewer, channel) * in);
        }
    }
    return sum * (2 * pi / rows / columns);
}

/// Returns the mean over sampled facets, in the same frame.
Stokes sampled(const SmoothBoundary& boundary, const glm::dvec3& viewer, bool transmitted, int channel) {
    constexpr int size = 400;
    const Frame received = theta_phi_frame(viewer);
    Stokes sum(0.0);
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
            const BoundarySplit split = split_at_facet(boundary, {0, 0, 1}, {0, 0, 1}, received,
                                                       {(i + 0.5) / size, (j + 0.5) / size});
            const BoundaryPart& part = transmitted ? split.transmitted : split.reflected;
            if (part.share > 0)
                sum += mueller_of(boundary, split, part, channel) *
                       light_from(part.towards_light, part.incident);
        }
    return sum * (1.0 / size / size);
}

SmoothBoundary rough(double eta, double alpha, Distribution distribution = Distribution::ggx) {
    return {.eta = eta, .alpha = alpha, .distribution = distribution};
}

}  // namespace

TEST_CASE("the mean over sampled facets is the integral of what a rough boundary scatters") {
    SmoothBoundary sheet = rough(1.5, 0.3);
    sheet.behind = SmoothBoundary::Behind::slab;
    const FilmParameters film{.thickness = 350, .eta = {2.1}, .wavelengths = {450, 600}};
    SmoothBoundary coated = rough(1.5, 0.3);
    coated.film = film_table(film, 1, {1.5});
    SmoothBoundary coated_sheet = sheet;
    coated_sheet.film = film_table(film, 1, {1.5}, FilmTable::Kind::slab);
    for (const SmoothBoundary& boundary : {rough(1.5, 0.3), rough(1.5, 0.4, Distribution::beckmann),
                                           rough(0.7, 0.3), sheet, coated, coated_sheet}) {
        const int channel = boundary.channels() - 1;
        for (const glm::dvec3& viewer :
             {glm::normalize(glm::dvec3(0.3, 0.5, 0.8)), glm::normalize(glm::dvec3(0.7, -0.2, 0.4)),
              glm::normalize(glm::dvec3(-0.5, 0.3, -0.7))}) {
            for (const bool transmitted : {false, true}) {
                const Stokes wanted = integrated(boundary, viewer, transmitted, channel);
                const Stokes found = sampled(boundary, viewer, transmitted, channel);
                CAPTURES(boundary.eta, viewer.z, transmitted, wanted[0]);
                CHECK(std::abs(wanted[1]) + std::abs(wanted[2]) > 0.02 * wanted[0]);
                for (int p = 0; p < 4; ++p) {
                    CAPTURES(p, found[p], wanted[p]);
                    CHECK(std::abs(found[p] - wanted[p]) < 4e-3 * wanted[0]);
                }
            }
        }
    }
}

TEST_CASE("a rough boundary scatters as much light one way as the other, by the square of the index") {
    const SmoothBoundary boundary = rough(1.6, 0.35);
    const glm::dvec3 above = glm::normalize(glm::dvec3(0.3, 0.1, 0.8));
    const glm::dvec3 below = glm::normalize(glm::dvec3(-0.3, 0.2, -0.9));
    const double down = rough_scattering(boundary, above, below)(0, 0);
    const double up = rough_scattering(boundary, below, above)(0, 0);
    CHECK(up > 0.01);
    CHECK(down == doctest::Approx(1.6 * 1.6 * up).epsilon(1e-12));
}

TEST_CASE("a hardly rough boundary splits light as a smooth one") {
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(0.5, 0.4, 0.6));
    const Frame received = theta_phi_frame(viewer);
    for (const auto behind : {SmoothBoundary::Behind::body, SmoothBoundary::Behind::slab}) {
        SmoothBoundary boundary = rough(1.5, 1e-3);
        boundary.behind = behind;
        for (const double side : {1.0, -1.0}) {
            const glm::dvec3 normal(0, 0, side);
            const BoundarySplit smooth = split_at(boundary, normal, normal, received);
            const BoundarySplit facet = split_at_facet(boundary, normal, normal, received, {0.3, 0.6});
            CHECK(facet.inside == smooth.inside);
            for (const auto part : {&BoundarySplit::reflected, &BoundarySplit::transmitted}) {
                const BoundaryPart& a = smooth.*part;
                const BoundaryPart& b = facet.*part;
                CHECK(glm::distance(a.mueller * light_from(a.towards_light, a.incident),
                                    b.mueller * light_from(b.towards_light, b.incident)) < 0.01);
            }
        }
    }
}
