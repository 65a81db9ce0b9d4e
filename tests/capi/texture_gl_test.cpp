// SPDX-License-Identifier: MIT
// Tests of textures from arrays and files to the image.
#include "capi.hpp"
#include "image/observer.hpp"

using namespace capi_test;
using doctest::Approx;

namespace {

constexpr std::uint32_t edge = 8;

/// Reflectances of a 2 x 2 image, first row first.
const std::array<std::array<float, 3>, 4> colors = {
    {{0.2F, 0.4F, 0.6F}, {1, 0, 0}, {0, 0.6F, 0}, {0.8F, 0.8F, 0.2F}}};

nicol_texture_options nearest() {
    nicol_texture_options options = NICOL_TEXTURE_OPTIONS_INIT;
    options.filter = NICOL_TEXTURE_FILTER_NEAREST;
    return options;
}

std::vector<float> color_values() {
    std::vector<float> values;
    for (const auto& color : colors) values.insert(values.end(), color.begin(), color.end());
    return values;
}

nicol_texture four_colors(nicol_context context) {
    const std::vector<float> values = color_values();
    const nicol_texture_image image = image_of_texels(values, 2, 2, 3, NICOL_TEXEL_FLOAT32);
    const nicol_texture_options options = nearest();
    return make(nicol_texture_create_image, context, &image, &options);
}

nicol_material diffuse_of(nicol_context context, nicol_texture texture) {
    const Owned white(diffuse(context, {1}));
    return make(nicol_material_create_scaled, context, white, texture);
}

/// Renders a square that fills the image under light of radiance 1. Returns s0: [channel][pixel].
std::vector<float> picture(nicol_context context, nicol_mesh mesh, nicol_material material) {
    const Owned light(constant_light(context, {1}));
    const Owned scene(simple_scene(context, light, mesh, material));
    std::uint32_t channels = 0;
    OK(nicol_scene_get_channels(scene, &channels));
    const Owned framebuffer(framebuffer_of(context, edge, edge, channels));
    nicol_camera camera = front_camera();
    camera.projection = NICOL_PROJECTION_ORTHOGRAPHIC;
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.method = NICOL_METHOD_REFERENCE;
    options.samples = 64;
    OK(nicol_render(scene, &camera, &options, framebuffer));
    std::vector<float> all;
    for (std::uint32_t c = 0; c < channels; ++c) {
        const std::vector<float> plane = read_plane(framebuffer, NICOL_PLANE_S0, c);
        all.insert(all.end(), plane.begin(), plane.end());
    }
    return all;
}

/// Checks the colour of every quarter of the image. v = 0 is at the bottom of Mitsuba's rectangle.
void check_quarters(const std::vector<float>& found, const std::array<int, 4>& texels = {2, 3, 0, 1}) {
    REQUIRE(found.size() == 3 * edge * edge);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const std::size_t x = 2 + 4 * (quarter % 2), y = 2 + 4 * (quarter / 2);
            const float wanted = colors[static_cast<std::size_t>(texels[quarter])][c];
            CAPTURES(c, quarter);
            CHECK(found[(c * edge + y) * edge + x] == Approx(wanted).epsilon(0.02));
        }
}

}  // namespace

