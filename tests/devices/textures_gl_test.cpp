// SPDX-License-Identifier: MIT
// Tests of textured materials shaded at pixels by compute shaders, against the images of threads.
#include <random>

#include "devices/both_executors.hpp"
#include "gl/contexts.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::BothExecutors;
using test::falling_light;

namespace {

TextureImage noise(int channels, float least = 0, float most = 1) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> values(least, most);
    TextureImage image{.width = 13, .height = 9, .channels = channels};
    for (int i = 0; i < image.width * image.height * channels; ++i) image.values.push_back(values(random));
    return image;
}

TexturePtr image(int channels, TextureSampling::Filter filter, TextureSampling::Wrap wrap,
                 double repetitions = 1) {
    const double n = repetitions;
    const glm::dmat3 to_uv(1.9 * n, 0.4 * n, 0, -0.3 * n, 1.6 * n, 0, -0.2, 0.1, 1);
    return image_texture(noise(channels), {.filter = filter, .wrap = wrap, .to_uv = to_uv});
}

/// Returns a mesh with texture coordinates and a separate colour at each vertex and on each triangle.
/// tangent: tangent of all corners, if w is not 0.
std::shared_ptr<const Mesh> colored(const Mesh& mesh, const glm::vec4& tangent = glm::vec4(0)) {
    Mesh out = *test::with_texcoords(mesh);
    if (tangent.w != 0) out.tangents.assign(out.texcoords.size(), tangent);
    for (const glm::vec3& p : out.positions) out.colors.push_back(glm::abs(glm::fract(0.37F * p + 0.2F)));
    for (const glm::uvec3& t : out.triangles) out.face_colors.push_back(glm::fract(0.37F * glm::vec3(t)));
    return std::make_shared<const Mesh>(std::move(out));
}

Scene ball_over(const MaterialPtr& ball, const MaterialPtr& floor) {
    static const auto round = colored(*test::coarse_sphere(6));
    static const auto flat = colored(make_rectangle(2), {0.6F, 0.8F, 0, -1});
    Scene scene;
    scene.add({.mesh = round, .material = ball, .to_world = test::at(0.2, 0, 0.1, 0.7)});
    scene.add({.mesh = flat, .material = floor, .to_world = test::plate_at(-1, 2)});
    scene.set_environment(falling_light(9, true, 3), theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7))),
                          0.7);
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("compute shaders texture as threads do") {
    using Filter = TextureSampling::Filter;
    using Wrap = TextureSampling::Wrap;
    const MaterialPtr grey = diffuse({0.5});
    const MaterialPtr metal = test::some_metal(0.2);
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3});
    const auto gloss = [](double alpha) { return pplastic({.alpha = alpha}); };
    const TexturePtr rough = image_texture(noise(1, 0.2F, 0.5F));
    const TexturePtr bumps = image_texture(noise(3, 0.3F, 1));
    const TexturePtr checks = checkerboard_texture(glm::vec3(0.9F, 0.2F, 0.1F), glm::vec3(0.1F, 0.3F, 0.8F),
                                                   3, glm::dmat3(7, 0, 0, 0, 5, 0, 0.2, -0.1, 1));
    const struct {
        const char* name;
        MaterialPtr ball;
        MaterialPtr floor;
    } rows[] = {
        {"nearest, repeat; bilinear, mirror", scaled(plastic, image(3, Filter::nearest, Wrap::repeat)),
         scaled(metal, image(1, Filter::bilinear, Wrap::mirror))},
        {"mipmap, clamp; mipmap, repeat", scaled(plastic, image(4, Filter::mipmap, Wrap::clamp)),
         scaled(grey, image(3, Filter::mipmap, Wrap::repeat))},
        {"checkerboard, colours of vertices", scaled(plastic, mesh_color_texture(ColorsOf::vertices)),
         scaled(grey, checks)},
        {"colours of vertices, colours of faces", scaled(plastic, mesh_color_texture(ColorsOf::vertices)),
         scaled(metal, mesh_color_texture(ColorsOf::faces))},
        {"a product, a plain one",
         scaled(grey, product_texture(checks, mesh_color_texture(ColorsOf::vertices))), plastic},
        {"roughness, a blend", with_roughness(gloss, rough),
         blend(metal, plastic, image(1, Filter::bilinear, Wrap::repeat))},
        {"normal maps, two-sided", normal_mapped(plastic, bumps),
         twosided(normal_mapped(scaled(metal, checks), bumps, {.mirrored_y = true}))},
        {"mipmaps of footprints that are stretched",
         scaled(plastic, image(1, Filter::mipmap, Wrap::repeat, 9)),
         scaled(grey, image(3, Filter::mipmap, Wrap::mirror, 9))},
        {"their bump maps", bump_mapped(plastic, image(1, Filter::mipmap, Wrap::repeat, 5), 0.02),
         bump_mapped(grey, image(1, Filter::mipmap, Wrap::mirror, 5), 0.02)},
        {"bump maps", bump_mapped(plastic, image(1, Filter::mipmap, Wrap::mirror), 0.1),
         bump_mapped(grey, image(3, Filter::bilinear, Wrap::repeat), 0.05)}};
    for (const auto& row : rows)
        for (const int high : {4, 9}) {
            CAPTURE(row.name);
            CAPTURE(high);
            const Scene scene = ball_over(row.ball, row.floor);
            BothExecutors(context, 3)
                .run(scene, {.order_low = 4, .order_high = high, .shade_at = ShadeAt::pixels},
                     test::some_camera(), true);
        }
}
