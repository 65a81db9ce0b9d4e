// SPDX-License-Identifier: MIT
// Environments, materials and meshes: what is taken and what is refused.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "capi.hpp"

using namespace capi_test;

namespace {

void count_call(void* user) {
    ++*static_cast<int*>(user);
}

// A 4 x 3 image of three channels whose rows lie `stride` floats apart.
struct Pixels {
    std::vector<float> values;
    nicol_image image = NICOL_IMAGE_INIT;
    int released = 0;

    explicit Pixels(std::uint32_t components = 1, std::size_t stride = 0) {
        const std::size_t row = std::size_t{4} * 3 * components;
        if (stride == 0) stride = row;
        // Between the rows lies what must not be read.
        values.assign(stride * 2 + row, std::numeric_limits<float>::quiet_NaN());
        for (std::size_t y = 0; y < 3; ++y) {
            for (std::size_t i = 0; i < row; ++i) {
                const bool intensity = i % components == 0;
                values[y * stride + i] = intensity ? 1 + 0.1F * static_cast<float>(y * row + i) : 0.2F;
            }
        }
        image.width = 4;
        image.height = 3;
        image.channels = 3;
        image.components = components;
        image.pixels = values.data();
        image.row_stride = stride == row ? 0 : stride * sizeof(float);
        image.byte_size = values.size() * sizeof(float);
        image.release = count_call;
        image.release_user = &released;
    }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;
};

// What an empty scene shows of an environment.
std::vector<float> image_of(nicol_context context, nicol_environment environment) {
    nicol_scene scene = nullptr;
    OK(nicol_scene_create(context, &scene));
    OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
    std::uint32_t channels = 0;
    OK(nicol_scene_get_channels(scene, &channels));
    nicol_framebuffer framebuffer = nullptr;
    OK(nicol_framebuffer_create(context, 16, 12, channels, &framebuffer));
    const nicol_camera camera = front_camera();
    OK(nicol_render(scene, &camera, nullptr, framebuffer));
    std::vector<float> all = read_all(framebuffer);
    OK(nicol_framebuffer_release(framebuffer));
    OK(nicol_scene_release(scene));
    return all;
}

// Expects a refusal that leaves the output and calls the release callback once.
void refused(nicol_context context, Pixels& pixels, const char* text,
             nicol_result code = NICOL_ERROR_INVALID_ARGUMENT) {
    nicol_environment environment = marker<nicol_environment>();
    FAILS(nicol_environment_create_image(context, &pixels.image, &environment), code, text);
    CHECK(environment == marker<nicol_environment>());
    CHECK(pixels.released == 1);
    pixels.released = 0;
}

}  // namespace

TEST_CASE("rows may lie apart, and what lies between them is not read") {
    on_every_backend([](nicol_context context) {
        for (const std::uint32_t components : {1U, 4U}) {
            Pixels tight(components), loose(components, std::size_t{4} * 3 * components + 5);
            Owned<nicol_environment> a, b;
            OK(nicol_environment_create_image(context, &tight.image, &a));
            OK(nicol_environment_create_image(context, &loose.image, &b));
            CHECK(tight.released == 1);
            CHECK(loose.released == 1);
            // The pixels are no longer needed.
            tight.values.assign(tight.values.size(), 0);
            loose.values.assign(loose.values.size(), 0);
            const std::vector<float> image = image_of(context, a);
            CHECK(image == image_of(context, b));
            CHECK(image[0] > 0);
            CHECK((image[1] != 0) == (components == 4));
        }
        Pixels quiet;
        quiet.image.release = nullptr;
        nicol_environment environment = nullptr;
        OK(nicol_environment_create_image(context, &quiet.image, &environment));
        OK(nicol_environment_release(environment));
        CHECK(quiet.released == 0);
    });
}

