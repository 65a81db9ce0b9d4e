// SPDX-License-Identifier: MIT
// Tests of scenes that move: a glTF animation at other times, and means of pictures.
#include "capi.hpp"
#include "import/gltf_file.hpp"

using namespace capi_test;

namespace {

/// A floor, and above it a triangle that moves, one that a morph target shifts, one that is scaled to nothing
/// from 2 s on, a light that moves and a camera that moves.
struct MovingFile : GltfFile {
    MovingFile() : GltfFile(buffer(), rest()) {}

    static GltfBuffer buffer() {
        GltfBuffer out = triangle_buffer();
        out.vectors({{0, 0, 0.4F}, {0, 0, 0.4F}, {0.3F, 0, 0.4F}});  // 1: morph target
        const auto numbers = [&out](const std::string& shape, std::size_t count,
                                    const std::vector<float>& values) {
            out.accessor(shape, gltf_float, count, GltfBuffer::of(out.view(values)));
        };
        numbers("SCALAR", 2, {0, 4});                             // 2: times of what moves
        numbers("VEC3", 2, {-0.5F, -0.5F, 0.3F, 0.5F, 0, 0.6F});  // 3: places
        numbers("SCALAR", 2, {0, 1});                             // 4: weights
        numbers("SCALAR", 3, {0, 2, 3});                          // 5: times of what vanishes
        numbers("VEC3", 3, {1, 1, 1, 0, 0, 0, 1, 1, 1});          // 6: scales
        numbers("VEC3", 2, {0, 0, 3, 1, 1, 2});                   // 7: places of the light
        numbers("VEC3", 2, {0, 0, 4, 0.3F, 0, 4});                // 8: places of the camera
        return out;
    }
    static std::string rest() {
        const std::string targets = ",\"targets\":[{\"POSITION\":1}]";
        const auto channel = [](int sampler, int node, const std::string& path) {
            return "{\"sampler\":" + std::to_string(sampler) +
                   ",\"target\":{\"node\":" + std::to_string(node) + ",\"path\":\"" + path + "\"}}";
        };
        const auto sampler = [](int input, int output, const std::string& how) {
            return "{\"input\":" + std::to_string(input) + ",\"output\":" + std::to_string(output) +
                   ",\"interpolation\":\"" + how + "\"}";
        };
        return "\"extensionsUsed\":[\"KHR_lights_punctual\"],\"extensions\":{\"KHR_lights_punctual\":{"
               "\"lights\":[{"
               "\"type\":\"point\",\"intensity\":20}]}},\"cameras\":[{\"type\":\"perspective\","
               "\"perspective\":{"
               "\"yfov\":0.6,\"znear\":0.1}}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]"
               "},{"
               "\"primitives\":[{\"attributes\":{\"POSITION\":0}" +
               targets +
               "}]}],\"nodes\":[{\"mesh\":0,\"scale\":[6,6,1],\"translation\":[-2,-2,0]},{\"mesh\":0},{"
               "\"mesh\":1,"
               "\"translation\":[-1,0,0.2]},{\"mesh\":0,\"translation\":[0,-1,0.4]},{\"extensions\":{"
               "\"KHR_lights_punctual\":{\"light\":0}}},{\"camera\":0}],\"animations\":[{\"channels\":[" +
               channel(0, 1, "translation") + "," + channel(1, 2, "weights") + "," + channel(2, 3, "scale") +
               "," + channel(3, 4, "translation") + "," + channel(4, 5, "translation") + "],\"samplers\":[" +
               sampler(2, 3, "LINEAR") + "," + sampler(2, 4, "LINEAR") + "," + sampler(5, 6, "STEP") + "," +
               sampler(2, 7, "LINEAR") + "," + sampler(2, 8, "LINEAR") + "]}]";
    }
};

/// A scene of a file, with its light around it, and its picture.
struct Shot {
    Shot(nicol_context context, const MovingFile& file, const std::string& time) {
        const std::string definition = "time=" + time;
        const char* const definitions[] = {definition.c_str()};
        OK(nicol_scene_load(context, file.scene().c_str(), definitions, time.empty() ? 0U : 1U, &scene));
        const Owned light(clear_sky(context, {1, 1, 1}));
        OK(nicol_scene_set_environment(scene, light, nullptr, 0.3));
        OK(nicol_framebuffer_create(context, 32, 24, 3, &framebuffer));
    }
    [[nodiscard]] std::vector<float> picture() const {
        nicol_camera camera = NICOL_CAMERA_INIT;
        OK(nicol_scene_get_camera(scene, &camera));
        nicol_render_options options = plain_options();
        options.shade_at = NICOL_SHADE_AT_PIXELS;
        options.disabled_optimisations = NICOL_OPTIMISATION_RAYS;
        OK(nicol_render(scene, &camera, &options, framebuffer));
        return read_all(framebuffer);
    }

