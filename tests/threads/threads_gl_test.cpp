// SPDX-License-Identifier: MIT
// Tests of contexts, and of objects of one context, used from several threads at once. Without a sanitizer
// they detect wrong images, and with ThreadSanitizer every unordered access.
#include <atomic>
#include <thread>

#include "capi/capi.hpp"
#include "threads/no_workers.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t size = 8;

nicol_context context_of(nicol_backend backend, std::uint32_t threads) {
    nicol_context_options options = two_threads(backend);
    options.threads = threads;
    nicol_context context = nullptr;
    return nicol_context_create(&options, &context) == NICOL_OK ? context : nullptr;
}

/// A cube under a sky, with every call that a program makes each frame. Results are booleans, because
/// doctest's checks must stay out of the threads.
class Painting {
public:
    explicit Painting(nicol_context context) {
        const nicol_sky sky = NICOL_SKY_INIT;
        const nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        good_ = nicol_environment_create_sky(context, &sky, &environment_) == NICOL_OK &&
                nicol_material_create_pplastic(context, &plastic, &material_) == NICOL_OK &&
                nicol_mesh_create_cube(context, &mesh_) == NICOL_OK;
        make_scene(context);
    }
    /// A scene of its own, with the assets of another painting.
    Painting(nicol_context context, const Painting& other)
        : environment_(other.environment_), material_(other.material_), mesh_(other.mesh_) {
        good_ = nicol_environment_retain(environment_) == NICOL_OK &&
                nicol_material_retain(material_) == NICOL_OK && nicol_mesh_retain(mesh_) == NICOL_OK;
        make_scene(context);
    }
    ~Painting() {
        nicol_framebuffer_release(framebuffer_);
        nicol_scene_release(scene_);
        nicol_mesh_release(mesh_);
        nicol_material_release(material_);
        nicol_environment_release(environment_);
    }
    Painting(const Painting&) = delete;
    Painting& operator=(const Painting&) = delete;

    /// Renders with the light rotated by this many quarter turns about the vertical axis. Returns the image,
    /// or nothing on failure.
    std::vector<float> frame(int quarters) {
        constexpr double cosines[] = {1, 0, -1, 0};
        const double c = cosines[quarters % 4], s = cosines[(quarters + 3) % 4];
        const double to_world[] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
        nicol_render_options options = plain_options();
        options.bake_directions = 256;
        std::vector<float> pixels(std::size_t{size} * size * 4);
        nicol_statistics statistics = NICOL_STATISTICS_INIT;
        const bool done = good_ &&
                          nicol_scene_set_environment(scene_, environment_, to_world, 1) == NICOL_OK &&
                          nicol_render(scene_, &camera_, &options, framebuffer_) == NICOL_OK &&
                          nicol_framebuffer_read(framebuffer_, NICOL_PLANE_STOKES, 1, pixels.data(), 0,
                                                 pixels.size() * sizeof(float)) == NICOL_OK &&
                          nicol_framebuffer_get_statistics(framebuffer_, &statistics) == NICOL_OK;
        return done ? pixels : std::vector<float>();
    }

    [[nodiscard]] nicol_scene scene() const { return scene_; }

private:
    void make_scene(nicol_context context) {
        good_ = good_ && nicol_scene_create(context, &scene_) == NICOL_OK &&
                nicol_framebuffer_create(context, size, size, 3, &framebuffer_) == NICOL_OK &&
                nicol_scene_set_environment(scene_, environment_, nullptr, 1) == NICOL_OK;
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh_;
        instance.material = material_;
        const Matrix place = placed(0, 0, 0, 0.6);
        std::copy_n(place.rows, 16, instance.to_world);
        good_ = good_ && nicol_scene_add_instance(scene_, &instance, nullptr) == NICOL_OK;
    }

    nicol_environment environment_ = nullptr;
    nicol_material material_ = nullptr;
    nicol_mesh mesh_ = nullptr;
    nicol_scene scene_ = nullptr;
    nicol_framebuffer framebuffer_ = nullptr;
    nicol_camera camera_ = front_camera();
    bool good_ = false;
};

