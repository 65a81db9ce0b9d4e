// SPDX-License-Identifier: MIT
// Tests of the factored method against the reference method under light whose order it represents exactly.
#include "capi.hpp"

using namespace capi_test;

namespace {

// Planes that touch the unit sphere, spread evenly over it by the golden angle: their number, and the frame
// of one.
constexpr int plates = 12;
struct Plate {
    glm::dvec3 normal, x, y;

    explicit Plate(int index) {
        const double height = 1 - (2 * index + 1) / static_cast<double>(plates);
        const double radius = std::sqrt(1 - height * height), azimuth = 2.39996323 * index;
        normal = {radius * std::cos(azimuth), height, radius * std::sin(azimuth)};
        x = {-std::sin(azimuth), 0, std::cos(azimuth)};
        y = glm::cross(normal, x);
    }
};

// Returns flat triangles that touch a sphere. Together they are convex like the sphere, but no normal is
// interpolated, and no facet hides light that a smooth normal above it would receive.
nicol_mesh touching_plates(nicol_context context) {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < plates; ++i) {
        const Plate plate(i);
        for (int corner = 0; corner < 3; ++corner) {
            const double angle = 2 * pi * corner / 3;
            positions.emplace_back(plate.normal +
                                   0.1 * (std::cos(angle) * plate.x + std::sin(angle) * plate.y));
            normals.emplace_back(plate.normal);
            indices.push_back(static_cast<std::uint32_t>(indices.size()));
        }
    }
    nicol_mesh_data data = NICOL_MESH_DATA_INIT;
    data.vertex_count = 3 * plates;
    data.triangle_count = plates;
    data.positions = &positions[0].x;
    data.normals = &normals[0].x;
    data.indices = indices.data();
    return make(nicol_mesh_create, context, &data);
}

// Returns random coefficients of two channels in every Stokes component. Order 0 is large enough to keep s0
// positive.
std::vector<double> random_light(std::uint32_t order) {
    std::mt19937 random(order);
    std::uniform_real_distribution<double> value(-1, 1);
    std::vector<double> out;
    for (int channel = 0; channel < 2; ++channel)
        for (std::uint32_t l = 0; l <= order; ++l)
            for (std::uint32_t i = 0; i < 4 * (2 * l + 1); ++i) {
                const bool exists = l >= 2 || i % 4 == 0 || i % 4 == 3;
                out.push_back(l == 0 && i == 0 ? 10 : exists ? value(random) / (1 + 0.3 * l) : 0);
            }
    return out;
}

// Returns a camera whose image shows the middle of a plate, at an angle to its normal.
nicol_camera camera_on(const Plate& plate, double tilt, double azimuth) {
    const glm::dvec3 aside = std::cos(azimuth) * plate.x + std::sin(azimuth) * plate.y;
    const glm::dvec3 origin = plate.normal + 3.0 * (std::cos(tilt) * plate.normal + std::sin(tilt) * aside);
    const double up[] = {0.3, 0.9, 0.1};
    nicol_camera camera = NICOL_CAMERA_INIT;
    OK(nicol_camera_look_at(&camera, &origin.x, &plate.normal.x, up));
    camera.projection = NICOL_PROJECTION_ORTHOGRAPHIC;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 2; ++column) camera.to_world[4 * row + column] *= 0.005;
    return camera;
}

// Returns Stokes vectors of two channels at points on the sphere.
std::vector<float> points(nicol_context context, std::uint32_t order, nicol_method method,
                          std::uint32_t samples) {
    const std::vector<double> coefficients = random_light(order);
    const Owned environment(
        make(nicol_environment_create_psh, context, order, 2U, coefficients.data(), coefficients.size()));
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    plastic.alpha = 0.4F;
    plastic.diffuse_reflectance = spectrum({0.3F, 0.6F});
    const Owned material(plastic_of(context, plastic));
    const Owned mesh(touching_plates(context));
    const Owned scene(simple_scene(context, environment, mesh, material));
    const Owned framebuffer(framebuffer_of(context, 1, 1, 2));
    nicol_render_options options = plain_options();
    options.method = method;
    options.order_low = options.order_high = order;
    options.samples = samples;
    std::vector<float> all;
    for (int i = 0; i < plates; ++i) {
        const nicol_camera camera = camera_on(Plate(i), 0.1 * i, 1.7 * i);
        OK(nicol_render(scene, &camera, &options, framebuffer));
        const std::vector<float> point = read_all(framebuffer);
        all.insert(all.end(), point.begin(), point.end());
    }
    return all;
}

}  // namespace

TEST_CASE("factored is the reference under light of its order, to 2e-4") {
    for (const std::uint32_t order : {4U, 9U}) {
        CAPTURE(order);
        const std::vector<float> truth =
            points(Owned(make_context(NICOL_BACKEND_OSMESA)), order, NICOL_METHOD_REFERENCE, 1 << 17);
        on_every_backend([&](nicol_context each) {
            const Distance apart(points(each, order, NICOL_METHOD_FACTORED, 1), truth);
            for (std::size_t p = 0; p < 4; ++p) CHECK(apart.error[p] < 2e-4 * apart.size[p]);
        });
    }
}