TEST_CASE("an image that cannot be taken is given back") {
    on_every_backend([](nicol_context context) {
        Pixels pixels;
        const nicol_image good = pixels.image;
        const auto with = [&](auto change, const char* text) {
            pixels.image = good;
            change(pixels.image);
            refused(context, pixels, text);
        };
        with([](nicol_image& i) { i.byte_size -= 1; }, "byte_size");
        with([](nicol_image& i) { i.byte_size = 0; }, "byte_size");
        with([](nicol_image& i) { i.row_stride = 44; }, "row_stride");
        with([](nicol_image& i) { i.row_stride = 50; }, "row_stride");
        with([](nicol_image& i) { i.row_stride = 96; }, "byte_size");
        with([](nicol_image& i) { i.row_stride = UINT64_MAX - 3; }, "row_stride");
        with([](nicol_image& i) { i.row_stride = std::uint64_t{1} << 63; }, "row_stride");
        with([](nicol_image& i) { i.width = 0; }, "width");
        with([](nicol_image& i) { i.width = NICOL_MAX_SIZE + 1; }, "width");
        with([](nicol_image& i) { i.height = 1; }, "height");
        with([](nicol_image& i) { i.height = UINT32_MAX; }, "height");
        with([](nicol_image& i) { i.channels = 0; }, "channels");
        with([](nicol_image& i) { i.channels = NICOL_MAX_CHANNELS + 1; }, "channels");
        with([](nicol_image& i) { i.components = 0; }, "components");
        with([](nicol_image& i) { i.components = 3; }, "components");
        with([](nicol_image& i) { i.pixels = nullptr; }, "pixels");
        // Larger than any image may be, and the caller even claims to have it.
        with(
            [](nicol_image& i) {
                i.width = i.height = NICOL_MAX_SIZE;
                i.channels = NICOL_MAX_CHANNELS;
                i.components = 4;
                i.byte_size = UINT64_MAX;
            },
            "16384");
        pixels.image = good;
        for (const float bad : {NAN, INFINITY, -300.0F}) {
            const float before = pixels.values[19];  // between the poles, where it has a weight
            pixels.values[19] = bad;
            refused(context, pixels, "");
            pixels.values[19] = before;
        }
        refused(nullptr, pixels, "nicol_context", NICOL_ERROR_INVALID_HANDLE);
        CHECK(nicol_environment_create_image(context, &pixels.image, nullptr) ==
              NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(pixels.released == 1);
        // Nothing can be said of a struct of no size.
        pixels.image.struct_size = 0;
        CHECK(nicol_environment_create_image(context, &pixels.image, nullptr) ==
              NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(pixels.released == 1);
    });
}

TEST_CASE("even light without a radiance is 1 in one channel") {
    on_every_backend([](nicol_context context) {
        Owned<nicol_environment> environment;
        OK(nicol_environment_create_constant(context, nullptr, &environment));
        std::array<double, 4> mean{};
        OK(nicol_psh_project_environment(environment, 0, mean.data(), mean.size()));
        CHECK(mean[0] == doctest::Approx(std::sqrt(4.0 * std::numbers::pi)));
    });
}

TEST_CASE("light that cannot be is refused by name") {
    on_every_backend([](nicol_context context) {
        nicol_environment environment = marker<nicol_environment>();
        const auto constant = [&](const nicol_spectrum* radiance, nicol_environment* out) {
            return nicol_environment_create_constant(context, radiance, out);
        };
        nicol_spectrum value = spectrum({1});
        for (const std::uint32_t count : {17U, UINT32_MAX}) {
            value.count = count;
            FAILS(constant(&value, &environment), NICOL_ERROR_INVALID_ARGUMENT, "radiance.count");
        }
        for (const float bad : {-1.0F, NAN, INFINITY}) {
            value = spectrum({1, bad, 1});
            FAILS(constant(&value, &environment), NICOL_ERROR_INVALID_ARGUMENT, "radiance");
        }
        nicol_sky sky = NICOL_SKY_INIT;
        for (const float bad : {1.01F, NAN, INFINITY}) {
            sky.dop_max = bad;
            FAILS(nicol_environment_create_sky(context, &sky, &environment), NICOL_ERROR_INVALID_ARGUMENT,
                  "dop_max");
        }
        for (const float bad : {NAN, INFINITY}) {
            sky = NICOL_SKY_INIT;
            sky.sun_direction[1] = bad;
            FAILS(nicol_environment_create_sky(context, &sky, &environment), NICOL_ERROR_INVALID_ARGUMENT,
                  "sun_direction");
        }
        sky = NICOL_SKY_INIT;
        sky.radiance = spectrum({1, -1, 1});
        FAILS(nicol_environment_create_sky(context, &sky, &environment), NICOL_ERROR_INVALID_ARGUMENT,
              "radiance");
        sky.radiance.count = 99;
        FAILS(nicol_environment_create_sky(context, &sky, &environment), NICOL_ERROR_INVALID_ARGUMENT,
              "sky->radiance.count");
        CHECK(environment == marker<nicol_environment>());
    });
}

TEST_CASE("zero in a sky means its default, and a negative degree of polarization none") {
    on_every_backend([](nicol_context context) {
        nicol_environment standard = nullptr, spelled = nullptr, unpolarized = nullptr;
        nicol_sky sky = NICOL_SKY_INIT;
        OK(nicol_environment_create_sky(context, &sky, &standard));
        sky.dop_max = 0.8F;
        sky.sun_direction[1] = 2;
        sky.radiance = spectrum({1, 1, 1});
        OK(nicol_environment_create_sky(context, &sky, &spelled));
        sky.dop_max = -1;
        OK(nicol_environment_create_sky(context, &sky, &unpolarized));
        const std::vector<float> a = image_of(context, standard), b = image_of(context, spelled);
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(1e-5));
        const std::vector<float> c = image_of(context, unpolarized);
        REQUIRE(a.size() == c.size());
        float largest = 0;
        for (std::size_t i = 0; i < c.size(); i += 4) {
            CHECK(c[i] == doctest::Approx(a[i]).epsilon(1e-5));
            CHECK(c[i + 1] == 0);
            CHECK(c[i + 2] == 0);
            largest = std::max({largest, std::abs(a[i + 1]), std::abs(a[i + 2])});
        }
        CHECK(largest > 0.1F);
        for (const nicol_environment environment : {standard, spelled, unpolarized})
            OK(nicol_environment_release(environment));
    });
}

TEST_CASE("materials out of range are refused by name") {
    on_every_backend([](nicol_context context) {
        nicol_material material = marker<nicol_material>();
        const auto with = [&](auto change, const char* text) {
            nicol_pplastic parameters = NICOL_PPLASTIC_INIT;
            change(parameters);
            FAILS(nicol_material_create_pplastic(context, &parameters, &material),
                  NICOL_ERROR_INVALID_ARGUMENT, text);
        };
        with([](nicol_pplastic& p) { p.distribution = 2; }, "distribution");
        with([](nicol_pplastic& p) { p.int_ior = -1.5F; }, "int_ior");
        with([](nicol_pplastic& p) { p.int_ior = NAN; }, "int_ior");
        with([](nicol_pplastic& p) { p.ext_ior = INFINITY; }, "ext_ior");
        with([](nicol_pplastic& p) { p.alpha = 0.0005F; }, "alpha");
        with([](nicol_pplastic& p) { p.alpha = 1.5F; }, "alpha");
        with([](nicol_pplastic& p) { p.alpha = NAN; }, "alpha");
        with([](nicol_pplastic& p) { p.diffuse_reflectance = spectrum({1.1F}); }, "diffuse_reflectance");
        with([](nicol_pplastic& p) { p.diffuse_reflectance.count = 17; }, "diffuse_reflectance");
        with([](nicol_pplastic& p) { p.specular_reflectance = spectrum({-0.1F}); }, "specular_reflectance");
        with(
            [](nicol_pplastic& p) {
                p.specular_reflectance = spectrum({0.5F, NAN, 0.5F});
            },
            "specular_reflectance");
        with(
            [](nicol_pplastic& p) {
                p.diffuse_reflectance = spectrum({0.5F, 0.5F});
                p.specular_reflectance = spectrum({0.5F, 0.5F, 0.5F});
            },
            "reflectance");
        for (const float bad : {-0.1F, 1.1F, NAN}) {
            const nicol_spectrum value = spectrum({bad});
            FAILS(nicol_material_create_diffuse(context, &value, &material), NICOL_ERROR_INVALID_ARGUMENT,
                  "reflectance");
        }
        nicol_spectrum many = spectrum({0.5F});
        many.count = 17;
        FAILS(nicol_material_create_diffuse(context, &many, &material), NICOL_ERROR_INVALID_ARGUMENT,
              "reflectance.count");
        CHECK(material == marker<nicol_material>());
    });
}

TEST_CASE("meshes that are none are refused by name") {
    on_every_backend([](nicol_context context) {
        nicol_mesh mesh = marker<nicol_mesh>();
        float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
        std::uint32_t indices[] = {0, 1, 2};
        const auto with = [&](auto change, const char* text) {
            nicol_mesh_data data = NICOL_MESH_DATA_INIT;
            data.vertex_count = 3;
            data.triangle_count = 1;
            data.positions = positions;
            data.normals = normals;
            data.indices = indices;
            change(data);
            FAILS(nicol_mesh_create(context, &data, &mesh), NICOL_ERROR_INVALID_ARGUMENT, text);
        };
        with([](nicol_mesh_data& d) { d.positions = nullptr; }, "positions");
        with([](nicol_mesh_data& d) { d.indices = nullptr; }, "indices");
        with([](nicol_mesh_data& d) { d.reserved = 1; }, "reserved");
        with([](nicol_mesh_data& d) { d.vertex_count = 0; }, "data");
        with([](nicol_mesh_data& d) { d.vertex_count = 2; }, "data");
        with([](nicol_mesh_data& d) { d.triangle_count = 0; }, "data");
        indices[2] = 3;
        with([](nicol_mesh_data&) {}, "data");
        indices[2] = 2;
        positions[4] = NAN;
        with([](nicol_mesh_data&) {}, "data");
        positions[4] = 0;
        normals[0] = INFINITY;
        with([](nicol_mesh_data&) {}, "data");
        CHECK(mesh == marker<nicol_mesh>());
    });
}

TEST_CASE("a mesh tells its size and copies its arrays") {
    on_every_backend([](nicol_context context) {
        std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
        std::vector<std::uint32_t> indices{0, 1, 2, 2, 1, 3};
        nicol_mesh_data data = NICOL_MESH_DATA_INIT;
        data.vertex_count = 4;
        data.triangle_count = 2;
        data.positions = positions.data();
        data.indices = indices.data();
        nicol_mesh mesh = nullptr;
        OK(nicol_mesh_create(context, &data, &mesh));
        positions.assign(12, NAN);
        indices.assign(6, 99);
        std::uint32_t vertices = 7, triangles = 7;
        CHECK(vertices == 7);
        CHECK(triangles == 7);
        OK(nicol_mesh_get_size(mesh, &vertices, &triangles));
        CHECK(vertices == 4);
        CHECK(triangles == 2);
        OK(nicol_mesh_release(mesh));
        OK(nicol_mesh_create_cube(context, &mesh));
        OK(nicol_mesh_get_size(mesh, &vertices, &triangles));
        CHECK(triangles >= 12);
        OK(nicol_mesh_release(mesh));
        OK(nicol_mesh_create_sphere(context, &mesh));
        OK(nicol_mesh_get_size(mesh, &vertices, &triangles));
        CHECK(vertices >= 1000);
        OK(nicol_mesh_release(mesh));
    });
}

TEST_CASE("files that are not there or not what they say") {
    on_every_backend([](nicol_context context) {
        const TemporaryFolder folder;
        nicol_environment environment = marker<nicol_environment>();
        nicol_mesh mesh = marker<nicol_mesh>();
        nicol_scene scene = marker<nicol_scene>();
        FAILS(nicol_environment_load(context, folder.file("absent.exr").c_str(), nullptr, &environment),
              NICOL_ERROR_FILE_NOT_FOUND, "absent.exr");
        FAILS(nicol_mesh_load(context, folder.file("absent.ply").c_str(), &mesh), NICOL_ERROR_FILE_NOT_FOUND,
              "absent.ply");
        FAILS(nicol_scene_load(context, folder.file("absent.xml").c_str(), nullptr, 0, &scene),
              NICOL_ERROR_FILE_NOT_FOUND, "absent.xml");
        const std::string exr = folder.write("text.exr", "no image");
        const std::string ply = folder.write("text.ply", "ply\nno mesh");
        const std::string xml = folder.write("text.xml", "<scene version='3.0.0'><shape");
        FAILS(nicol_environment_load(context, exr.c_str(), nullptr, &environment), NICOL_ERROR_INVALID_FILE,
              "text.exr");
        FAILS(nicol_mesh_load(context, ply.c_str(), &mesh), NICOL_ERROR_INVALID_FILE, "text.ply");
        FAILS(nicol_scene_load(context, xml.c_str(), nullptr, 0, &scene), NICOL_ERROR_INVALID_FILE,
              "text.xml");
        CHECK(environment == marker<nicol_environment>());
        CHECK(mesh == marker<nicol_mesh>());
        CHECK(scene == marker<nicol_scene>());
        const std::string obj = folder.write("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        OK(nicol_mesh_load(context, obj.c_str(), &mesh));
        OK(nicol_mesh_release(mesh));
    });
}
