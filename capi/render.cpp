// SPDX-License-Identifier: MIT
// Renders, directly and as jobs.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "assets.hpp"
#include "camera.hpp"
#include "gradient_room.hpp"
#include "handles.hpp"
#include "initialiser.hpp"
#include "scene/path_depth.hpp"
#include "stokes_rows.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

int int_from(std::uint32_t given, const char* name) {
    if (given > INT32_MAX) refuse(std::string(name) + " is " + std::to_string(given) + "; that is too many");
    return static_cast<int>(given);
}

Method method_from(nicol_method given) {
    switch (given) {
        case NICOL_METHOD_FACTORED:
            return Method::factored;
        case NICOL_METHOD_DENSE:
            return Method::dense;
        case NICOL_METHOD_REFERENCE:
            return Method::reference;
        default:
            throw Error(ErrorCode::unsupported,
                        "method is " + std::to_string(given) +
                            "; this version has NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE and "
                            "NICOL_METHOD_REFERENCE");
    }
}

// Returns an enumeration whose values are the constants 0 to `last` of the interface.
template <class Enumeration>
Enumeration value_from(std::uint32_t given, Enumeration last, const char* name, const char* constants) {
    require_constant(given, static_cast<std::uint32_t>(last), name, constants);
    return static_cast<Enumeration>(given);
}

template <class Enumeration>
constexpr bool are(Enumeration first, std::uint32_t a, Enumeration second, std::uint32_t b, Enumeration third,
                   std::uint32_t c) {
    return static_cast<std::uint32_t>(first) == a && static_cast<std::uint32_t>(second) == b &&
           static_cast<std::uint32_t>(third) == c;
}
static_assert(are(Executor::automatic, NICOL_EXECUTOR_AUTOMATIC, Executor::cpu, NICOL_EXECUTOR_CPU,
                  Executor::compute, NICOL_EXECUTOR_COMPUTE));
static_assert(are(HighOrders::split, NICOL_HIGH_ORDERS_SPLIT, HighOrders::convolution,
                  NICOL_HIGH_ORDERS_CONVOLUTION, HighOrders::none, NICOL_HIGH_ORDERS_NONE));
static_assert(are(ReconstructionFilter::Kind::box, NICOL_FILTER_BOX, ReconstructionFilter::Kind::mitchell,
                  NICOL_FILTER_MITCHELL, ReconstructionFilter::Kind::lanczos, NICOL_FILTER_LANCZOS));
static_assert(are(ShadeAt::automatic, NICOL_SHADE_AT_AUTOMATIC, ShadeAt::vertices, NICOL_SHADE_AT_VERTICES,
                  ShadeAt::pixels, NICOL_SHADE_AT_PIXELS));

ReconstructionFilter filter_from(const nicol_filter& given) {
    if (given.reserved != 0) refuse("filter.reserved must be 0");
    return {.kind = value_from(given.kind, ReconstructionFilter::Kind::lanczos, "filter.kind",
                               "NICOL_FILTER_..."),
            .size = given.size,
            .b = given.b,
            .c = given.c};
}

int components_from(nicol_components given) {
    switch (given) {
        case NICOL_COMPONENTS_ALL:
            return 4;
        case NICOL_COMPONENTS_S0:
        case NICOL_COMPONENTS_LINEAR:
            return static_cast<int>(given);
        default:
            refuse("components is " + std::to_string(given) + "; it must be one of NICOL_COMPONENTS_...");
    }
}

static_assert(NICOL_SPLIT_AUTOMATIC == kSplitAutomatic && NICOL_MAX_SPLIT_LIGHTS == kMaxSplitLights);
static_assert(NICOL_AOV_DEPTH == aov_depth && NICOL_AOV_NORMAL == aov_normals &&
              NICOL_AOV_POSITION == aov_positions && NICOL_AOV_INSTANCE == aov_instances &&
              NICOL_AOV_VARIANCE == aov_variance && NICOL_AOV_ALPHA == aov_alpha);

int depth_from(std::int32_t given) {
    if (given < NICOL_DEPTH_UNLIMITED) {
        refuse("max_depth is " + std::to_string(given) +
               "; it must be 1 or more, 0 (the default, direct light) or NICOL_DEPTH_UNLIMITED");
    }
    if (given == NICOL_DEPTH_UNLIMITED) return kUnlimitedDepth;
    return given == 0 ? kDirectLightDepth : given;
}

