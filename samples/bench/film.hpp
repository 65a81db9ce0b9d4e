// SPDX-License-Identifier: MIT
// A scene of which one frame after another is rendered, and the time of each.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <functional>
#include <utility>
#include <vector>

#include "common/handles.hpp"
#include "image.hpp"

struct Transform {
    double to_world[16];
};

/// Time of a frame, in milliseconds on the clock and of all threads together, and its statistics.
struct Frame {
    double ms = 0;
    double cpu_ms = 0;
    nicol_statistics work = NICOL_STATISTICS_INIT;
};

/// A scene that is rendered with default options.
class Film {
public:
    static constexpr std::uint32_t kChannels = 3;

    Film(nicol_context context, std::uint32_t size)
        : context_(context),
          scene_(create<Scene>(nicol_scene_create, context)),
          framebuffer_(create<Framebuffer>(nicol_framebuffer_create, context, size, size, kChannels)) {
        look();
    }

    /// Renders the same scene from nothing.
    [[nodiscard]] Film fresh(std::uint32_t size) const {
        Film other = copy(size);
        other.frame([] {});
        return other;
    }
    /// Returns the same scene, of which nothing is rendered.
    [[nodiscard]] Film copy(std::uint32_t size) const {
        Film other(context_, size);
        other.camera_ = camera_;
        for (const std::uint32_t id : ids()) {
            nicol_mesh mesh = nullptr;
            nicol_material material = nullptr;
            Transform place{};
            check(nicol_scene_get_instance(scene(), id, &mesh, &material, place.to_world));
            const Mesh held_mesh(mesh);
            const Material held_material(material);
            other.add(mesh, material, place);
        }
        nicol_environment light = nullptr;
        double to_world[16];
        double scale = 1;
        check(nicol_scene_get_environment(scene(), &light, to_world, &scale));
        other.set_light(Environment(light));
        other.set_light_scale(scale);
        return other;
    }

    [[nodiscard]] nicol_scene scene() const { return scene_.get(); }
    [[nodiscard]] Image image() const { return read_image(framebuffer_.get()); }
    [[nodiscard]] std::vector<std::uint32_t> ids() const {
        std::uint32_t count = 0;
        check(nicol_scene_get_instance_count(scene(), &count));
        std::vector<std::uint32_t> all(count);
        check(nicol_scene_get_instance_ids(scene(), all.data(), count));
        return all;
    }

    std::uint32_t add(nicol_mesh mesh, nicol_material material, const Transform& place) {
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material;
        std::ranges::copy(place.to_world, instance.to_world);
        std::uint32_t id = 0;
        check(nicol_scene_add_instance(scene(), &instance, &id));
        return id;
    }
    void set_budget(double milliseconds) { options_.bake_budget_ms = milliseconds; }
    void move(std::uint32_t id, const Transform& place) {
        check(nicol_scene_set_transform(scene(), id, place.to_world));
    }
    void set_mesh(std::uint32_t id, nicol_mesh mesh) { check(nicol_scene_set_mesh(scene(), id, mesh)); }
    void set_light(Environment light) {
        light_ = std::move(light);
        set_light_scale(1);
    }
    void set_light_scale(double scale) {
        check(nicol_scene_set_environment(scene(), light_.get(), nullptr, scale));
    }
    /// Rotates the light around the vertical axis by an angle in radians.
    void rotate_light(double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        const double to_world[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
        check(nicol_scene_set_environment(scene(), light_.get(), to_world, 1));
    }
    /// Moves the camera around the scene by an angle in radians.
    void orbit(double angle = 0.01) {
        angle_ += angle;
        look();
    }

    /// Edits the scene and renders it.
    Frame frame(const std::function<void()>& edit) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t spent = std::clock();
        edit();
        check(nicol_render(scene(), &camera_, &options_, framebuffer_.get()));
        Frame frame;
        frame.ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        frame.cpu_ms = 1e3 * static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC;
        check(nicol_framebuffer_get_statistics(framebuffer_.get(), &frame.work));
        return frame;
    }

private:
    void look() {
        const double origin[3] = {9 * std::sin(angle_), 6, 9 * std::cos(angle_)};
        const double target[3] = {0, 0, 0}, up[3] = {0, 1, 0};
        check(nicol_camera_look_at(&camera_, origin, target, up));
    }

    nicol_context context_;
    Scene scene_;
    Framebuffer framebuffer_;
    Environment light_;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
    nicol_render_options options_ = NICOL_RENDER_OPTIONS_INIT;
    double angle_ = 0;
};
