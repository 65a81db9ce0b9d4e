// SPDX-License-Identifier: MIT
// Tests of meshes from caller arrays to the image.
#include "capi.hpp"
#include "harmonics/operator.hpp"
#include "material/psh_matrix_file.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t edge = 32;

// Arrays of squares of side 2, each divided into 4 x 4 cells.
struct Arrays {
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<std::uint32_t> indices;

    // Adds a square spanned by u and v, whose front and normals point along u x v.
    void add_square(const glm::vec3& centre, const glm::vec3& u, const glm::vec3& v) {
        const glm::vec3 n = glm::cross(u, v);
        const auto first = static_cast<std::uint32_t>(positions.size() / 3);
        for (std::uint32_t i = 0; i < 25; ++i) {
            const float a = 0.5F * static_cast<float>(i % 5) - 1, b = 0.5F * static_cast<float>(i / 5) - 1;
            const glm::vec3 position = centre + a * u + b * v;
            positions.insert(positions.end(), {position.x, position.y, position.z});
            normals.insert(normals.end(), {n.x, n.y, n.z});
            const std::uint32_t at = first + i;
            if (i % 5 < 4 && i < 20) indices.insert(indices.end(), {at, at + 1, at + 6, at, at + 6, at + 5});
        }
    }

    [[nodiscard]] nicol_mesh_data data() const {
        nicol_mesh_data out = mesh_over(positions, indices);
        out.normals = normals.empty() ? nullptr : normals.data();
        return out;
    }
};

// Returns a floor and a wall that shadow each other.
Arrays corner() {
    Arrays a;
    a.add_square({0, -1, 0}, {0, 0, 1}, {1, 0, 0});
    a.add_square({0, 0, -1}, {1, 0, 0}, {0, 1, 0});
    return a;
}

// A context, light and a material for rendering meshes.
struct Studio {
    Owned<nicol_context> context{make_context(NICOL_BACKEND_AUTOMATIC)};
    Owned<nicol_environment> environment{clear_sky(context, {1, 1, 1})};
    Owned<nicol_material> material;
    nicol_render_options options = plain_options();

    Studio() {
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.alpha = 0.2F;
        OK(nicol_material_create_pplastic(context, &plastic, &material));
        options.bake_directions = 512;
    }

    // Returns the image as [channel][pixel][component], seen from 4 units away, slightly above and to the
    // side.
    [[nodiscard]] std::vector<float> image(const Arrays& arrays, double unit = 1) const {
        const nicol_mesh_data data = arrays.data();
        const Owned mesh(make(nicol_mesh_create, context, &data));
        const Owned scene(simple_scene(context, environment, mesh, material));
        const Owned framebuffer(framebuffer_of(context, edge, edge, 3));
        nicol_camera camera = camera_at(unit * glm::dvec3(0.3, 0.5, 4));
        camera.near_clip = 0.01 * unit;
        camera.far_clip = 100 * unit;
        OK(nicol_render(scene, &camera, &options, framebuffer));
        std::vector<float> all = read_all(framebuffer);
        CHECK(std::isfinite(largest(all)));
        return all;
    }
};

float middle(const std::vector<float>& image) {
    return image[4 * (edge / 2 * edge + edge / 2)];
}

}  // namespace

CONTEXT_TEST_CASE("a mesh tells its size and copies its arrays") {
    Arrays arrays = corner();
    const nicol_mesh_data data = arrays.data();
    const Owned mesh(make(nicol_mesh_create, context, &data));
    arrays.positions.assign(arrays.positions.size(), NAN);
    arrays.indices.assign(arrays.indices.size(), 99);
    const Owned box(cube(context)), ball(sphere(context));
    std::uint32_t vertices = 7, triangles = 7;
    OK(nicol_mesh_get_size(mesh, &vertices, &triangles));
    CHECK((vertices == 50 && triangles == 64));
    OK(nicol_mesh_get_size(box, &vertices, &triangles));
    CHECK(triangles >= 12);
    OK(nicol_mesh_get_size(ball, &vertices, &triangles));
    CHECK(vertices >= 1000);
}

