// SPDX-License-Identifier: MIT
// Meshes as they come, from their arrays to the image.
#include <algorithm>
#include <array>
#include <cmath>

#include "capi.hpp"
#include "harmonics/operator.hpp"
#include "material/psh_matrix_file.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t edge = 32;

// Squares of side 2 about the origin, one after another, each divided into cells.
struct Arrays {
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<std::uint32_t> indices;

    // Spanned by u and v; its front and its normals towards u x v.
    void add_square(const std::array<float, 3>& centre, const std::array<float, 3>& u,
                    const std::array<float, 3>& v, int cells = 4) {
        const std::array<float, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                     u[0] * v[1] - u[1] * v[0]};
        const auto first = static_cast<std::uint32_t>(positions.size() / 3);
        const auto row = static_cast<std::uint32_t>(cells + 1);
        for (int j = 0; j <= cells; ++j) {
            for (int i = 0; i <= cells; ++i) {
                const float a = 2 * static_cast<float>(i) / static_cast<float>(cells) - 1;
                const float b = 2 * static_cast<float>(j) / static_cast<float>(cells) - 1;
                for (std::size_t k = 0; k < 3; ++k) positions.push_back(centre[k] + a * u[k] + b * v[k]);
                normals.insert(normals.end(), n.begin(), n.end());
            }
        }
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            for (std::uint32_t i = 0; i + 1 < row; ++i) {
                const std::uint32_t at = first + j * row + i;
                indices.insert(indices.end(), {at, at + 1, at + row + 1, at, at + row + 1, at + row});
            }
        }
    }

    [[nodiscard]] nicol_mesh_data data() const {
        nicol_mesh_data out = NICOL_MESH_DATA_INIT;
        out.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
        out.triangle_count = static_cast<std::uint32_t>(indices.size() / 3);
        out.positions = positions.data();
        out.normals = normals.data();
        out.indices = indices.data();
        return out;
    }
};

// A floor and a wall that shadow each other.
Arrays corner() {
    Arrays a;
    a.add_square({0, -1, 0}, {0, 0, 1}, {1, 0, 0});
    a.add_square({0, 0, -1}, {1, 0, 0}, {0, 1, 0});
    return a;
}

