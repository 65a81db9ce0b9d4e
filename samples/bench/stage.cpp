// SPDX-License-Identifier: MIT
#include "stage.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace {

// Rotates a row-major matrix about the world's y axis.
void rotate_about_vertical(double degrees, double (&matrix)[16]) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (int column = 0; column < 4; ++column) {
        const double x = matrix[column];
        const double z = matrix[8 + column];
        matrix[column] = c * x + s * z;
        matrix[8 + column] = c * z - s * x;
    }
}

Environment load_light(nicol_context context, const std::string& path) {
    nicol_environment light = nullptr;
    check(nicol_environment_load(context, path.c_str(), nullptr, &light));
    return Environment(light);
}

void set_materials(nicol_scene scene, nicol_material material) {
    std::uint32_t count = 0;
    check(nicol_scene_get_instance_count(scene, &count));
    std::vector<std::uint32_t> ids(count);
    check(nicol_scene_get_instance_ids(scene, ids.data(), count));
    for (const std::uint32_t id : ids) check(nicol_scene_set_material(scene, id, material));
}

}  // namespace

Context make_context(nicol_backend backend, const std::string& cache_folder) {
    nicol_context_options wanted = NICOL_CONTEXT_OPTIONS_INIT;
    wanted.backend = backend;
    wanted.cache_folder = cache_folder.c_str();
    nicol_context context = nullptr;
    check(nicol_context_create(&wanted, &context));
    return Context(context);
}

SceneSource::SceneSource(const Options& options) : path_(options.scene), definitions_(options.definitions) {
    if (options.cache.empty()) folder_.emplace();
    context_ = make_context(options.backend, folder_ ? folder_->path().string() : options.cache);
    if (path_.empty()) path_ = NICOL_BENCH_ASSETS "/snail_hdr.xml";
    if (!options.light.empty()) light_ = load_light(context_.get(), options.light);
}

Scene SceneSource::load() const {
    std::vector<const char*> definitions;
    for (const std::string& definition : definitions_) definitions.push_back(definition.c_str());
    nicol_scene scene = nullptr;
    check(nicol_scene_load(context_.get(), path_.c_str(), definitions.data(),
                           static_cast<std::uint32_t>(definitions.size()), &scene));
    Scene out(scene);
    if (material_ != nullptr) set_materials(scene, material_.get());
    return out;
}

std::string SceneSource::machine() const {
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    check(nicol_context_get_info(context_.get(), &info));
    return std::string(info.backend == NICOL_BACKEND_EGL ? "EGL, " : "OSMesa, ") + info.renderer + ", " +
           std::to_string(info.threads) + " threads";
}

Stage::Stage(const SceneSource& source) : context_(source.context()), scene_(source.load()) {
    check(nicol_scene_get_camera(scene_.get(), &camera_));
    if (source.light() != nullptr)
        check(nicol_scene_set_environment(scene_.get(), source.light(), nullptr, 1));
    nicol_environment light = nullptr;
    check(nicol_scene_get_environment(scene_.get(), &light, light_to_world_, &light_scale_));
    light_.reset(light);
}

Framebuffer Stage::framebuffer(std::uint32_t width, std::uint32_t height) const {
    std::uint32_t channels = 0;
    check(nicol_scene_get_channels(scene_.get(), &channels));
    nicol_framebuffer framebuffer = nullptr;
    check(nicol_framebuffer_create(context_, width, height, channels, &framebuffer));
    return Framebuffer(framebuffer);
}

void Stage::set_light(Environment light) {
    light_ = std::move(light);
    check(nicol_scene_set_environment(scene_.get(), light_.get(), light_to_world_, light_scale_));
}

void Stage::set_material(nicol_material material) {
    set_materials(scene_.get(), material);
}

void Stage::orbit(double degrees) {
    rotate_about_vertical(degrees, camera_.to_world);
}

void Stage::jitter(double right, double down) {
    camera_.jitter[0] = right;
    camera_.jitter[1] = down;
}

void Stage::rotate_light(double degrees) {
    rotate_about_vertical(degrees, light_to_world_);
    check(nicol_scene_set_environment(scene_.get(), light_.get(), light_to_world_, light_scale_));
}

nicol_statistics Stage::render(const nicol_render_options& options, nicol_framebuffer framebuffer) const {
    check(nicol_render(scene_.get(), &camera_, &options, framebuffer));
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    check(nicol_framebuffer_get_statistics(framebuffer, &statistics));
    return statistics;
}

void Stage::adjoint(const nicol_render_options& options, const nicol_stokes_image& picture,
                    const nicol_gradient& gradient) const {
    check(nicol_render_adjoint(scene_.get(), &camera_, &options, &picture, &gradient));
}
