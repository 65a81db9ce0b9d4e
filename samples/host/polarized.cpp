// SPDX-License-Identifier: MIT
#include "polarized.hpp"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

constexpr std::uint32_t kMostSamples = 64;

void* find_function(void*, const char* name) {
    return SDL_GL_GetProcAddress(name);
}

std::int32_t is_current(void* context) {
    return SDL_GL_GetCurrentContext() == context ? 1 : 0;
}

}  // namespace

Polarized::Polarized(double time_budget) : time_budget_(time_budget) {
    nicol_host host = NICOL_HOST_INIT;
    host.get_proc_address = find_function;
    host.is_current = is_current;
    host.user = SDL_GL_GetCurrentContext();
    context_ = create<Context>(nicol_context_create_host, &host, nullptr);

    nicol_sky sky = NICOL_SKY_INIT;
    sky.sun_direction[0] = 1;
    sky.sun_direction[1] = 0.5F;
    sky_ = create<Environment>(nicol_environment_create_sky, context_.get(), &sky);
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    plastic.diffuse_reflectance = {3, {0.6F, 0.3F, 0.1F}};
    const auto material = create<Material>(nicol_material_create_pplastic, context_.get(), &plastic);
    const auto mesh = create<Mesh>(nicol_mesh_create_sphere, context_.get());
    scene_ = create<Scene>(nicol_scene_create, context_.get());
    nicol_instance ball = NICOL_INSTANCE_INIT;
    ball.mesh = mesh.get();
    ball.material = material.get();
    check(nicol_scene_add_instance(scene_.get(), &ball, nullptr));
    framebuffer_ = create<Framebuffer>(nicol_framebuffer_create, context_.get(), std::uint32_t{kSize},
                                       std::uint32_t{kSize}, std::uint32_t{3});
    const double origin[] = {0, 0.5, 3.5}, target[] = {0, 0, 0}, up[] = {0, 1, 0};
    check(nicol_camera_look_at(&camera_, origin, target, up));
}

void Polarized::draw(double sun, double polarizer, unsigned texture, unsigned depth, float depth_near) {
    const double c = std::cos(sun * std::numbers::pi / 180), s = std::sin(sun * std::numbers::pi / 180);
    const double to_world[] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
    check(nicol_scene_set_environment(scene_.get(), sky_.get(), to_world, 1));
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.time_budget_ms = time_budget_;
    samples_ = samples_ > 0 && sun == sun_ ? std::min(2 * samples_, kMostSamples) : 1;
    sun_ = sun;
    options.pixel_samples = samples_;
    options.aovs = depth != 0 ? NICOL_AOV_DEPTH : 0;
    check(nicol_render(scene_.get(), &camera_, &options, framebuffer_.get()));

    nicol_observation seen = NICOL_OBSERVATION_INIT;
    seen.kind = NICOL_OBSERVATION_POLARIZER;
    seen.polarizer_angle = static_cast<float>(polarizer);
    nicol_texture_target target = NICOL_TEXTURE_TARGET_INIT;
    target.texture = texture;
    target.bottom_up = 1;
    target.encoding = NICOL_ENCODING_SRGB;
    target.depth_texture = depth;
    target.depth_near = depth_near;
    check(nicol_framebuffer_draw_observation(framebuffer_.get(), &seen, &target));
}

std::vector<float> Polarized::planes() const {
    constexpr std::size_t plane = std::size_t{4} * kSize * kSize;
    std::vector<float> stokes(3 * plane);
    for (std::uint32_t c = 0; c < 3; ++c)
        check(nicol_framebuffer_read(framebuffer_.get(), NICOL_PLANE_STOKES, c, stokes.data() + c * plane, 0,
                                     plane * sizeof(float)));
    return stokes;
}