CONTEXT_TEST_CASE("files of meshes, light and scenes are read, or refused by name") {
    const TemporaryFolder folder;
    for (const char* name : {"text.exr", "text.ply", "text.xml"}) folder.write(name, "no such thing");
    for (const auto& [name, code] :
         {std::pair("absent", NICOL_ERROR_FILE_NOT_FOUND), std::pair("text", NICOL_ERROR_INVALID_FILE)}) {
        const std::string exr = std::string(name) + ".exr", ply = std::string(name) + ".ply",
                          xml = std::string(name) + ".xml";
        nicol_environment environment = marker<nicol_environment>();
        nicol_mesh mesh = marker<nicol_mesh>();
        nicol_scene scene = marker<nicol_scene>();
        FAILS(nicol_environment_load(context, folder.file(exr).c_str(), nullptr, &environment), code, exr);
        FAILS(nicol_mesh_load(context, folder.file(ply).c_str(), &mesh), code, ply);
        FAILS(nicol_scene_load(context, folder.file(xml).c_str(), nullptr, 0, &scene), code, xml);
        CHECK(environment == marker<nicol_environment>());
        CHECK(mesh == marker<nicol_mesh>());
        CHECK(scene == marker<nicol_scene>());
    }
    const std::string obj = folder.write("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Owned mesh(make(nicol_mesh_load, context, obj.c_str()));
}

TEST_CASE(
    "normals are made from the faces where there are none, and faces that are there twice change nothing") {
    const Studio studio;
    const Arrays given = corner();
    const auto truth = studio.image(given);
    CHECK(middle(truth) > 0.01F);
    Arrays twice = given, zero = given, some = given, none = given;
    twice.indices.insert(twice.indices.end(), given.indices.begin(), given.indices.end());
    CHECK(studio.image(twice) == truth);
    none.normals.clear();
    std::ranges::fill(zero.normals, 0.0F);
    for (std::size_t i = 0; i < some.normals.size(); ++i)
        if (i / 3 % 3 == 0) some.normals[i] = 0;
    for (const Arrays& each : {zero, some, none})
        CHECK(largest_difference(studio.image(each), truth) < 1e-6F);
    // Normals that oppose their faces still give an image, even if interpolated normals cancel.
    Arrays inverted = given, mixed = given;
    for (float& n : inverted.normals) n = -n;
    for (std::size_t i = 0; i < mixed.normals.size(); ++i)
        if (i / 3 % 2 == 0) mixed.normals[i] *= -1;
    for (const Arrays& each : {inverted, mixed}) static_cast<void>(studio.image(each));
}

TEST_CASE("a tiny object may stand on a huge one") {
    const Studio studio;
    Arrays together = corner();
    for (float& p : together.positions) p *= 1e7F;
    const std::size_t large = together.positions.size();
    together.add_square({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (std::size_t i = large; i < together.positions.size(); ++i) together.positions[i] *= 1e-7F;
    for (const double unit : {1e7, 1e-7}) static_cast<void>(studio.image(together, unit));
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
    OK(nicol_material_load_psh(studio.context, folder.file("small.npz").c_str(), nullptr, &studio.material));
    studio.options.shadows = 0;  // shadows would mix orders
    const auto image = [&](nicol_method method, std::uint32_t low, std::uint32_t high,
                           nicol_high_orders form) {
        studio.options.method = method;
        studio.options.order_low = low;
        studio.options.order_high = high;
        studio.options.high_orders = form;
        return studio.image(corner());
    };
    const auto truth = image(NICOL_METHOD_FACTORED, order, 0, NICOL_HIGH_ORDERS_NONE);
    CHECK(middle(truth) != 0);
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE}) {
        CAPTURE(method);
        CHECK(largest_difference(image(method, 8, 0, NICOL_HIGH_ORDERS_NONE), truth) < 1e-4F);
        for (const nicol_high_orders form : {NICOL_HIGH_ORDERS_SPLIT, NICOL_HIGH_ORDERS_CONVOLUTION})
            CHECK(largest_difference(image(method, order, 9, form), truth) < 1e-4F);
    }
}

CONTEXT_TEST_CASE("tangents, an angle and a texture of directions turn brushed metal alike") {
    const float positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    const float texcoords[] = {0, 1, 1, 1, 1, 0, 0, 0};
    const float angle = 0.6F, cosine = std::cos(angle), sine = std::sin(angle);
    std::vector<float> tangents;
    for (int corner = 0; corner < 4; ++corner) tangents.insert(tangents.end(), {3 * cosine, 3 * sine, 0, 1});
    nicol_mesh_data data = mesh_over(positions, indices);
    data.texcoords = texcoords;
    const Owned plain(make(nicol_mesh_create, context, &data));
    data.tangents = tangents.data();
    const Owned turned(make(nicol_mesh_create, context, &data));

    nicol_conductor parameters = NICOL_CONDUCTOR_INIT;
    parameters.alpha_u = 0.05F;
    parameters.alpha_v = 0.4F;
    const Owned metal(make(nicol_material_create_conductor, context, &parameters));
    const std::vector<float> direction{0.5F + 0.5F * cosine, 0.5F + 0.5F * sine, 1};
    const nicol_texture_image image = image_of_texels(direction, 1, 1, 3, NICOL_TEXEL_FLOAT32);
    const Owned directions(make(nicol_texture_create_image, context, &image, nullptr));
    const Owned by_angle(
        make(nicol_material_create_rotated, context, metal, nullptr, static_cast<double>(angle)));
    const Owned by_texture(make(nicol_material_create_rotated, context, metal, directions, 0.0));

    const Owned sky(clear_sky(context, {1, 1, 1}));
    const auto picture = [&](nicol_mesh mesh, nicol_material material) {
        const Owned scene(simple_scene(context, sky, mesh, material));
        const Owned framebuffer(framebuffer_of(context, 8, 8, 3));
        const nicol_camera camera = front_camera();
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.method = NICOL_METHOD_REFERENCE;
        options.samples = 16;
        OK(nicol_render(scene, &camera, &options, framebuffer));
        return read_plane(framebuffer, NICOL_PLANE_S0, 0);
    };
    const std::vector<float> expected = picture(turned, metal);
    CHECK(largest_difference(picture(plain, metal), expected) > 0.02);
    CHECK(largest_difference(picture(plain, by_angle), expected) < 1e-4);
    CHECK(largest_difference(picture(plain, by_texture), expected) < 1e-4);
}