CONTEXT_TEST_CASE("an image of any kind of number colours a surface") {
    const Owned mesh(rectangle(context));
    const auto picture_of = [&](const nicol_texture_image& image, std::uint32_t raw) {
        nicol_texture_options options = nearest();
        options.raw = raw;
        const Owned texture(make(nicol_texture_create_image, context, &image, &options));
        return picture(context, mesh, Owned(diffuse_of(context, texture)));
    };
    const std::vector<float> values = color_values();
    check_quarters(picture_of(image_of_texels(values, 2, 2, 3, NICOL_TEXEL_FLOAT32), 0));
    std::vector<std::uint8_t> bytes, encoded;
    std::vector<std::uint16_t> words;
    for (const float value : values) {
        bytes.push_back(static_cast<std::uint8_t>(std::lround(value * 255)));
        words.push_back(static_cast<std::uint16_t>(std::lround(value * 65535)));
        const double curve = value <= 0 ? 0 : 1.055 * std::pow(double(value), 1 / 2.4) - 0.055;
        encoded.push_back(static_cast<std::uint8_t>(std::lround(curve * 255)));
    }
    check_quarters(picture_of(image_of_texels(bytes, 2, 2, 3, NICOL_TEXEL_UINT8), 1));
    check_quarters(picture_of(image_of_texels(words, 2, 2, 3, NICOL_TEXEL_UINT16), 1));
    check_quarters(picture_of(image_of_texels(encoded, 2, 2, 3, NICOL_TEXEL_UINT8), 0));

    // The second image has a coverage channel and row gaps.
    std::vector<std::uint8_t> apart;
    for (std::size_t i = 0; i < 4; ++i) {
        apart.insert(apart.end(), bytes.begin() + static_cast<std::ptrdiff_t>(3 * i),
                     bytes.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
        apart.push_back(7);
        if (i == 1) apart.insert(apart.end(), {99, 99, 99});
    }
    nicol_texture_image image = image_of_texels(apart, 2, 2, 4, NICOL_TEXEL_UINT8);
    image.row_stride = 11;
    check_quarters(picture_of(image, 1));
}

CONTEXT_TEST_CASE("a file is the texture that its numbers are") {
    const TemporaryFolder folder;
    nicol::Observation png{.width = 2, .height = 2, .rgb = {}};
    for (const float value : color_values())
        png.rgb.push_back(static_cast<std::uint8_t>(std::lround(value * 255)));
    const std::string path = folder.file("a.png");
    nicol::write_png(path, nicol::png_of(png));
    nicol_texture_options options = nearest();
    options.raw = 1;
    const Owned mesh(rectangle(context));
    const Owned texture(make(nicol_texture_load, context, path.c_str(), &options));
    check_quarters(picture(context, mesh, Owned(diffuse_of(context, texture))));
    // This matrix rotates by 180 degrees about the middle.
    const double turned[] = {-1, 0, 1, 0, -1, 1, 0, 0, 1};
    std::copy_n(turned, 9, options.to_uv);
    const Owned other(make(nicol_texture_load, context, path.c_str(), &options));
    check_quarters(picture(context, mesh, Owned(diffuse_of(context, other))), {1, 0, 3, 2});
}

CONTEXT_TEST_CASE("checkerboards and vertex colours") {
    const Owned mesh(rectangle(context));
    const Owned plain(make(nicol_texture_create_checkerboard, context, nullptr, nullptr, nullptr));
    const std::vector<float> grey = picture(context, mesh, Owned(diffuse_of(context, plain)));
    REQUIRE(grey.size() == edge * edge);
    CHECK(grey[2 * edge + 2] == Approx(0.2).epsilon(0.02));
    CHECK(grey[6 * edge + 2] == Approx(0.4).epsilon(0.02));

    const nicol_spectrum color = spectrum({0.2F, 0.4F, 0.6F});
    const double to_uv[] = {0.5, 0, 0, 0, 0.5, 0, 0, 0, 1};  // a single square of the checkerboard
    const Owned one(make(nicol_texture_create_checkerboard, context, &color, nullptr, to_uv));
    const std::vector<float> square = picture(context, mesh, Owned(diffuse_of(context, one)));
    REQUIRE(square.size() == 3 * edge * edge);
    for (std::size_t i = 0; i < square.size(); ++i)
        CHECK(square[i] == Approx(color.values[i / (edge * edge)]).epsilon(0.02));

    const float positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    const float reds[] = {0, 0.5F, 0.5F, 1, 0.5F, 0.5F, 1, 0.5F, 0.5F, 0, 0.5F, 0.5F};
    const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    nicol_mesh_data data = mesh_over(positions, indices);
    data.colors = reds;
    const Owned painted(make(nicol_mesh_create, context, &data));
    const Owned vertex_colors(make(nicol_texture_create_vertex_colors, context));
    const std::vector<float> ramp = picture(context, painted, Owned(diffuse_of(context, vertex_colors)));
    for (std::size_t x = 0; x < edge; ++x)
        CHECK(ramp[3 * edge + x] == Approx((static_cast<double>(x) + 0.5) / edge).epsilon(0.1));
}

CONTEXT_TEST_CASE("faces have the colours that memory or a file gives them") {
    const float positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    const std::array<std::array<float, 3>, 2> of_faces = {{{0.2F, 0.4F, 0.6F}, {1, 0.8F, 0}}};
    nicol_mesh_data data = mesh_over(positions, indices);
    data.face_colors = of_faces[0].data();

    const TemporaryFolder folder;
    const auto header = [](const char* format, const char* type) {
        const std::string color = "property " + std::string(type) + " ";
        return "ply\nformat " + std::string(format) +
               " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 2\nproperty list uchar uint vertex_indices\n" +
               color + "red\n" + color + "green\n" + color + "blue\nend_header\n";
    };
    std::string binary = header("binary_little_endian", "float");
    const auto append = [&](const auto& values) {
        binary.append(reinterpret_cast<const char*>(std::data(values)), sizeof(values));
    };
    append(positions);
    for (std::size_t f = 0; f < 2; ++f) {
        binary += '\3';
        append(std::array{indices[3 * f], indices[3 * f + 1], indices[3 * f + 2]});
        append(of_faces[f]);
    }
    const std::string corners = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n";
    const std::string text = header("ascii", "uchar") + corners + "3 0 1 2 51 102 153\n3 0 2 3 255 204 0\n";
    const std::string off = "OFF\n4 2 5\n" + corners + "3 0 1 2  0.2 0.4 0.6\n3 0 2 3  255 204 0\n";
    const Owned colors(make(nicol_texture_create_face_colors, context));
    const Owned material(diffuse_of(context, colors));
    const Owned<nicol_mesh> meshes[] = {
        Owned(make(nicol_mesh_create, context, &data)),
        Owned(make(nicol_mesh_load, context, folder.write("binary.ply", binary).c_str())),
        Owned(make(nicol_mesh_load, context, folder.write("text.ply", text).c_str())),
        Owned(make(nicol_mesh_load, context, folder.write("a.off", off).c_str()))};
    for (const Owned<nicol_mesh>& mesh : meshes) {
        const std::vector<float> found = picture(context, mesh, material);
        REQUIRE(found.size() == 3 * edge * edge);
        // The first triangle lies below the diagonal from the lower left. Pixels on the diagonal show both.
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t y = 0; y < edge; ++y)
                for (std::size_t x = 0; x < edge; ++x)
                    if (x + y + 1 != edge)
                        CHECK(found[(c * edge + y) * edge + x] ==
                              Approx(of_faces[x + y + 1 > edge ? 0 : 1][c]).epsilon(0.02));
    }
}

