// SPDX-License-Identifier: MIT
// Tests of alpha masks against meshes without the masked parts.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "reference/render_reference.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::falling_light;
using test::rms;
using test::rms_difference;
using test::Studio;

namespace {

constexpr int kCells = 8;

/// Returns whether a cell of an 8 x 8 board is present.
bool there(int x, int y) {
    return (x + y) % 2 == 0;
}

/// Returns the square of make_rectangle() in 8 x 8 cells of two triangles, with texture coordinates: the
/// whole board, or only the cells that are present.
std::shared_ptr<const Mesh> board(bool whole) {
    const Mesh full = *test::with_texcoords(make_rectangle(kCells));
    Mesh out = full;
    out.triangles.clear();
    out.texcoord_triangles.clear();
    for (std::size_t t = 0; t < full.triangles.size(); ++t) {
        glm::vec2 middle(0);
        for (glm::length_t k = 0; k < 3; ++k)
            middle += full.texcoords[full.texcoord_triangles[t][k]] * (kCells / 3.0F);
        if (!whole && !there(static_cast<int>(middle.x), static_cast<int>(middle.y))) continue;
        out.triangles.push_back(full.triangles[t]);
        out.texcoord_triangles.push_back(full.texcoord_triangles[t]);
    }
    return std::make_shared<const Mesh>(std::move(out));
}

TexturePtr opacity(int channels) {
    TextureImage image{.width = kCells, .height = kCells, .channels = channels};
    for (int y = 0; y < kCells; ++y)
        for (int x = 0; x < kCells; ++x)
            for (int c = 0; c < channels; ++c)
                image.values.push_back(channels == 4 && c < 3 ? 0.7F : there(x, y) ? 0.9F : 0.2F);
    return image_texture(std::move(image), {.filter = TextureSampling::Filter::nearest});
}

/// Returns the board above a floor.
Scene board_over(const std::shared_ptr<const Mesh>& mesh, const MaterialPtr& material) {
    Scene scene;
    scene.add({.mesh = mesh, .material = material, .to_world = test::plate_at(0.1, 1)});
    scene.add({.mesh = std::make_shared<const Mesh>(make_rectangle(16)),
               .material = diffuse({0.5}),
               .to_world = test::plate_at(-0.6, 2)});
    scene.set_environment(falling_light(9, true, 3), theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7))),
                          0.7);
    return scene;
}

RenderOptions options(Executor executor, int samples = 1) {
    RenderOptions out{.executor = executor, .bake_directions = 1024, .order_low = 4};
    out.refine_tolerance = 0;
    out.aovs = aov_instances | aov_alpha;
    out.shade_at = ShadeAt::pixels;
    out.pixel_samples = samples;
    return out;
}

/// Counts the pixels that differ, except at edges, where rounding decides.
int differing(const StokesImage& a, const StokesImage& b, float tolerance) {
    int count = 0;
    for (std::size_t i = 0; i < a.data.size(); i += 4)
        count += std::abs(a.data[i] - b.data[i]) > tolerance ? 1 : 0;
    return count;
}

}  // namespace

IMAGE_TEST_CASE("a surface that is cut out looks and hides like a mesh without those parts") {
    const struct {
        const char* name;
        MaterialPtr plain;
        int channels;
    } rows[] = {{"two-sided", twosided(pplastic({.alpha = 0.3})), 1},
                {"coverage of a coloured texture", diffuse({0.5}), 4}};
    for (const auto& row : rows) {
        const Scene cut = board_over(board(true), masked(row.plain, opacity(row.channels)));
        const Scene lacking = board_over(board(false), row.plain);
        for (const Executor executor : {Executor::cpu, Executor::compute}) {
            Studio render(context);
            for (const int samples : {1, 4}) {
                CAPTURE(row.name);
                CAPTURE(samples);
                Framebuffer actual(context, 96, 72, 3);
                Framebuffer expected(context, 96, 72, 3);
                render.renderer.render(lacking, test::some_camera(), options(executor, samples), expected);
                render.renderer.render(cut, test::some_camera(), options(executor, samples), actual);
                const double scale = rms(expected.image());
                // Cells that touch at a corner share its vertex, whose light differs by the shadow at that
                // corner.
                CHECK(differing(actual.image(), expected.image(), static_cast<float>(0.05 * scale)) < 60);
                CHECK(rms_difference(actual.image(), expected.image()) < 0.04 * scale);
                int other_ids = 0;
                int seen = 0;
                for (std::size_t p = 0; p < actual.aovs().instances.size(); ++p) {
                    other_ids += actual.aovs().instances[p] != expected.aovs().instances[p] ? 1 : 0;
                    seen += expected.aovs().instances[p] == 0 ? 1 : 0;
                }
                CHECK(seen > 200);
                CHECK(other_ids < 10);
            }
        }
    }
}

