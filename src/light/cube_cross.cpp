// SPDX-License-Identifier: MIT
// Cube maps: directions, frames, resampling to an equirectangular image, and their four files.
#include "light/cube_cross.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "error.hpp"
#include "light/equirect.hpp"

namespace nicol {
namespace {

/// Face of the cube: its forward axis, its image's right and up, and its cell in the cross.
struct Face {
    glm::dvec3 forward, right, up;
    int column, row;
};

const std::array<Face, 6> kFaces = {{{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, 1, 0},
                                     {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, 1},
                                     {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 1, 1},
                                     {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, 2, 1},
                                     {{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}, 3, 1},
                                     {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1, 2}}};

/// Returns the face that a direction meets, which is the face of the direction's largest component.
const Face& face_of(const glm::dvec3& direction) {
    return *std::ranges::max_element(kFaces, {},
                                     [&](const Face& f) { return glm::dot(direction, f.forward); });
}

/// Returns the position on the plane of a face in pixels, with 0 at the face's left and top edge.
glm::dvec2 on_face(const Face& face, const glm::dvec3& direction, int edge) {
    const double depth = glm::dot(direction, face.forward);
    const double a = glm::dot(direction, face.right) / depth;
    const double b = glm::dot(direction, face.up) / depth;
    return 0.5 * edge * glm::dvec2(1 + a, 1 - b);
}

CubePoint point_on(const Face& face, int edge, double x, double y) {
    const glm::dvec3 direction =
        glm::normalize(face.forward + (2 * x / edge - 1) * face.right + (1 - 2 * y / edge) * face.up);
    // x = up cross propagation is image right, as in a camera's perspective frame (Eq. 83).
    const glm::dvec3 right = glm::normalize(glm::cross(direction, face.up));
    return {direction, {right, glm::cross(-direction, right), -direction}};
}

class CrossSampler {
public:
    explicit CrossSampler(const CubeCross& cross) : cross_(cross), edge_(cross.width / 4) {}

    /// Interpolates bilinearly and returns the Stokes vectors of all channels in `out`, in the frame `frame`.
    void sample(const glm::dvec3& direction, const Frame& frame, std::span<Stokes> out) const {
        std::ranges::fill(out, Stokes(0));
        const Face& face = face_of(direction);
        const glm::dvec2 at = on_face(face, direction, edge_) - 0.5;
        const int left = static_cast<int>(std::floor(at.x));
        const int top = static_cast<int>(std::floor(at.y));
        const double a = at.x - left;
        const double b = at.y - top;
        add(face, left, top, (1 - a) * (1 - b), frame, out);
        add(face, left + 1, top, a * (1 - b), frame, out);
        add(face, left, top + 1, (1 - a) * b, frame, out);
        add(face, left + 1, top + 1, a * b, frame, out);
    }

private:
    void add(const Face& face, int x, int y, double weight, const Frame& frame, std::span<Stokes> out) const {
        if (weight == 0) return;
        const Face* home = &face;
        if (x < 0 || y < 0 || x >= edge_ || y >= edge_) {
            // The pixel lies beyond the edge, so the nearest pixel of the neighbouring face replaces it.
            const glm::dvec3 beyond = point_on(face, edge_, x + 0.5, y + 0.5).towards_light;
            home = &face_of(beyond);
            const glm::dvec2 at = on_face(*home, beyond, edge_);
            x = std::clamp(static_cast<int>(at.x), 0, edge_ - 1);
            y = std::clamp(static_cast<int>(at.y), 0, edge_ - 1);
        }
        // The directions are so close that parallel transport is the rotation between the frames' x axes.
        const Frame own = point_on(*home, edge_, x + 0.5, y + 0.5).frame;
        const double c = glm::dot(frame[0], own[0]);
        const double s = glm::dot(frame[0], own[1]);
        const double norm = c * c + s * s;
        const double cosine = (c * c - s * s) / norm;
        const double sine = 2 * c * s / norm;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const Stokes v =
                cross_.stokes(static_cast<int>(i), home->row * edge_ + y, home->column * edge_ + x);
            out[i] += weight * Stokes(v[0], cosine * v[1] + sine * v[2], cosine * v[2] - sine * v[1], v[3]);
        }
    }

    const CubeCross& cross_;
    int edge_;
};

}  // namespace

void CubeCross::check(const char* what) const {
    StokesImage::check(what);
    if (width % 4 != 0 || height % 3 != 0 || width / 4 != height / 3 || width < 8)
        throw Error(ErrorCode::invalid_argument,
                    std::string(what) + ": " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels are no cross of a cube; it has 4 edge x 3 edge, edge >= 2");
}

CubePoint cube_point(int edge, double x, double y) {
    if (edge < 1 || edge > kMaxImageSide)
        throw Error(ErrorCode::invalid_argument,
                    "cube_point: edge must be 1 to " + std::to_string(kMaxImageSide));
    for (const Face& face : kFaces) {
        const double u = x - face.column * edge;
        const double v = y - face.row * edge;
        if (u >= 0 && v >= 0 && u < edge && v < edge) return point_on(face, edge, u, v);
    }
    throw Error(ErrorCode::invalid_argument,
                "cube_point: x " + std::to_string(x) + ", y " + std::to_string(y) + " lies on no face");
}

EquirectImage equirect_from_cross(const CubeCross& cross, const LoadBudget& budget) {
    cross.check("equirect_from_cross: cross");
    const CrossSampler sampler(cross);
    // Bilinear resampling blurs. Small images get twice the columns, which halves the loss.
    const int width = cross.width <= 1024 ? 2 * cross.width : cross.width;
    const int height = width / 2 + 1;
    budget.take_memory(4 * sizeof(float) * static_cast<std::uint64_t>(width) *
                       static_cast<std::uint64_t>(height) * static_cast<std::uint64_t>(cross.channels));
    EquirectImage image(width, height, cross.channels);
    image.wavelengths = cross.wavelengths;
    tbb::parallel_for(0, image.height, [&](int y) {
        budget.check_deadline();
        std::vector<Stokes> values(static_cast<std::size_t>(cross.channels));
        for (int x = 0; x < image.width; ++x) {
            const double u = (x + 0.5) / image.width;
            const double v = y / (image.height - 1.0);
            sampler.sample(equirect_direction(u, v), equirect_frame(u, v), values);
            for (int c = 0; c < image.channels; ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    image.at(c, y, x)[p] = static_cast<float>(
                        values[static_cast<std::size_t>(c)][static_cast<glm::length_t>(p)]);
        }
    });
    return image;
}

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
