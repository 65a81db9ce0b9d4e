// SPDX-License-Identifier: MIT
// Tubes around curves of a text file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "error.hpp"
#include "files/read_bytes.hpp"
#include "geometry/mesh.hpp"
#include "geometry/perpendicular.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol {
namespace {

using geometry::Tokenizer;

// Sides of a tube, and rows of each of its cubic segments.
constexpr std::uint32_t kSides = 48;
constexpr std::uint32_t kRowsOfSegment = 24;
// Detail of the balls at the points of a linear curve, see make_sphere().
constexpr double kDetailOfBall = 0.3;

// Control point: xyz is the position, w the radius.
using ControlPoint = glm::dvec4;
using Curve = std::vector<ControlPoint>;

// Returns the curves of a file, between which there are empty lines. They have at least `fewest` points.
std::vector<Curve> parse_curves(std::string_view name, std::string_view bytes, std::size_t fewest,
                                const LoadBudget& budget) {
    std::string_view text = geometry::as_text(name, bytes);
    std::vector<Curve> out(1);
    std::size_t number = 0;
    const auto end_curve = [&] {
        if (out.back().empty()) return;
        if (out.back().size() < fewest)
            geometry::fail_at(name, number,
                              "a curve of " + std::to_string(out.back().size()) +
                                  " points ends; expected at least " + std::to_string(fewest));
        out.emplace_back();
    };
    while (!text.empty()) {
        budget.step(64);
        ++number;
        const std::size_t length = std::min(text.find('\n'), text.size());
        Tokenizer line(name, text.substr(0, length), 0, number);
        text.remove_prefix(std::min(length + 1, text.size()));
        if (Tokenizer(line).next().empty()) {
            end_curve();
            continue;
        }
        ControlPoint point;
        for (glm::length_t i = 0; i < 4; ++i)
            point[i] = static_cast<double>(line.number(i < 3 ? "a coordinate of a point" : "a radius"));
        if (!(point.w > 0)) line.fail("the radius is not above 0");
        if (!line.next().empty()) line.fail("more than x, y, z and a radius");
        out.back().push_back(point);
    }
    end_curve();
    out.pop_back();
    if (out.empty()) throw Error(ErrorCode::invalid_file, std::string(name) + ": no curve");
    return out;
}

// Point of a curve, its derivative, and its place along the curve, 0 to 1.
struct Station {
    ControlPoint at;
    ControlPoint along;
    double v;
};

Station on_bspline(const Curve& curve, std::uint32_t row) {
    const auto segments = static_cast<std::uint32_t>(curve.size() - 3);
    const std::uint32_t segment = std::min(row / kRowsOfSegment, segments - 1);
    const double t = static_cast<double>(row - segment * kRowsOfSegment) / kRowsOfSegment;
    const double s = 1 - t;
    const ControlPoint* const p = &curve[segment];
    const ControlPoint at = (s * s * s * p[0] + (3 * t * t * t - 6 * t * t + 4) * p[1] +
                             (3 * s * s * s - 6 * s * s + 4) * p[2] + t * t * t * p[3]) /
                            6.0;
    const ControlPoint along =
        (-s * s * p[0] + (3 * t * t - 4 * t) * p[1] + (4 * s - 3 * s * s) * p[2] + t * t * p[3]) / 2.0;
    return {at, along, (segment + t) / segments};
}

// Adds the tube around stations, whose rings do not twist from one to the next.
void add_tube(std::span<const Station> stations, Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto first_texcoord = static_cast<std::uint32_t>(mesh.texcoords.size());
    glm::dvec3 axis(0, 0, 1);
    glm::dvec3 across(0);
    for (const Station& station : stations) {
        const double speed = glm::length(glm::dvec3(station.along));
        if (speed > 0) axis = glm::dvec3(station.along) / speed;  // else the curve keeps its direction
        across = perpendicular(axis, across);
        const glm::dvec3 third = glm::cross(axis, across);
        const double slope = speed > 0 ? station.along.w / speed : 0;
        for (std::uint32_t side = 0; side <= kSides; ++side) {
            const double turn = static_cast<double>(side) / kSides;
            mesh.texcoords.emplace_back(turn, station.v);
            if (side == kSides) break;
            const double angle = 2 * std::numbers::pi * turn;
            const glm::dvec3 outward = std::cos(angle) * across + std::sin(angle) * third;
            mesh.positions.emplace_back(glm::dvec3(station.at) + station.at.w * outward);
            mesh.normals.emplace_back(glm::normalize(outward - slope * axis));
        }
    }
    for (std::uint32_t row = 0; row + 1 < stations.size(); ++row)
        for (std::uint32_t side = 0; side < kSides; ++side) {
            const auto add = [&](glm::uvec3 rows, glm::uvec3 sides) {
                mesh.triangles.push_back(first + (row + rows) * kSides + sides % kSides);
                mesh.texcoord_triangles.push_back(first_texcoord + (row + rows) * (kSides + 1) + sides);
            };
            add({0, 0, 1}, {side, side + 1, side + 1});
            add({0, 1, 1}, {side, side + 1, side});
        }
}

// Adds a ball whose v is one number. ball: of radius 1 around 0.
void add_ball(const Mesh& ball, const ControlPoint& point, double v, Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto first_texcoord = static_cast<std::uint32_t>(mesh.texcoords.size());
    for (const glm::vec3& position : ball.positions)
        mesh.positions.emplace_back(glm::dvec3(point) + point.w * glm::dvec3(position));
    mesh.normals.insert(mesh.normals.end(), ball.normals.begin(), ball.normals.end());
    for (const glm::vec2& texcoord : ball.texcoords) mesh.texcoords.emplace_back(texcoord.x, v);
    for (const glm::uvec3& triangle : ball.triangles) mesh.triangles.push_back(first + triangle);
    for (const glm::uvec3& triangle : ball.texcoord_triangles)
        mesh.texcoord_triangles.push_back(first_texcoord + triangle);
}

void add_linear(const Curve& curve, const Mesh& ball, Mesh& mesh) {
    const auto segments = static_cast<double>(curve.size() - 1);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double v = static_cast<double>(i) / segments;
        add_ball(ball, curve[i], v, mesh);
        if (i == 0 || glm::dvec3(curve[i]) == glm::dvec3(curve[i - 1])) continue;
        const ControlPoint along = curve[i] - curve[i - 1];
        add_tube(std::array{Station{curve[i - 1], along, v - 1 / segments}, Station{curve[i], along, v}},
                 mesh);
    }
}