std::uint32_t aovs_from(std::uint32_t given) {
    if ((given & ~(NICOL_AOV_ALL | NICOL_AOV_VARIANCE)) != 0) {
        refuse("aovs is " + std::to_string(given) + "; it must be a sum of NICOL_AOV_...");
    }
    return given;
}

// Reads the orders. If only one is given, the other is its default, moved if it contradicts the given one.
void read_orders(const nicol_render_options& given, RenderOptions& options) {
    const bool low = given.order_low != NICOL_ORDER_AUTOMATIC;
    const bool high = given.order_high != NICOL_ORDER_AUTOMATIC;
    options.choose_orders = !low && !high;
    if (high) options.order_high = int_from(given.order_high, "order_high");
    if (low) {
        options.order_low = int_from(given.order_low, "order_low");
        options.order_high = std::max(options.order_high, options.order_low);
    } else {
        options.order_low = std::min(options.order_low, options.order_high);
    }
}

// Returns the number of directions. With chosen orders, shadows get their part of the tolerance: 1,024
// directions leave noise of about a tenth of 0.03.
int bake_directions_from(const nicol_render_options& given, const RenderOptions& options) {
    if (given.bake_directions != NICOL_DIRECTIONS_AUTOMATIC)
        return int_from(given.bake_directions, "bake_directions");
    if (!options.choose_orders) return options.bake_directions;
    int directions = 1024;
    double enough_for = 0.03;
    while (directions < 8192 && given.tolerance < enough_for) {
        directions *= 2;
        enough_for /= 2;
    }
    return directions;
}

RenderOptions options_from(const nicol_render_options& given) {
    RenderOptions options;
    options.method = method_from(given.method);
    options.executor = value_from(given.executor, Executor::compute, "executor", "NICOL_EXECUTOR_...");
    options.shadows = switch_from(given.shadows, "shadows");
    read_orders(given, options);
    options.bake_directions = bake_directions_from(given, options);
    options.high_orders =
        value_from(given.high_orders, HighOrders::none, "high_orders", "NICOL_HIGH_ORDERS_...");
    options.high_order_shadows = switch_from(given.high_order_shadows, "high_order_shadows");
    options.shade_at = value_from(given.shade_at, ShadeAt::pixels, "shade_at", "NICOL_SHADE_AT_...");
    options.refine_tolerance = given.refine_tolerance;
    options.max_vertices = given.max_vertices;
    options.bake_budget_ms = given.bake_budget_ms;
    options.time_budget_ms = given.time_budget_ms;
    options.dering = given.dering;
    options.physical = switch_from(given.physical, "physical");
    options.tolerance = given.tolerance;
    options.components = components_from(given.components);
    options.pixel_samples = given.pixel_samples == 0 ? 1 : int_from(given.pixel_samples, "pixel_samples");
    options.filter = filter_from(given.filter);
    options.aovs = aovs_from(given.aovs);
    options.disabled_optimisations = given.disabled_optimisations;
    options.split_lights = given.split_lights;
    options.light_samples = int_from(given.light_samples, "light_samples");
    options.bsdf_samples = int_from(given.bsdf_samples, "bsdf_samples");
    options.max_depth = depth_from(given.max_depth);
    options.samples = int_from(given.samples, "samples");
    options.seed = given.seed;
    options.progress = progress_from(given.progress, given.progress_user);
    return options;
}

// Options of nicol_render, checked as far as possible without a scene.
struct RenderCall {
    RenderOptions options;
    bool fail_if_busy;
};

RenderCall read_render_call(const nicol_render_options* options) {
    const auto given = read_options(options, nicol_render_options NICOL_RENDER_OPTIONS_INIT);
    if (given.reserved != 0) refuse("reserved must be 0");
    return {.options = options_from(given), .fail_if_busy = switch_from(given.fail_if_busy, "fail_if_busy")};
}

Camera read_camera(const nicol_camera* camera, const char* name) {
    return camera_from(read_struct(camera, nicol_camera NICOL_CAMERA_INIT, name));
}

