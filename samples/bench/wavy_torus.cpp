// SPDX-License-Identifier: MIT
#include "wavy_torus.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace {

using Vector = std::array<double, 3>;

Vector sum(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector scaled(const Vector& a, double factor) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

Vector unit(const Vector& a) {
    return scaled(a, 1 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
}

}  // namespace

Triangles wavy_torus(std::size_t rows, std::size_t columns) {
    const auto place = [](double u, double v) {
        const double tube = 0.42 + 0.06 * std::sin(5 * u) * std::cos(3 * v);
        const double ring = 1 + tube * std::cos(v);
        return Vector{ring * std::cos(u), tube * std::sin(v), ring * std::sin(u)};
    };
    const auto at = [&](std::size_t row, std::size_t column) {
        return row % rows * columns + column % columns;
    };
    Triangles mesh;
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            constexpr double turn = 2 * std::numbers::pi;
            const double u = turn * static_cast<double>(r) / static_cast<double>(rows);
            const double v = turn * static_cast<double>(c) / static_cast<double>(columns);
            constexpr double h = 1e-4;
            const Vector a = sum(place(u + h, v), scaled(place(u - h, v), -1));
            const Vector b = sum(place(u, v + h), scaled(place(u, v - h), -1));
            mesh.positions.push_back(place(u, v));
            mesh.normals.push_back(
                unit({b[1] * a[2] - b[2] * a[1], b[2] * a[0] - b[0] * a[2], b[0] * a[1] - b[1] * a[0]}));
            mesh.corners.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
            mesh.corners.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
        }
    }
    return mesh;
}

Triangles split(const Triangles& mesh) {
    Triangles out{mesh.positions, mesh.normals, {}};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
        const auto [found, added] = middles.try_emplace(std::minmax(a, b), out.positions.size());
        if (added) {
            out.positions.push_back(scaled(sum(mesh.positions[a], mesh.positions[b]), 0.5));
            out.normals.push_back(unit(sum(mesh.normals[a], mesh.normals[b])));
        }
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.corners) {
        const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        out.corners.insert(out.corners.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return out;
}

void write_obj(const std::filesystem::path& path, const Triangles& mesh) {
    std::ofstream out(path);
    out.precision(9);
    for (const Vector& p : mesh.positions) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const Vector& n : mesh.normals) out << "vn " << n[0] << ' ' << n[1] << ' ' << n[2] << '\n';
    for (const auto& triangle : mesh.corners) {
        out << 'f';
        for (const std::size_t corner : triangle) out << ' ' << corner + 1 << "//" << corner + 1;
        out << '\n';
    }
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}