void add_bspline(const Curve& curve, Mesh& mesh) {
    const auto rows = static_cast<std::uint32_t>(curve.size() - 3) * kRowsOfSegment;
    std::vector<Station> stations;
    for (std::uint32_t row = 0; row <= rows; ++row) stations.push_back(on_bspline(curve, row));
    add_tube(stations, mesh);
}

}  // namespace

Mesh load_curves(const std::filesystem::path& file, CurveKind kind, const glm::dmat3& axes,
                 const LoadBudget& budget) {
    const bool linear = kind == CurveKind::linear;
    std::vector<Curve> curves = parse_curves(file.string(), read_bytes(file, budget), linear ? 2 : 4, budget);
    for (Curve& curve : curves)
        for (ControlPoint& point : curve) point = ControlPoint(axes * glm::dvec3(point), point.w);
    // A ball and a tube of a point; the rows of a segment.
    constexpr std::uint64_t of_row = kSides, of_point = 1500;
    std::uint64_t vertices = 0;
    for (const Curve& curve : curves)
        vertices += linear ? of_point * curve.size() : of_row * (kRowsOfSegment * (curve.size() - 3) + 1);
    budget.take_mesh(file, vertices, 2 * vertices);
    const Mesh ball = linear ? make_sphere(glm::dvec3(0), 1, kDetailOfBall) : Mesh();
    Mesh mesh;
    for (const Curve& curve : curves) {
        budget.step(64 * curve.size());
        linear ? add_linear(curve, ball, mesh) : add_bspline(curve, mesh);
    }
    return mesh;
}

}  // namespace nicol