// Returns the cameras of an array whose elements have the size that the first one states.
std::vector<Camera> read_cameras(const nicol_camera* cameras, std::uint32_t count) {
    require(cameras, "cameras");
    const std::uint32_t size = cameras->struct_size;
    std::vector<Camera> out;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string name = i == 0 ? "cameras" : "cameras[" + std::to_string(i) + "]";
        const auto* const camera = reinterpret_cast<const nicol_camera*>(
            reinterpret_cast<const std::byte*>(cameras) + std::size_t{i} * size);
        if (camera->struct_size != size)
            refuse(name + ".struct_size is " + std::to_string(camera->struct_size) +
                   "; it must be that of cameras[0], " + std::to_string(size));
        out.push_back(read_camera(camera, name.c_str()));
    }
    return out;
}

// Returns the framebuffers of an array, which stay alive as long as the copies.
std::vector<nicol_framebuffer_impl> read_framebuffers(const nicol_framebuffer* framebuffers,
                                                      std::uint32_t count, const nicol_scene_impl& scene) {
    require(framebuffers, "framebuffers");
    std::vector<nicol_framebuffer_impl> out;
    for (std::uint32_t i = 0; i < count; ++i) {
        const nicol_framebuffer_impl target = resolve(framebuffers[i]);
        require_same_context(scene, target);
        for (std::uint32_t k = 0; k < i; ++k)
            if (out[k].content == target.content)
                refuse("framebuffers[" + std::to_string(i) + "] is framebuffers[" + std::to_string(k) +
                       "] again; each view needs its own");
        out.push_back(target);
    }
    return out;
}

// Returns a function that reports to the job and to the caller's progress callback.
std::function<bool(const char*, double)> job_progress(Job& job, const RenderOptions& options) {
    return
        [&job, callback = ProgressCallback::Function(options.progress)](const char* verb, double fraction) {
            job.report(verb, fraction);
            if (!callback) return true;
            const bool go_on = callback(verb, fraction);
            job.report(verb, fraction);  // throws if the job was cancelled meanwhile
            return go_on;
        };
}

// Reports once per scene file that nothing lights it, at its first render without a light.
void notice_darkness(const Scene& scene, SceneState& state, const Session& session) {
    if (scene.environment() || scene.has_local_lights() || !state.film ||
        std::exchange(state.darkness_noticed, true))
        return;
    session.notice(state.files.front().path.string() + ": no emitter lights the scene.");
}

// Reports once per scene that an image's predicted error exceeds the tolerance. Orders that are given are
// no wish for one.
void notice_error(const Statistics& statistics, const RenderOptions& options, SceneState& state,
                  const Session& session) {
    // No option reduces the error of bounced light.
    const double bounced = std::min(statistics.bounce_error, statistics.predicted_error);
    const double reducible =
        std::sqrt(statistics.predicted_error * statistics.predicted_error - bounced * bounced);
    if (options.method == Method::reference || !options.choose_orders || !(options.tolerance > 0) ||
        !(reducible > options.tolerance) || std::exchange(state.error_noticed, true))
        return;
    std::ostringstream text;
    if (!state.files.empty()) text << state.files.front().path.string() << ": ";
    text << std::setprecision(2) << "the predicted error is " << statistics.predicted_error
         << ", the tolerance " << options.tolerance
         << (statistics.order_error > options.tolerance ? "; no orders reach it."
             : statistics.interpolation_error > options.tolerance
                 ? "; shade_at NICOL_SHADE_AT_PIXELS reduces it."
                 : "; more of light_samples, bsdf_samples or pixel_samples reduces it.");
    session.notice(text.str());
}

// Calls body(state) with the state of a scene that no other render uses, on the caller's thread.
template <class Body>
void with_renderer(const nicol_scene_impl& self, const RenderCall& call, const Body& body) {
    refuse_in_callback(*self.session);
    SceneState& state = *self.content;
    std::unique_lock rendering(state.rendering, std::defer_lock);
    if (!call.fail_if_busy)
        rendering.lock();
    else if (!rendering.try_lock())
        throw Error(ErrorCode::busy, "another render of the scene runs, and fail_if_busy is 1");
    // A host's context is asked for before baking, which may take minutes.
    self.session->gl->visit([&] {
        const Edit edit(self);
        notice_darkness(state.scene, state, *self.session);
        body(state);
    });
}

