// SPDX-License-Identifier: MIT
// The factored method against the reference method under light of no higher order than it takes.
#include <array>
#include <cmath>
#include <numbers>

#include "capi.hpp"

using namespace capi_test;

namespace {

constexpr double pi = std::numbers::pi;

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector sum(double i, const Vector& a, double j, const Vector& b, double k, const Vector& c) {
    Vector out{};
    for (std::size_t n = 0; n < 3; ++n) out[n] = i * a[n] + j * b[n] + k * c[n];
    return out;
}

// A frame that touches the unit sphere; spread evenly over it by the golden angle.
constexpr int plates = 12;
struct Plate {
    Vector normal, x, y;

    explicit Plate(int index) {
        const double height = 1 - (2 * index + 1) / static_cast<double>(plates);
        const double radius = std::sqrt(1 - height * height), turn = 2.39996323 * index;
        normal = {radius * std::cos(turn), height, radius * std::sin(turn)};
        x = {-std::sin(turn), 0, std::cos(turn)};
        y = cross(normal, x);
    }
};

// Flat triangles that touch a sphere: convex, like the sphere, but nothing is interpolated between normals,
// and no facet hides the light that a smooth normal above it would see.
nicol_mesh touching_plates(nicol_context context) {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < plates; ++i) {
        const Plate plate(i);
        for (int corner = 0; corner < 3; ++corner) {
            const double angle = 2 * pi * corner / 3;
            const Vector at =
                sum(1, plate.normal, 0.1 * std::cos(angle), plate.x, 0.1 * std::sin(angle), plate.y);
            for (std::size_t n = 0; n < 3; ++n) {
                positions.push_back(static_cast<float>(at[n]));
                normals.push_back(static_cast<float>(plate.normal[n]));
            }
            indices.push_back(static_cast<std::uint32_t>(indices.size()));
        }
    }
    nicol_mesh_data data = NICOL_MESH_DATA_INIT;
    data.vertex_count = 3 * plates;
    data.triangle_count = plates;
    data.positions = positions.data();
    data.normals = normals.data();
    data.indices = indices.data();
    nicol_mesh mesh = nullptr;
    OK(nicol_mesh_create(context, &data, &mesh));
    return mesh;
}

// Bright enough to stay positive, in every Stokes component, different in each channel.
std::vector<double> random_light(std::uint32_t order) {
    std::mt19937 random(order);
    std::uniform_real_distribution<double> value(-1, 1);
    std::vector<double> out;
    for (int channel = 0; channel < 2; ++channel) {
        for (std::uint32_t l = 0; l <= order; ++l) {
            for (std::uint32_t m = 0; m < 2 * l + 1; ++m) {
                for (int p = 0; p < 4; ++p) {
                    const bool exists = l >= 2 || p == 0 || p == 3;
                    out.push_back(l == 0 && p == 0 ? 10 : exists ? value(random) / (1 + 0.3 * l) : 0);
                }
            }
        }
    }
    return out;
}

// A camera whose image is the middle of a plate, seen at an angle to its normal.
nicol_camera camera_on(const Plate& plate, double tilt, double turn) {
    const double s = 3 * std::sin(tilt);
    const Vector origin =
        sum(1 + 3 * std::cos(tilt), plate.normal, s * std::cos(turn), plate.x, s * std::sin(turn), plate.y);
    const double up[] = {0.3, 0.9, 0.1};
    nicol_camera camera = NICOL_CAMERA_INIT;
    OK(nicol_camera_look_at(&camera, origin.data(), plate.normal.data(), up));
    camera.projection = NICOL_PROJECTION_ORTHOGRAPHIC;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 2; ++column) camera.to_world[4 * row + column] *= 0.005;
    return camera;
}

// Two channels of Stokes vectors for each of some points on the sphere.
std::vector<float> points(nicol_context context, std::uint32_t order, nicol_method method,
                          std::int32_t samples) {
    const std::vector<double> coefficients = random_light(order);
    nicol_environment environment = nullptr;
    OK(nicol_environment_create_psh(context, order, 2, coefficients.data(), coefficients.size(),
                                    &environment));
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    plastic.alpha = 0.4F;
    plastic.diffuse_reflectance = spectrum({0.3F, 0.6F});
    nicol_material material = nullptr;
    OK(nicol_material_create_pplastic(context, &plastic, &material));
    const nicol_mesh mesh = touching_plates(context);
    nicol_scene scene = simple_scene(context, environment, mesh, material);
    nicol_framebuffer framebuffer = nullptr;
    OK(nicol_framebuffer_create(context, 1, 1, 2, &framebuffer));

    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.method = method;
    options.order_low = options.order_high = static_cast<std::int32_t>(order);
    options.samples = samples;
    std::vector<float> all;
    for (int i = 0; i < plates; ++i) {
        const nicol_camera camera = camera_on(Plate(i), 0.1 * i, 1.7 * i);
        OK(nicol_render(scene, &camera, &options, framebuffer));
        const std::vector<float> point = read_all(framebuffer);
        all.insert(all.end(), point.begin(), point.end());
    }
    OK(nicol_framebuffer_release(framebuffer));
    OK(nicol_scene_release(scene));
    OK(nicol_mesh_release(mesh));
    OK(nicol_material_release(material));
    OK(nicol_environment_release(environment));
    return all;
}

// Of each Stokes component, relative to its own root mean square.
std::array<double, 4> relative_rmse(const std::vector<float>& found, const std::vector<float>& truth) {
    REQUIRE(found.size() == truth.size());
    std::array<double, 4> error{}, size{};
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double t = static_cast<double>(truth[i]);
        error[i % 4] += std::pow(static_cast<double>(found[i]) - t, 2);
        size[i % 4] += t * t;
    }
    for (std::size_t p = 0; p < 4; ++p) error[p] = std::sqrt(error[p] / size[p]);
    return error;
}

}  // namespace

TEST_CASE("factored is the reference under light of its order, to 2e-4") {
    for (const std::uint32_t order : {4U, 9U}) {
        CAPTURE(order);
        const nicol_context context = make_context(NICOL_BACKEND_OSMESA);
        const std::vector<float> truth = points(context, order, NICOL_METHOD_REFERENCE, 1 << 16);
        OK(nicol_context_release(context));
        on_every_backend([&](nicol_context each) {
            const auto error = relative_rmse(points(each, order, NICOL_METHOD_FACTORED, 0), truth);
            for (std::size_t p = 0; p < 4; ++p) {
                CAPTURE(p);
                CHECK(error[p] < 2e-4);
            }
        });
    }
}
