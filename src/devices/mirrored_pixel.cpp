// SPDX-License-Identifier: MIT
#include "devices/mirrored_pixel.hpp"

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Largest distance between a sample's place and the point that is shaded for it, in samples. Points that are
// farther away are not of the sample's surface.
constexpr double kFarthest = 1;
// Longest change of direction that is not an overflow.
constexpr double kLongest = 1e30;

// Camera whose samples are even.
struct Film {
    CameraAxes camera;
    Vector3<double> forward;
    std::array<Vector3<double>, 2> across;  // a sample's sides on the image plane: to the right and down
    double width, height;                   // of a sample on the image plane; the height is below 0
};

// Computes a - factor b.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> minus_some(const Vector3<double>& a, const Number& factor,
                                                         const Vector3<Number>& b) {
    return {a.x - factor * b.x, a.y - factor * b.y, a.z - factor * b.z};
}

// Stores a vector times a number.
template <class Number>
[[gnu::always_inline]] inline void store_scaled(const Vector3<Number>& v, const Number& scale,
                                                std::size_t first, LaneVectors& out) {
    store_part(Vector3<Number>{v.x * scale, v.y * scale, v.z * scale}, first, out);
}

template <class Number>
[[gnu::always_inline]] inline void find_pixels(const Film& film, const ShownPoints& points,
                                               const LanePoints& positions, const LaneSamples& samples,
                                               MirroredPixels& out) {
    const CameraAxes& camera = film.camera;
    const Number one = Number{} + 1.0;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> position, n, facet;
        load_vector(positions.x.value.data() + first, position.x);
        load_vector(positions.y.value.data() + first, position.y);
        load_vector(positions.z.value.data() + first, position.z);
        load_part(points.normals, first, n);
        load_part(points.facets, first, facet);
        const Edges<Number> edges = edges_of<Number>(points.triangles.corners, first);
        const Edges<Number> changes = edges_of<Number>(points.triangles.normals, first);

        const Vector3<Number> back = towards_camera(camera, position);
        const Vector3<Number> sight{-back.x, -back.y, -back.z};
        const Vector3<Number> away{position.x - camera.eye.x, position.y - camera.eye.y,
                                   position.z - camera.eye.z};
        Number depth, distance, seen, facing;
        dot(away, film.forward, depth);
        depth = camera.perspective > 0 ? depth : one;
        dot(away, away, distance);
        square_root(distance);
        dot(sight, facet, seen);
        dot(sight, n, facing);
        const Number turning = distance > 0.0 ? camera.perspective * depth / distance : Number{};
        const Number size = seen < 0.0 ? -seen : seen;
        const Number slanted = size > 1e-3 ? 1.0 / seen : Number{};

        std::array<Vector3<Number>, 2> steps;
        for (std::size_t i = 0; i < 2; ++i) {
            Number along, rise, towards, rise_of_turn, length;
            dot(film.across[i], sight, along);
            const Vector3<Number> upright = minus_some(film.across[i], along, sight);
            const Vector3<Number> turn{turning * upright.x, turning * upright.y, turning * upright.z};
            const Vector3<Number> flat{depth * upright.x, depth * upright.y, depth * upright.z};
            dot(flat, facet, rise);
            const Number back_by = rise * slanted;
            const Vector3<Number> bent = bend(edges, changes, minus_scaled(flat, back_by, sight), n);
            dot(turn, n, rise_of_turn);
            dot(sight, bent, towards);
            const Number by_normal = 2.0 * (rise_of_turn + towards), by_bend = 2.0 * facing;
            const Vector3<Number> step = minus_scaled(minus_scaled(turn, by_normal, n), by_bend, bent);
            dot(step, step, length);
            square_root(length);
            const Number limited = 1.0 / (length > 1.0 ? length : one);
            const Number scale = length < kLongest ? limited : Number{};
            steps[i] = {length < kLongest ? step.x * scale : Number{},
                        length < kLongest ? step.y * scale : Number{},
                        length < kLongest ? step.z * scale : Number{}};
        }

        Number right, up, shown_right, shown_up;
        load_part(samples.right, first, right);
        load_part(samples.up, first, up);
        dot(away, camera.right, shown_right);
        dot(away, camera.up, shown_up);
        right = (right - shown_right / depth) / film.width;
        up = (up - shown_up / depth) / film.height;
        const Number beside = right * right + up * up;
        const Number near = beside < kFarthest * kFarthest ? one : Number{};
        right = near > 0.0 ? right : Number{};
        up = near > 0.0 ? up : Number{};
        store_part(Vector3<Number>{right * steps[0].x + up * steps[1].x, right * steps[0].y + up * steps[1].y,
                                   right * steps[0].z + up * steps[1].z},
                   first, out.shift);
        Number width, height;
        load_part(samples.width, first, width);
        load_part(samples.height, first, height);
        store_scaled(steps[0], width, first, out.steps[0]);
        store_scaled(steps[1], height, first, out.steps[1]);
    }
}

glm::dvec3 vector(const Vector3<double>& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

glm::dvec3 bend_of_normal(const ShownTriangle& triangle, const glm::dvec3& way, const glm::dvec3& normal) {
    const auto edges = [](const std::array<glm::vec3, 3>& corners) {
        const glm::dvec3 first(corners[0]);
        return Edges<double>{components(glm::dvec3(corners[1]) - first),
                             components(glm::dvec3(corners[2]) - first)};
    };
    return vector(
        bend(edges(triangle.corners), edges(triangle.normals), components(way), components(normal)));
}

void mirrored_pixels(const Projection& projection, int width, int height, const ShownPoints& points,
                     const LaneSamples& samples, MirroredPixels& out) {
    const Viewpoint& view = projection.view;
    const double right = 2 * projection.sample_size * projection.half_width / width;
    const double up = -2 * projection.sample_size * projection.half_height / height;
    const Film film{.camera = view.axes(),
                    .forward = components(view.forward),
                    .across = {components(view.right * right), components(view.up * up)},
                    .width = right,
                    .height = up};
    dispatch<find_pixels<TwoDoubles>, find_pixels<FourDoubles>, find_pixels<EightDoubles>>(
        film, points, lane_points(points.positions), samples, out);
}

}  // namespace nicol