/// Runs body(i) on one thread each and counts the calls that returned false.
template <class Body>
int failures(int threads, Body body) {
    std::atomic<int> failed = 0;
    std::vector<std::thread> running;
    for (int i = 0; i < threads; ++i) {
        running.emplace_back([&failed, &body, i] {
            if (!body(i)) ++failed;
        });
    }
    for (std::thread& thread : running) thread.join();
    return failed;
}

}  // namespace

TEST_CASE("threads with a context each render what one alone does") {
    for (const std::uint32_t workers : {1U, 2U}) {
        std::array<std::vector<float>, 4> alone;
        {
            const nicol_context context = context_of(NICOL_BACKEND_EGL, workers);
            Painting painting(context);
            for (int i = 0; i < 4; ++i) alone[static_cast<std::size_t>(i)] = painting.frame(i);
            OK(nicol_context_release(context));
        }
        REQUIRE_FALSE(alone[0].empty());
        CHECK(failures(4, [&](int i) {
                  const nicol_context context =
                      context_of(i % 2 == 0 ? NICOL_BACKEND_EGL : NICOL_BACKEND_OSMESA, workers);
                  bool same = context != nullptr;
                  {
                      Painting painting(context);
                      for (int k = 0; k < 4; ++k)
                          same =
                              same && painting.frame(k + i) == alone[static_cast<std::size_t>((k + i) % 4)];
                  }
                  return nicol_context_release(context) == NICOL_OK && same;
              }) == 0);
    }
}

TEST_CASE("threads share a context, its objects and its end") {
    const nicol_context context = context_of(NICOL_BACKEND_EGL, 1);
    Painting first(context);
    const std::vector<float> alone = first.frame(0);
    REQUIRE_FALSE(alone.empty());
    CHECK(failures(4, [&](int i) {
              if (nicol_context_retain(context) != NICOL_OK || nicol_scene_retain(first.scene()) != NICOL_OK)
                  return false;
              bool same = true;
              {
                  Painting own(context, first);
                  for (int k = 0; k < 3; ++k) {
                      const Matrix place = placed(0.1 * i, 0, 0, 0.5);
                      same = same && own.frame(0) == alone &&
                             nicol_scene_set_transform(first.scene(), 0, place.rows) == NICOL_OK &&
                             !first.frame(k).empty();
                  }
              }
              return nicol_scene_release(first.scene()) == NICOL_OK &&
                     nicol_context_release(context) == NICOL_OK && same;
          }) == 0);
    OK(nicol_context_release(context));
}

TEST_CASE("threads fail, log and cancel at once") {
    std::atomic<int> told = 0;
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.backend = NICOL_BACKEND_EGL;
    options.threads = 1;
    options.cache_folder = "/proc/no/such/folder";  // causes a notice for every table that cannot be kept
    options.log = [](void* user, std::uint32_t, nicol_result, const char*) {
        ++*static_cast<std::atomic<int>*>(user);
    };
    options.log_user = &told;
    const Owned context(make(nicol_context_create, &options));
    CHECK(failures(4, [&](int i) {
              Painting painting(context);
              nicol_framebuffer framebuffer = nullptr;
              const std::uint32_t wrong = 20000 + static_cast<std::uint32_t>(i);
              const bool refused =
                  nicol_framebuffer_create(context, wrong, 1, 1, &framebuffer) ==
                      NICOL_ERROR_INVALID_ARGUMENT &&
                  std::string(nicol_last_error()).find(std::to_string(wrong)) != std::string::npos;
              nicol_render_options stop = plain_options();
              stop.progress = [](void*, const char*, double) -> std::int32_t { return 0; };
              const nicol_camera camera = front_camera();
              if (nicol_framebuffer_create(context, size, size, 3, &framebuffer) != NICOL_OK) return false;
              const bool cancelled =
                  nicol_render(painting.scene(), &camera, &stop, framebuffer) == NICOL_ERROR_CANCELLED;
              return nicol_framebuffer_release(framebuffer) == NICOL_OK && refused && cancelled &&
                     !painting.frame(i).empty();
          }) == 0);
    CHECK(told > 0);
}
