// SPDX-License-Identifier: MIT
#include "stage.hpp"

#include <cmath>
#include <numbers>

namespace {

// Row-major, about y.
void rotation_about_vertical(double degrees, double matrix[16]) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double rows[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
    for (int i = 0; i < 16; ++i) matrix[i] = rows[i];
}

Environment load_light(nicol_context context, const std::string& path) {
    nicol_environment light = nullptr;
    check(nicol_environment_load(context, path.c_str(), nullptr, &light));
    return Environment(light);
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

Workshop::Workshop(const Options& options) : path_(options.scene), definitions_(options.definitions) {
    if (options.cache.empty()) folder_.emplace();
    context_ = make_context(options.backend, folder_ ? folder_->path().string() : options.cache);
    std::string light = options.light;
    if (path_.empty()) {
        path_ = NICOL_BENCH_ASSETS "/bunny_hdr.xml";
        if (light.empty()) light = NICOL_BENCH_ASSETS "/forest.exr";
    }
    if (!light.empty()) light_ = load_light(context_.get(), light);
}

Scene Workshop::load() const {
    std::vector<const char*> definitions;
    for (const std::string& definition : definitions_) definitions.push_back(definition.c_str());
    nicol_scene scene = nullptr;
    check(nicol_scene_load(context_.get(), path_.c_str(), definitions.data(),
                           static_cast<std::uint32_t>(definitions.size()), &scene));
    return Scene(scene);
}

std::string Workshop::machine() const {
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    check(nicol_context_get_info(context_.get(), &info));
    return std::string(info.backend == NICOL_BACKEND_EGL ? "EGL, " : "OSMesa, ") + info.renderer + ", " +
           std::to_string(info.threads) + " threads";
}

Stage::Stage(const Workshop& workshop)
    : context_(workshop.context()), light_(workshop.light()), scene_(workshop.load()) {
    check(nicol_scene_get_camera(scene_.get(), &camera_));
    if (light_ != nullptr) turn_light(0);
}

Framebuffer Stage::framebuffer(std::uint32_t width, std::uint32_t height) const {
    std::uint32_t channels = 0;
    check(nicol_scene_get_channels(scene_.get(), &channels));
    nicol_framebuffer framebuffer = nullptr;
    check(nicol_framebuffer_create(context_, width, height, channels, &framebuffer));
    return Framebuffer(framebuffer);
}

void Stage::orbit(double degrees) {
    double turn[16];
    rotation_about_vertical(degrees, turn);
    double turned[16] = {};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            for (int k = 0; k < 4; ++k)
                turned[4 * row + column] += turn[4 * row + k] * camera_.to_world[4 * k + column];
        }
    }
    for (int i = 0; i < 16; ++i) camera_.to_world[i] = turned[i];
}

void Stage::turn_light(double degrees) {
    light_angle_ += degrees;
    double to_world[16];
    rotation_about_vertical(light_angle_, to_world);
    check(nicol_scene_set_environment(scene_.get(), light_, to_world, 1));
}

nicol_statistics Stage::render(const nicol_render_options& options, nicol_framebuffer framebuffer) const {
    check(nicol_render(scene_.get(), &camera_, &options, framebuffer));
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    check(nicol_framebuffer_get_statistics(framebuffer, &statistics));
    return statistics;
}