TEST_CASE("rays pass where a surface is cut out") {
    const MaterialPtr plain = twosided(pplastic({.alpha = 0.3}));
    const Projection projection = project(test::some_camera(), 48, 36);
    ReferenceStatistics statistics;
    const auto trace = [&](const Scene& scene) {
        return render_reference(scene, projection, 48, 36, {.samples = 64}, statistics);
    };
    const StokesImage expected = trace(board_over(board(false), plain));
    const StokesImage actual = trace(board_over(board(true), masked(plain, opacity(1))));
    const StokesImage whole = trace(board_over(board(true), plain));
    CHECK(rms_difference(actual, expected) < 1e-3 * rms(expected));
    CHECK(rms_difference(whole, expected) > 0.05 * rms(expected));
}

IMAGE_TEST_CASE("a translucent surface covers and hides its fraction of everything") {
    constexpr float covered = 0.3F;
    const MaterialPtr plain = twosided(pplastic({.alpha = 0.3}));
    const TexturePtr even = constant_texture(glm::vec4(covered), 1);
    // The board hides the sky from the camera, or the floor from light. Of a floor behind the board, both
    // fractions would multiply.
    for (const bool floor : {false, true}) {
        Scene without = board_over(board(true), plain);
        without.remove(0);
        Scene whole = board_over(board(true), plain);
        Scene translucent = board_over(board(true), masked(plain, even, true));
        if (!floor)
            for (Scene* const scene : {&without, &whole, &translucent}) scene->remove(1);
        for (const int samples : {1, 8, 64}) {  // 64: of rays
            CAPTURES(floor, samples);
            RenderOptions chosen = options(Executor::automatic, std::min(samples, 8));
            chosen.bake_directions = 4096;
            if (samples == 64) {
                chosen = {.method = Method::reference, .samples = samples};
                chosen.aovs = aov_instances;
            }
            Studio render(context);
            Framebuffer target(context, 96, 72, 3);
            const auto image_of = [&](const Scene& scene) {
                render.renderer.render(scene, test::some_camera(), chosen, target);
                return target.image();
            };
            const StokesImage none = image_of(without), actual = image_of(translucent);
            const StokesImage all = image_of(whole);
            double difference = 0, square = 0, light = 0;
            int pixels = 0;
            for (std::size_t p = 0; p < target.aovs().instances.size(); ++p) {
                if (target.aovs().instances[p] == 0 && floor) continue;
                const auto s0 = [p](const StokesImage& image) {
                    return static_cast<double>(image.data[4 * p]);
                };
                const double expected = covered * s0(all) + (1 - covered) * s0(none);
                difference += s0(actual) - expected;
                square += (s0(actual) - expected) * (s0(actual) - expected);
                light += expected;
                ++pixels;
            }
            CHECK(pixels > 500);
            CHECK(std::abs(difference) < 0.01 * light);
            CHECK(std::sqrt(square * pixels) < (samples == 1 ? 0.5 : 0.1) * light);
        }
    }
}

IMAGE_TEST_CASE("what is cut out changes with the material, and its shadow too") {
    const MaterialPtr plain = twosided(pplastic({.alpha = 0.3}));
    Scene scene = board_over(board(true), plain);
    Studio render(context);
    static_cast<void>(render(scene, options(Executor::cpu)));
    const TexturePtr fraction = opacity(1);
    for (const MaterialPtr& material : {masked(plain, opacity(1)), plain, masked(plain, opacity(4)),
                                        masked(plain, fraction), masked(plain, fraction, true)}) {
        scene.set_material(0, material);
        const StokesImage changed = render(scene, options(Executor::cpu));
        Studio fresh(context);
        const StokesImage expected = fresh(scene, options(Executor::cpu));
        CHECK(rms_difference(changed, expected) < 1e-6 * rms(expected));
    }
}