// Without its side towards +z.
Arrays open_cube() {
    Arrays a;
    a.add_square({0, 0, -1}, {0, 1, 0}, {1, 0, 0});
    a.add_square({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    a.add_square({-1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    a.add_square({0, 1, 0}, {0, 0, 1}, {1, 0, 0});
    a.add_square({0, -1, 0}, {1, 0, 0}, {0, 0, 1});
    return a;
}

// A context, light and a material, and images of meshes with them.
struct Studio {
    nicol_context context = make_context(NICOL_BACKEND_AUTOMATIC);
    nicol_environment environment = nullptr;
    nicol_material material = nullptr;
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;

    Studio() {
        nicol_sky sky = NICOL_SKY_INIT;
        sky.sun_direction[0] = 1;
        sky.sun_direction[1] = 1;
        sky.sun_direction[2] = 1;
        OK(nicol_environment_create_sky(context, &sky, &environment));
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.alpha = 0.2F;
        OK(nicol_material_create_pplastic(context, &plastic, &material));
        options.bake_directions = 512;
    }
    ~Studio() {
        CHECK(nicol_material_release(material) == NICOL_OK);
        CHECK(nicol_environment_release(environment) == NICOL_OK);
        CHECK(nicol_context_release(context) == NICOL_OK);
    }
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    void set_material(nicol_material next) {
        OK(nicol_material_release(material));
        material = next;
    }

    // [channel][pixel][component]; the camera stands 4 units before the origin, a little up and aside.
    [[nodiscard]] std::vector<float> image(const nicol_mesh_data& data, double unit = 1) const {
        nicol_mesh mesh = nullptr;
        OK(nicol_mesh_create(context, &data, &mesh));
        nicol_scene scene = simple_scene(context, environment, mesh, material);
        nicol_framebuffer framebuffer = nullptr;
        OK(nicol_framebuffer_create(context, edge, edge, 3, &framebuffer));
        nicol_camera camera = NICOL_CAMERA_INIT;
        const double origin[] = {0.3 * unit, 0.5 * unit, 4 * unit}, target[] = {0, 0, 0}, up[] = {0, 1, 0};
        OK(nicol_camera_look_at(&camera, origin, target, up));
        camera.near_clip = 0.01 * unit;
        camera.far_clip = 100 * unit;
        OK(nicol_render(scene, &camera, &options, framebuffer));
        std::vector<float> all = read_all(framebuffer);
        CHECK(std::ranges::all_of(all, [](float value) { return std::isfinite(value); }));
        OK(nicol_framebuffer_release(framebuffer));
        OK(nicol_scene_release(scene));
        OK(nicol_mesh_release(mesh));
        return all;
    }
    [[nodiscard]] std::vector<float> image(const Arrays& arrays, double unit = 1) const {
        return image(arrays.data(), unit);
    }
};

float middle(const std::vector<float>& image) {
    return image[4 * (edge / 2 * edge + edge / 2)];
}

float difference(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    float most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

}  // namespace

TEST_CASE("through a hole the inside of a surface is black, and is seen where it has two sides") {
    Studio studio;
    CHECK(middle(studio.image(open_cube())) == 0);
    nicol_material both = nullptr;
    OK(nicol_material_create_twosided(studio.context, studio.material, &both));
    studio.set_material(both);
    CHECK(middle(studio.image(open_cube())) > 0.01F);
}

TEST_CASE("normals against their faces make an image all the same") {
    const Studio studio;
    Arrays inverted = corner();
    for (float& n : inverted.normals) n = -n;
    (void)studio.image(inverted);
    // Some of them only, so that they cancel between vertices.
    Arrays mixed = corner();
    for (std::size_t i = 0; i < mixed.normals.size(); ++i)
        if (i / 3 % 2 == 0) mixed.normals[i] *= -1;
    (void)studio.image(mixed);
}

TEST_CASE("normals of no length are made from the faces") {
    const Studio studio;
    const Arrays given = corner();
    const auto truth = studio.image(given);
    CHECK(middle(truth) > 0.01F);
    Arrays zero = given;
    std::ranges::fill(zero.normals, 0.0F);
    CHECK(difference(studio.image(zero), truth) < 1e-6F);
    Arrays some = given;
    for (std::size_t i = 0; i < some.normals.size(); ++i)
        if (i / 3 % 3 == 0) some.normals[i] = 0;
    CHECK(difference(studio.image(some), truth) < 1e-6F);
    nicol_mesh_data none = given.data();
    none.normals = nullptr;
    CHECK(difference(studio.image(none), truth) < 1e-6F);
}

TEST_CASE("faces that are there twice change nothing") {
    const Studio studio;
    const Arrays once = corner();
    Arrays twice = once;
    twice.indices.insert(twice.indices.end(), once.indices.begin(), once.indices.end());
    CHECK(difference(studio.image(twice), studio.image(once)) == 0);
}

TEST_CASE("faces without area are refused, by number") {
    const Studio studio;
    for (const auto& corners : {std::array<std::uint32_t, 3>{0, 1, 0}, {0, 1, 2}}) {  // one in a row of cells
        Arrays flat = corner();
        const std::string face = "face " + std::to_string(flat.indices.size() / 3);
        flat.indices.insert(flat.indices.end(), corners.begin(), corners.end());
        const nicol_mesh_data data = flat.data();
        nicol_mesh mesh = nullptr;
        FAILS(nicol_mesh_create(studio.context, &data, &mesh), NICOL_ERROR_INVALID_ARGUMENT, face);
        CHECK(mesh == nullptr);
    }
}

TEST_CASE("the size of an object does not matter") {
    const Studio studio;
    const auto truth = studio.image(corner());
    for (const float unit : {1e-7F, 1e7F}) {
        CAPTURE(unit);
        Arrays sized = corner();
        for (float& p : sized.positions) p *= unit;
        const auto found = studio.image(sized, static_cast<double>(unit));
        // Edges may fall on the other side of a pixel's centre.
        std::size_t apart = 0;
        for (std::size_t i = 0; i < found.size(); ++i) apart += std::abs(found[i] - truth[i]) > 1e-4F ? 1 : 0;
        CHECK(apart < found.size() / 100);
    }
    // One of each in one scene: the small one stands on the large one.
    Arrays together = corner();
    for (float& p : together.positions) p *= 1e7F;
    const std::size_t large = together.positions.size();
    together.add_square({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (std::size_t i = large; i < together.positions.size(); ++i) together.positions[i] *= 1e-7F;
    (void)studio.image(together, 1e7);
    (void)studio.image(together, 1e-7);
}

TEST_CASE("a matrix of fewer orders than the light's reflects none of the others") {
    constexpr int order = 3;
    nicol::IsotropicMatrix matrix(order, order);
    for (int m = 0; m <= order; ++m)
        for (int l = m; l <= order; ++l)
            for (std::size_t p = 0; p < 4; ++p)
                if (l > 1 || p == 0 || p == 3) matrix.block(m, l, l)[5 * p] = 0.5 / (1 + l);
    const TemporaryFolder folder;
    nicol::write_psh_matrix(folder.file("small.npz"), std::vector{matrix});

    Studio studio;
    nicol_material small = nullptr;
    OK(nicol_material_load_psh(studio.context, folder.file("small.npz").c_str(), nullptr, &small));
    studio.set_material(small);
    studio.options.shadows = -1;  // which would mix orders
    const Arrays square = corner();
    studio.options.order_low = order;
    studio.options.high_orders = NICOL_HIGH_ORDERS_NONE;
    const auto truth = studio.image(square);
    CHECK(middle(truth) != 0);
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE}) {
        CAPTURE(method);
        studio.options.method = method;
        studio.options.order_low = 8;
        studio.options.high_orders = NICOL_HIGH_ORDERS_NONE;
        CHECK(difference(studio.image(square), truth) < 1e-4F);
        for (const nicol_high_orders form : {NICOL_HIGH_ORDERS_SPLIT, NICOL_HIGH_ORDERS_CONVOLUTION}) {
            CAPTURE(form);
            studio.options.order_low = order;
            studio.options.order_high = 9;
            studio.options.high_orders = form;
            CHECK(difference(studio.image(square), truth) < 1e-4F);
        }
        studio.options.order_high = 0;
    }
}
