// SPDX-License-Identifier: MIT
#include "sphere_cap.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>

void write_sphere_cap(const std::filesystem::path& path, int rings) {
    std::ofstream out(path);
    out.precision(9);
    for (int ring = 0; ring <= rings; ++ring) {
        const double theta = std::numbers::pi / 2 * ring / rings;
        for (int i = 0; i < std::max(1, 6 * ring); ++i) {
            const double phi = 2 * std::numbers::pi * i / std::max(1, 6 * ring);
            const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi);
            out << "v " << x << ' ' << y << ' ' << std::cos(theta) << "\nvn " << x << ' ' << y << ' '
                << std::cos(theta) << '\n';
        }
    }
    // Numbers of vertices count from 1; ring r begins after the rings inside it.
    const auto at = [](int ring, int i) {
        return ring == 0 ? 1 : 2 + 3 * ring * (ring - 1) + i % (6 * ring);
    };
    const auto triangle = [&](int a, int b, int c) {
        out << "f " << a << "//" << a << ' ' << b << "//" << b << ' ' << c << "//" << c << '\n';
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int sector = 0; sector < 6; ++sector) {
            for (int i = 0; i <= ring; ++i) {
                const int inner = sector * ring + i, outer = sector * (ring + 1) + i;
                triangle(at(ring, inner), at(ring + 1, outer), at(ring + 1, outer + 1));
                if (i < ring) triangle(at(ring, inner), at(ring + 1, outer + 1), at(ring, inner + 1));
            }
        }
    }
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}