CONTEXT_TEST_CASE("texture coordinates may have indices of their own") {
    const float positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    const float shared[] = {0, 0, 1, 0, 1, 1, 0, 1};
    // Equal coordinates with an unused entry in front and separate entries for each triangle.
    const float own[] = {9, 9, 0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1};
    const std::uint32_t own_indices[] = {1, 2, 3, 4, 5, 6};
    nicol_mesh_data data = mesh_over(positions, indices);
    data.texcoords = shared;
    const Owned texture(four_colors(context));
    const Owned material(diffuse_of(context, texture));
    const Owned plain(make(nicol_mesh_create, context, &data));
    check_quarters(picture(context, plain, material));
    data.texcoords = own;
    data.texcoord_count = 7;
    data.texcoord_indices = own_indices;
    const Owned with_seam(make(nicol_mesh_create, context, &data));
    check_quarters(picture(context, with_seam, material));
}

CONTEXT_TEST_CASE("texture coordinates of mesh files: v of OBJ points up, of PLY down") {
    const TemporaryFolder folder;
    const std::string obj = folder.write(
        "a.obj",
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
    const std::string ply = folder.write(
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property float u\nproperty float v\nelement face 1\nproperty list uchar int vertex_indices\n"
        "end_header\n-1 -1 0 0 0\n1 -1 0 1 0\n1 1 0 1 1\n-1 1 0 0 1\n4 0 1 2 3\n");
    const Owned texture(four_colors(context));
    const Owned material(diffuse_of(context, texture));
    check_quarters(picture(context, Owned(make(nicol_mesh_load, context, obj.c_str())), material),
                   {0, 1, 2, 3});
    check_quarters(picture(context, Owned(make(nicol_mesh_load, context, ply.c_str())), material));
}

CONTEXT_TEST_CASE("textures of one value are the numbers that they stand for") {
    const Owned mesh(rectangle(context));
    const auto constant = [&](const std::vector<float>& value) {
        const nicol_texture_image image =
            image_of_texels(value, 1, 1, static_cast<std::uint32_t>(value.size()), NICOL_TEXEL_FLOAT32);
        return make(nicol_texture_create_image, context, &image, nullptr);
    };
    const Owned red(constant({0.75F, 0.25F, 0.5F})), half(constant({0.5F})), rough(constant({0.25F}));
    const auto plastic = [&](const nicol_pplastic& p) {
        return picture(context, mesh, Owned(plastic_of(context, p)));
    };
    nicol_pplastic numbers = NICOL_PPLASTIC_INIT, textures = NICOL_PPLASTIC_INIT;
    numbers.diffuse_reflectance = spectrum({0.75F, 0.25F, 0.5F});
    numbers.specular_reflectance = spectrum({0.5F});
    numbers.alpha = 0.25F;
    textures.diffuse_reflectance_texture = red;
    textures.specular_reflectance_texture = half;
    textures.alpha_texture = rough;
    const std::vector<float> by_numbers = plastic(numbers), by_textures = plastic(textures);
    REQUIRE(by_numbers.size() == by_textures.size());
    for (std::size_t i = 0; i < by_numbers.size(); ++i)
        CHECK(by_textures[i] == Approx(by_numbers[i]).epsilon(0.1));

    const auto depolarizing = [&](const nicol_plastic& p) {
        return picture(context, mesh, Owned(make(nicol_material_create_plastic, context, &p)));
    };
    nicol_plastic of_values = NICOL_PLASTIC_INIT, of_images = NICOL_PLASTIC_INIT;
    of_values.nonlinear = of_images.nonlinear = 1;
    of_values.diffuse_reflectance = spectrum({0.75F, 0.25F, 0.5F});
    of_values.specular_reflectance = spectrum({0.5F});
    of_values.alpha = 0.25F;
    of_images.diffuse_reflectance_texture = red;
    of_images.specular_reflectance_texture = half;
    of_images.alpha_texture = rough;
    const std::vector<float> expected = depolarizing(of_values), found = depolarizing(of_images);
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(found[i] == Approx(expected[i]).epsilon(0.1));
    of_values.nonlinear = 0;
    CHECK(depolarizing(of_values)[4 * edge + 1] > 1.1F * expected[4 * edge + 1]);

    const auto disney = [&](const nicol_principled& p) {
        return picture(context, mesh, Owned(make(nicol_material_create_principled, context, &p)));
    };
    nicol_principled mixed = NICOL_PRINCIPLED_INIT, mixed_by_textures = NICOL_PRINCIPLED_INIT;
    mixed.base_color = spectrum({0.75F, 0.25F, 0.5F});
    mixed.roughness = mixed.anisotropic = mixed.metallic = mixed.spec_trans = mixed.flatness = 0.5F;
    mixed.spec_tint = mixed.sheen = mixed.sheen_tint = mixed.clearcoat = mixed.clearcoat_gloss = 0.25F;
    mixed_by_textures.base_color_texture = red;
    for (nicol_texture* const texture :
         {&mixed_by_textures.roughness_texture, &mixed_by_textures.anisotropic_texture,
          &mixed_by_textures.metallic_texture, &mixed_by_textures.spec_trans_texture,
          &mixed_by_textures.flatness_texture})
        *texture = half;
    for (nicol_texture* const texture :
         {&mixed_by_textures.spec_tint_texture, &mixed_by_textures.sheen_texture,
          &mixed_by_textures.sheen_tint_texture, &mixed_by_textures.clearcoat_texture,
          &mixed_by_textures.clearcoat_gloss_texture})
        *texture = rough;
    const std::vector<float> of_mixed = disney(mixed), of_mixed_textures = disney(mixed_by_textures);
    for (std::size_t i = 0; i < of_mixed.size(); ++i)
        CHECK(of_mixed_textures[i] == Approx(of_mixed[i]).epsilon(1e-6));
    CHECK(of_mixed.at(0) > 0.05F);

    const auto metal = [&](const nicol_conductor& p) {
        return picture(context, mesh, Owned(make(nicol_material_create_conductor, context, &p)));
    };
    nicol_conductor gold = NICOL_CONDUCTOR_INIT, textured = NICOL_CONDUCTOR_INIT;
    gold.metal = textured.metal = "Au";
    gold.alpha = 0.25F;
    gold.specular_reflectance = spectrum({0.5F});
    textured.alpha_texture = rough;
    textured.specular_reflectance_texture = half;
    const std::vector<float> of_numbers = metal(gold), of_textures = metal(textured);
    for (std::size_t i = 0; i < of_numbers.size(); ++i)
        CHECK(of_textures[i] == Approx(of_numbers[i]).epsilon(0.1));
}

CONTEXT_TEST_CASE("materials blend, are cut out, and turn their normals by textures") {
    const Owned mesh(rectangle(context));
    const std::vector<float> steps = {0, 1};
    const nicol_texture_image image = image_of_texels(steps, 2, 1, 1, NICOL_TEXEL_FLOAT32);
    const nicol_texture_options options = nearest();
    const Owned weight(make(nicol_texture_create_image, context, &image, &options));
    const Owned dark(diffuse(context, {0.25F})), light(diffuse(context, {0.75F}));
    const auto left_and_right = [&](nicol_material material) {
        const std::vector<float> found = picture(context, mesh, material);
        return std::pair(found[4 * edge + 1], found[4 * edge + 6]);
    };
    const auto blended =
        left_and_right(Owned(make(nicol_material_create_blend, context, dark, light, weight)));
    CHECK(blended.first == Approx(0.25).epsilon(0.02));
    CHECK(blended.second == Approx(0.75).epsilon(0.02));
    // The cut-out part shows the sky of radiance 1.
    const auto masked = left_and_right(Owned(make(nicol_material_create_mask, context, dark, weight)));
    CHECK(masked.first == Approx(1).epsilon(0.02));
    CHECK(masked.second == Approx(0.25).epsilon(0.02));
    // A normal tilted by an angle receives (1 + cos angle) / 2 of a sky above the surface.
    const auto seen = [](double cosine) { return Approx(0.75 * (1 + cosine) / 2).epsilon(0.02); };
    const Owned flat(make(nicol_material_create_bump_map, context, light, weight, 0.0));
    CHECK(left_and_right(flat).first == seen(1));
    // The heights are 0 and 0.5 at points one unit apart.
    const Owned slope(make(nicol_material_create_bump_map, context, light, weight, 0.5));
    CHECK(left_and_right(slope).first == seen(std::cos(std::atan(0.5))));
    const std::vector<float> up = {0.5F, 0.5F, 1, 0.9F, 0.5F, 0.8F};
    const nicol_texture_image directions = image_of_texels(up, 2, 1, 3, NICOL_TEXEL_FLOAT32);
    const Owned normals(make(nicol_texture_create_image, context, &directions, &options));
    for (const std::uint32_t mirrored : {0U, 1U}) {
        const auto leaning =
            left_and_right(Owned(make(nicol_material_create_normal_map, context, light, normals, mirrored)));
        CHECK(leaning.first == seen(1));
        CHECK(leaning.second == seen(0.6));
    }
}

CONTEXT_TEST_CASE("instances need the texture coordinates and colours that their materials need") {
    const float positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0};
    const std::uint32_t indices[] = {0, 1, 2};
    nicol_mesh_data data = mesh_over(positions, indices);
    const Owned bare(make(nicol_mesh_create, context, &data));
    const float colors_of_faces[] = {1, 0.5F, 0};
    data.face_colors = colors_of_faces;
    const Owned with_face_colors(make(nicol_mesh_create, context, &data));
    const Owned texture(four_colors(context)), colored(make(nicol_texture_create_vertex_colors, context));
    const Owned of_faces(make(nicol_texture_create_face_colors, context));
    const Owned grey(diffuse(context, {0.5F}));
    const Owned textured(diffuse_of(context, texture)), painted(diffuse_of(context, colored));
    const Owned faceted(diffuse_of(context, of_faces));
    const Owned both(make(nicol_material_create_scaled, context, painted, of_faces));
    const Owned scene(empty_scene(context));
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = bare;
    const auto add_with = [&](nicol_material material) {
        instance.material = material;
        return nicol_scene_add_instance(scene, &instance, nullptr);
    };
    REFUSES(add_with(textured), "instance 0: the material has textures, which need texture coordinates");
    REFUSES(add_with(painted),
            "instance 0: the material or the radiance has the colours of vertices, and the mesh has none");
    REFUSES(add_with(faceted),
            "instance 0: the material or the radiance has the colours of faces, and the mesh has none");
    REFUSES(add_with(both),
            "instance 0: the material or the radiance has the colours of vertices and those of faces");
    instance.mesh = with_face_colors;
    REFUSES(add_with(painted),
            "instance 0: the material or the radiance has the colours of vertices, and the mesh has none");
    instance.mesh = bare;
    OK(add_with(grey));
    REFUSES(nicol_scene_set_material(scene, 0, textured), "instance 0: the material has textures");
    REFUSES(nicol_scene_set_material(scene, 0, painted),
            "instance 0: the material or the radiance has the colours");
    // An alpha mask needs texture coordinates, too.
    const Owned cut(make(nicol_material_create_mask, context, grey, texture));
    REFUSES(add_with(cut), "instance 1: the material has textures");
    std::uint32_t count = 0;
    OK(nicol_scene_get_instance_count(scene, &count));
    CHECK(count == 1);
    const Owned whole(rectangle(context));
    instance.mesh = whole;
    OK(add_with(textured));
    OK(nicol_scene_set_material(scene, 1, cut));
}
