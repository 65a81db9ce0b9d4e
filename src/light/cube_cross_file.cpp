// SPDX-License-Identifier: MIT
// Reading and writing of a cube map's four files.
#include <array>
#include <string>

#include "error.hpp"
#include "light/cube_cross.hpp"

namespace nicol {

using std::filesystem::path;

std::optional<path> cube_cross_stem(const path& file) {
    std::string name = file.filename().string();
    constexpr std::size_t ending = 7;  // length of "_s0.exr"
    if (name.size() <= ending) return std::nullopt;
    std::string end = name.substr(name.size() - ending);
    if (end[2] < '0' || end[2] > '3') return std::nullopt;
    end[2] = '0';
    if (end != "_s0.exr") return std::nullopt;
    name.resize(name.size() - ending);
    return file.parent_path() / name;
}

path cube_cross_file(const path& stem, int component) {
    path file = stem;
    return file += "_s" + std::to_string(component) + ".exr";
}

CubeCross read_cube_cross(const path& given, const LoadBudget& budget) {
    const path stem = cube_cross_stem(given).value_or(given);
    CubeCross cross;
    for (int p = 0; p < 4; ++p) {
        const path file = cube_cross_file(stem, p);
        if (!budget.files().find(file))
            throw Error(ErrorCode::file_not_found,
                        file.string() + ": is missing; a cube map has four files, _s0.exr to _s3.exr");
        const StokesImage part = read_exr(file, {}, budget);
        const auto invalid = [&](const std::string& what) {
            throw Error(ErrorCode::invalid_file, file.string() + ": " + what);
        };
        budget.check();
        for (std::size_t i = 0; i < part.data.size(); i += 4)
            if (part.data[i + 1] != 0 || part.data[i + 2] != 0 || part.data[i + 3] != 0)
                invalid("has channels S1 to S3 of its own; each file of a cube map holds one component");
        if (p == 0) {
            static_cast<StokesImage&>(cross) = part;
            try {
                cross.check("the image");
            } catch (const Error& e) {
                invalid(e.what());
            }
            continue;
        }
        if (part.width != cross.width || part.height != cross.height || part.channels != cross.channels ||
            part.wavelengths != cross.wavelengths)
            invalid(std::to_string(part.width) + " x " + std::to_string(part.height) + " pixels in " +
                    std::to_string(part.channels) + " channels, where s0 has " + std::to_string(cross.width) +
                    " x " + std::to_string(cross.height) + " in " + std::to_string(cross.channels) +
                    "; they must agree");
        for (std::size_t i = 0; i < part.data.size(); i += 4)
            cross.data[i + static_cast<std::size_t>(p)] = part.data[i];
    }
    return cross;
}

void write_cube_cross(const path& name, const Environment& environment, int edge) {
    if (edge < 2 || edge > 4096)
        throw Error(ErrorCode::invalid_argument, "write_cube_cross: edge must be 2 to 4096");
    CubeCross cross(4 * edge, 3 * edge, environment.channels());
    for (int y = 0; y < cross.height; ++y) {
        for (int x = 0; x < cross.width; ++x) {
            if (y / edge != 1 && x / edge != 1) continue;  // no face
            const CubePoint point = cube_point(edge, x + 0.5, y + 0.5);
            const double angle = angle_between(theta_phi_frame(-point.towards_light), point.frame);
            for (int c = 0; c < cross.channels; ++c) {
                const Stokes s = rotated(environment.radiance(c, point.towards_light), angle);
                for (std::size_t p = 0; p < 4; ++p)
                    cross.at(c, y, x)[p] = static_cast<float>(s[static_cast<glm::length_t>(p)]);
            }
        }
    }
    const std::string frame =
        "cube cross, z up; z propagation, x image right of the face, y = z cross x: image up";
    for (int p = 0; p < 4; ++p) {
        StokesImage part(cross.width, cross.height, cross.channels);
        part.wavelengths = environment.wavelengths();
        for (std::size_t i = 0; i < part.data.size(); i += 4)
            part.data[i] = cross.data[i + static_cast<std::size_t>(p)];
        write_exr(cube_cross_file(name, p), part, {.components = 0, .frame = frame});
    }
}

}  // namespace nicol