    Owned<nicol_scene> scene;
    Owned<nicol_framebuffer> framebuffer;
};

double rms_difference(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0, power = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::pow(double{a[i]} - double{b[i]}, 2);
        power += std::pow(double{b[i]}, 2);
    }
    return std::sqrt(sum / power);
}

}  // namespace

CONTEXT_TEST_CASE("a scene at another time shows what a fresh start shows") {
    const MovingFile file;
    const Shot moving(context, file, "");
    const std::vector<float> rest = moving.picture();
    std::vector<float> before = rest;
    for (const char* const time : {"0", "1.5", "2.5", "4", "2", "0.5"}) {
        CAPTURE(time);
        OK(nicol_scene_set_time(moving.scene, std::stod(time)));
        const std::vector<float> now = moving.picture();
        CHECK(rms_difference(now, before) > 0.01);
        CHECK(rms_difference(now, Shot(context, file, time).picture()) < 1e-5);
        before = now;
    }
    // A file may also be loaded at a time when something is scaled to nothing.
    const Shot later(context, file, "2.5");
    CHECK(rms_difference(later.picture(), before) > 0.01);
    OK(nicol_scene_set_time(later.scene, 0.5));
    CHECK(rms_difference(later.picture(), before) < 1e-5);
}

CONTEXT_TEST_CASE("what others removed stays removed, and times that are none are refused") {
    const MovingFile file;
    const Shot moving(context, file, "1");
    OK(nicol_scene_remove_instance(moving.scene, 1));
    OK(nicol_scene_remove_light(moving.scene, 0));
    const std::vector<float> before = moving.picture();
    for (const double bad : {std::nan(""), HUGE_VAL})
        REFUSES(nicol_scene_set_time(moving.scene, bad), "time is");
    CHECK(moving.picture() == before);
    OK(nicol_scene_set_time(moving.scene, 3));
    std::uint32_t instances = 0, lights = 0;
    OK(nicol_scene_get_instance_count(moving.scene, &instances));
    OK(nicol_scene_get_light_count(moving.scene, &lights));
    CHECK(instances == 3);
    CHECK(lights == 0);
    const Owned empty(empty_scene(context));
    FAILS(nicol_scene_set_time(empty, 1), NICOL_ERROR_UNSUPPORTED, "glTF");
}

CONTEXT_TEST_CASE("blended pictures are their mean, in each component") {
    const MovingFile file;
    const Shot moving(context, file, "0");
    std::vector<double> sum;
    const Owned mean(framebuffer_of(context, 32, 24, 3));
    constexpr int pictures = 5;
    for (int k = 1; k <= pictures; ++k) {
        OK(nicol_scene_set_time(moving.scene, 0.7 * k));
        const std::vector<float> picture = moving.picture();
        sum.resize(picture.size());
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += double{picture[i]};
        OK(nicol_framebuffer_blend(mean, moving.framebuffer, 1.0 / k));
    }
    const std::vector<float> found = read_all(mean);
    for (std::size_t i = 0; i < sum.size(); ++i)
        CHECK(double{found[i]} == doctest::Approx(sum[i] / pictures).epsilon(1e-5).scale(0.01));

    const Owned smaller(framebuffer_of(context, 31, 24, 3)), grey(framebuffer_of(context, 32, 24, 1));
    check_refused(
        {{"size", [&] { return nicol_framebuffer_blend(mean, smaller, 0.5); }},
         {"channels", [&] { return nicol_framebuffer_blend(mean, grey, 0.5); }},
         {"itself", [&] { return nicol_framebuffer_blend(mean, mean, 0.5); }},
         {"weight is 1.5", [&] { return nicol_framebuffer_blend(mean, moving.framebuffer, 1.5); }},
         {"weight is", [&] { return nicol_framebuffer_blend(mean, moving.framebuffer, std::nan("")); }}});
    CHECK(read_all(mean) == found);
}
