// SPDX-License-Identifier: MIT
#include "stage.hpp"

#include <nicol_files.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/failure.hpp"

namespace {

constexpr const char* kBuddhaFile = "buddha.obj";
constexpr const char* kPlaneFile = "plane.obj";
constexpr const char* kLightFile = "SHVec_sponza_1024_L100.npz";
constexpr const char* kGoldFile = "SHMat_6_gold_ds1_L20_ISOBI2.npz";

// Makes a matrix of the light, whose vertical is z, in the world of the objects, whose vertical is y.
void rotated(double degrees, double to_world[16]) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    const double matrix[16] = {c, -s, 0, 0, 0, 0, 1, 0, -s, -c, 0, 0, 0, 0, 0, 1};
    std::copy(std::begin(matrix), std::end(matrix), to_world);
}

nicol_camera camera_at(View view, double degrees_beside) {
    const double base = view == View::front ? 23.0 : 205.0;
    const double angle = (base + degrees_beside) * std::numbers::pi / 180;
    const double origin[3] = {7.17 * std::sin(angle), view == View::front ? 1.6 : 2.6,
                              7.17 * std::cos(angle)};
    const double target[3] = {0, 0.15, 0};
    const double up[3] = {0, 1, 0};
    nicol_camera camera = NICOL_CAMERA_INIT;
    camera.fov = 34;
    check(nicol_camera_look_at(&camera, origin, target, up));
    return camera;
}

}  // namespace

void require_data(const std::filesystem::path& folder) {
    for (const char* name : {kBuddhaFile, kPlaneFile, kLightFile, kGoldFile}) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(folder / name, error)) {
            throw Failure((folder / name).string() +
                          ": no such file; the folder of data must hold it (see samples/paper/README.md)");
        }
    }
}

std::filesystem::path light_file(const std::filesystem::path& folder) {
    return folder / kLightFile;
}

Stage::Stage(const Options& options)
    : data_(options.data), size_(options.size), bake_directions_(options.bake_directions) {
    const auto file = [&](const char* name) { return (options.data / name).string(); };
    nicol_context context = nullptr;
    check(nicol_context_create(nullptr, &context));
    context_.reset(context);

    nicol_environment light = nullptr;
    check(nicol_environment_load(context, file(kLightFile).c_str(), nullptr, &light));
    light_.reset(light);
    nicol_environment_info info = NICOL_ENVIRONMENT_INFO_INIT;
    check(nicol_environment_get_info(light, &info));
    components_ = info.circular != 0 ? 4 : 3;

    nicol_material material = nullptr;
    check(nicol_material_load_psh(context, file(kGoldFile).c_str(), nullptr, &material));
    gold_.reset(material);
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    plastic.distribution = NICOL_DISTRIBUTION_GGX;
    plastic.diffuse_reflectance = {3, {0.1F, 0.1F, 0.11F}};
    plastic.alpha = 0.3F;
    check(nicol_material_create_pplastic(context, &plastic, &material));
    plastic_.reset(material);

    nicol_mesh mesh = nullptr;
    check(nicol_mesh_load(context, file(kBuddhaFile).c_str(), &mesh));
    buddha_.reset(mesh);
    check(nicol_mesh_load(context, file(kPlaneFile).c_str(), &mesh));
    plane_.reset(mesh);
}

Scene Stage::assemble(nicol_material buddha, nicol_material plane, nicol_environment light) const {
    nicol_scene made = nullptr;
    check(nicol_scene_create(context_.get(), &made));
    Scene scene(made);
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = buddha_.get();
    instance.material = buddha;
    check(nicol_scene_add_instance(made, &instance, nullptr));
    instance.mesh = plane_.get();
    instance.material = plane;
    check(nicol_scene_add_instance(made, &instance, nullptr));
    double to_world[16];
    rotated(0, to_world);
    check(nicol_scene_set_environment(made, light, to_world, 1));
    return scene;
}

Scene Stage::make_scene() const {
    return assemble(gold_.get(), plastic_.get(), light_.get());
}

Scene Stage::make_reference_scene(const std::string& image) const {
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.flags = NICOL_FILE_PHYSICAL;
    options.width = 1024;
    options.height = 513;
    check(nicol_file_convert((data_ / kLightFile).c_str(), &options, image.c_str()));
    nicol_environment made = nullptr;
    check(nicol_environment_load(context_.get(), image.c_str(), nullptr, &made));
    const Environment light(made);
    return assemble(gold_.get(), plastic_.get(), light.get());
}

Scene Stage::make_mask_scene() const {
    const nicol_spectrum black = {1, {0}}, white = {3, {1, 1, 1}};
    nicol_material material = nullptr;
    check(nicol_material_create_diffuse(context_.get(), &black, &material));
    const Material absorber(material);
    nicol_environment made = nullptr;
    check(nicol_environment_create_constant(context_.get(), &white, &made));
    const Environment light(made);
    return assemble(material, material, made);
}

Framebuffer Stage::make_framebuffer() const {
    nicol_framebuffer made = nullptr;
    check(nicol_framebuffer_create(context_.get(), size_, size_, 3, &made));
    return Framebuffer(made);
}

void Stage::rotate_light(nicol_scene scene, double degrees) const {
    double to_world[16];
    rotated(degrees, to_world);
    check(nicol_scene_set_environment(scene, light_.get(), to_world, 1));
}

void Stage::render(nicol_scene scene, View view, const Recipe& recipe, nicol_framebuffer target) const {
    render(scene, view, 0, recipe, target);
}

void Stage::render(nicol_scene scene, View view, double degrees_beside, const Recipe& recipe,
                   nicol_framebuffer target) const {
    const nicol_camera camera = camera_at(view, degrees_beside);
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.method = recipe.method;
    options.order_low = recipe.order_low;
    options.order_high = recipe.order_high;
    options.bake_directions = bake_directions_;
    options.shadows = recipe.shadows ? 1 : 0;
    // The paper computes at the vertices of its mesh.
    options.shade_at = NICOL_SHADE_AT_VERTICES;
    options.refine_tolerance = 0;
    options.high_orders = recipe.high_orders;
    options.physical = recipe.physical ? 1 : 0;
    options.samples = recipe.samples;
    options.seed = recipe.seed;
    check(nicol_render(scene, &camera, &options, target));
}

std::string Stage::machine() const {
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    check(nicol_context_get_info(context_.get(), &info));
    return std::string(info.renderer) + ", " + std::to_string(info.threads) + " threads";
}