// Renders at least one view on the caller's thread.
void render_views(const nicol_scene_impl& self, std::span<const View> views, const RenderCall& call) {
    with_renderer(self, call, [&](SceneState& state) {
        for (const Statistics& statistics : state.renderer.render(state.scene, views, call.options))
            notice_error(statistics, call.options, state, *self.session);
    });
}

// Throws Error(cancelled) if a job that waits for the host's context was cancelled or nobody can lend it.
void require_awaited(const Job& job, const Session& session) {
    job.check();
    if (session.handles == 0) {
        throw Error(ErrorCode::cancelled,
                    "all objects of the host's context are released: nobody can lend it");
    }
}

}  // namespace

nicol_result nicol_render(nicol_scene scene, const nicol_camera* camera, const nicol_render_options* options,
                          nicol_framebuffer framebuffer) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const nicol_framebuffer_impl& target = resolve(framebuffer);
        require_same_context(self, target);
        const RenderCall call = read_render_call(options);
        const View view{.camera = read_camera(camera, "camera"), .target = target.content.get()};
        render_views(self, {&view, 1}, call);
    });
}

nicol_result nicol_render_views(nicol_scene scene, const nicol_camera* cameras,
                                const nicol_framebuffer* framebuffers, uint32_t count,
                                const nicol_render_options* options) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        if (count < 1 || count > NICOL_MAX_VIEWS)
            refuse("count is " + std::to_string(count) + "; it must lie in 1 to " +
                   std::to_string(NICOL_MAX_VIEWS));
        const std::vector<nicol_framebuffer_impl> targets = read_framebuffers(framebuffers, count, self);
        const RenderCall call = read_render_call(options);
        std::vector<View> views;
        for (const Camera& camera : read_cameras(cameras, count))
            views.push_back({.camera = camera, .target = targets[views.size()].content.get()});
        render_views(self, views, call);
    });
}

nicol_result nicol_render_adjoint(nicol_scene scene, const nicol_camera* camera,
                                  const nicol_render_options* options, const nicol_stokes_image* picture,
                                  const nicol_gradient* gradient) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const RenderCall call = read_render_call(options);
        const Camera from = read_camera(camera, "camera");
        const StokesImage of_picture = StokesRows(picture, "picture").read();
        if (!std::ranges::all_of(of_picture.data, [](float number) { return std::isfinite(number); }))
            refuse("picture has numbers that are not finite");
        const GradientRoom room(gradient, self);
        with_renderer(self, call, [&](SceneState& state) {
            room.check(state.scene, call.options);
            room.write(state.renderer.adjoint(state.scene, from, call.options, of_picture, room.wanted()));
        });
    });
}

nicol_result nicol_render_async(nicol_scene scene, const nicol_camera* camera,
                                const nicol_render_options* options, nicol_framebuffer framebuffer,
                                nicol_job* job) {
    return guarded([&] {
        require(job, "job");
        const nicol_scene_impl& self = resolve(scene);
        const nicol_framebuffer_impl& target = resolve(framebuffer);
        require_same_context(self, target);
        const RenderCall call = read_render_call(options);
        const Camera from = read_camera(camera, "camera");
        refuse_in_callback(*self.session);
        Scene snapshot;
        {
            const Edit edit(self);
            snapshot = self.content->scene;
        }
        auto made = std::make_shared<Job>(
            [call, from, snapshot = std::move(snapshot), session = self.session, state = self.content,
             target = target.content](Job& running) {
                Call::concerns(session);
                const std::lock_guard rendering(state->rendering);
                running.begin();
                const gl::Borrower borrower(session->gl, [&] { require_awaited(running, *session); });
                RenderOptions options = call.options;
                options.progress = job_progress(running, call.options);
                notice_darkness(snapshot, *state, *session);
                const Statistics statistics = state->renderer.render(snapshot, from, options, *target);
                notice_error(statistics, options, *state, *session);
            },
            [session = self.session] { session->gl->wake(); });
        auto* const handle = make_handle<nicol_job_impl>(self.session, made);
        try {
            self.session->job_queue().add(made);
        } catch (...) {
            release(handle);
            throw;
        }
        *job = handle;
    });
}

NICOL_INITIALISER(nicol_filter, NICOL_FILTER_INIT)
