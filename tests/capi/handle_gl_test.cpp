// SPDX-License-Identifier: MIT
// Life and death of handles: NULL, wrong kinds, released ones, counts, any order, many threads.
#include <algorithm>
#include <numeric>
#include <thread>

#include "capi.hpp"

using namespace capi_test;

namespace {

// One live handle of each kind.
struct Everything {
    nicol_context context;
    nicol_environment environment = nullptr;
    nicol_material material = nullptr;
    nicol_mesh mesh = nullptr;
    nicol_scene scene = nullptr;
    nicol_framebuffer framebuffer = nullptr;

    explicit Everything(nicol_context owner) : context(owner) {
        const nicol_spectrum one = spectrum({1});
        OK(nicol_environment_create_constant(context, &one, &environment));
        OK(nicol_material_create_diffuse(context, nullptr, &material));
        OK(nicol_mesh_create_rectangle(context, &mesh));
        OK(nicol_scene_create(context, &scene));
        OK(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer));
    }

    void connect() const {
        OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material;
        OK(nicol_scene_add_instance(scene, &instance, nullptr));
    }
};

struct NamedCall {
    const char* name;
    std::function<nicol_result()> call;
};

// Every function of one handle kind, called with `handle` and otherwise good arguments.
std::vector<NamedCall> calls(nicol_context handle) {
    return {{"context_retain", [=] { return nicol_context_retain(handle); }},
            {"context_get_info",
             [=] {
                 nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
                 return nicol_context_get_info(handle, &info);
             }},
            {"environment_load",
             [=] {
                 nicol_environment out = nullptr;
                 return nicol_environment_load(handle, "x.exr", nullptr, &out);
             }},
            {"environment_create_image",
             [=] {
                 nicol_environment out = nullptr;
                 const float pixels[2] = {};
                 nicol_image image = NICOL_IMAGE_INIT;
                 image.width = image.channels = image.components = 1;
                 image.height = 2;
                 image.pixels = pixels;
                 image.byte_size = sizeof pixels;
                 return nicol_environment_create_image(handle, &image, &out);
             }},
            {"environment_create_constant",
             [=] {
                 nicol_environment out = nullptr;
                 const nicol_spectrum one = spectrum({1});
                 return nicol_environment_create_constant(handle, &one, &out);
             }},
            {"environment_create_sky",
             [=] {
                 nicol_environment out = nullptr;
                 const nicol_sky sky = NICOL_SKY_INIT;
                 return nicol_environment_create_sky(handle, &sky, &out);
             }},
            {"material_create_pplastic",
             [=] {
                 nicol_material out = nullptr;
                 const nicol_pplastic parameters = NICOL_PPLASTIC_INIT;
                 return nicol_material_create_pplastic(handle, &parameters, &out);
             }},
            {"material_create_diffuse",
             [=] {
                 nicol_material out = nullptr;
                 return nicol_material_create_diffuse(handle, nullptr, &out);
             }},
            {"environment_create_psh",
             [=] {
                 nicol_environment out = nullptr;
                 const double one[4] = {1, 0, 0, 0};
                 return nicol_environment_create_psh(handle, 0, 1, one, 4, &out);
             }},
            {"material_create_conductor",
             [=] {
                 nicol_material out = nullptr;
                 const nicol_conductor parameters = NICOL_CONDUCTOR_INIT;
                 return nicol_material_create_conductor(handle, &parameters, &out);
             }},
            {"material_load_measured",
             [=] {
                 nicol_material out = nullptr;
                 return nicol_material_load_measured(handle, "x.pbsdf", nullptr, &out);
             }},
            {"material_load_psh",
             [=] {
                 nicol_material out = nullptr;
                 return nicol_material_load_psh(handle, "x.npz", nullptr, &out);
             }},
            {"material_create_twosided",
             [=] {
                 nicol_material out = nullptr;
                 return nicol_material_create_twosided(handle, nullptr, &out);
             }},
            {"material_create_callback",
             [=] {
                 nicol_material out = nullptr;
                 nicol_callback_material parameters = NICOL_CALLBACK_MATERIAL_INIT;
                 parameters.mueller = [](void*, std::uint32_t, const double[3], const double[3],
                                         double[16]) -> std::int32_t { return 0; };
                 return nicol_material_create_callback(handle, &parameters, &out);
             }},
            {"mesh_load",
             [=] {
                 nicol_mesh out = nullptr;
                 return nicol_mesh_load(handle, "x.obj", &out);
             }},
            {"mesh_create",
             [=] {
                 nicol_mesh out = nullptr;
                 const nicol_mesh_data data = NICOL_MESH_DATA_INIT;
                 return nicol_mesh_create(handle, &data, &out);
             }},
            {"mesh_create_sphere",
             [=] {
                 nicol_mesh out = nullptr;
                 return nicol_mesh_create_sphere(handle, &out);
             }},
            {"mesh_create_rectangle",
             [=] {
                 nicol_mesh out = nullptr;
                 return nicol_mesh_create_rectangle(handle, &out);
             }},
            {"mesh_create_cube",
             [=] {
                 nicol_mesh out = nullptr;
                 return nicol_mesh_create_cube(handle, &out);
             }},
            {"scene_create",
             [=] {
                 nicol_scene out = nullptr;
                 return nicol_scene_create(handle, &out);
             }},
            {"scene_load",
             [=] {
                 nicol_scene out = nullptr;
                 return nicol_scene_load(handle, "x.xml", nullptr, 0, &out);
             }},
            {"framebuffer_create", [=] {
                 nicol_framebuffer out = nullptr;
                 return nicol_framebuffer_create(handle, 4, 4, 1, &out);
             }}};
}

std::vector<NamedCall> calls(nicol_mesh handle) {
    return {{"mesh_retain", [=] { return nicol_mesh_retain(handle); }},
            {"mesh_get_size", [=] {
                 std::uint32_t vertices = 0, triangles = 0;
                 return nicol_mesh_get_size(handle, &vertices, &triangles);
             }}};
}

std::vector<NamedCall> calls(nicol_scene handle, const Everything& with) {
    const nicol_mesh mesh = with.mesh;
    const nicol_material material = with.material;
    const nicol_framebuffer framebuffer = with.framebuffer;
    return {
        {"scene_retain", [=] { return nicol_scene_retain(handle); }},
        {"scene_add_instance",
         [=] {
             nicol_instance instance = NICOL_INSTANCE_INIT;
             instance.mesh = mesh;
             instance.material = material;
             return nicol_scene_add_instance(handle, &instance, nullptr);
         }},
        {"scene_set_transform", [=] { return nicol_scene_set_transform(handle, 0, placed(0, 0, 0).rows); }},
        {"scene_set_environment", [=] { return nicol_scene_set_environment(handle, nullptr, nullptr, 0); }},
        {"scene_get_environment",
         [=] {
             nicol_environment environment = marker<nicol_environment>();
             const nicol_result result = nicol_scene_get_environment(handle, &environment, nullptr, nullptr);
             if (result != NICOL_OK)
                 CHECK(environment == marker<nicol_environment>());
             else
                 CHECK(nicol_environment_release(environment) == NICOL_OK);
             return result;
         }},
        {"scene_get_camera",
         [=] {
             nicol_camera camera = NICOL_CAMERA_INIT;
             return nicol_scene_get_camera(handle, &camera);
         }},
        {"scene_get_film_size",
         [=] {
             std::uint32_t width = 0, height = 0;
             return nicol_scene_get_film_size(handle, &width, &height);
         }},
        {"scene_get_channels",
         [=] {
             std::uint32_t channels = 0;
             return nicol_scene_get_channels(handle, &channels);
         }},
        {"render", [=] {
             const nicol_camera camera = NICOL_CAMERA_INIT;
             return nicol_render(handle, &camera, nullptr, framebuffer);
         }}};
}

std::vector<NamedCall> calls(nicol_framebuffer handle, const Everything& with) {
    const nicol_scene scene = with.scene;
    return {{"framebuffer_retain", [=] { return nicol_framebuffer_retain(handle); }},
            {"framebuffer_get_size",
             [=] {
                 std::uint32_t width = 0, height = 0, channels = 0;
                 return nicol_framebuffer_get_size(handle, &width, &height, &channels);
             }},
            {"framebuffer_get_statistics",
             [=] {
                 nicol_statistics statistics = NICOL_STATISTICS_INIT;
                 return nicol_framebuffer_get_statistics(handle, &statistics);
             }},
            {"framebuffer_read",
             [=] {
                 float pixels[16] = {};
                 return nicol_framebuffer_read(handle, NICOL_PLANE_S0, 0, pixels, 0, sizeof pixels);
             }},
            {"framebuffer_write_exr", [=] { return nicol_framebuffer_write_exr(handle, "/nowhere/x.exr"); }},
            {"framebuffer_write_png",
             [=] {
                 const nicol_observation image = NICOL_OBSERVATION_INIT;
                 return nicol_framebuffer_write_png(handle, &image, "/nowhere/x.png");
             }},
            {"render", [=] {
                 const nicol_camera camera = NICOL_CAMERA_INIT;
                 return nicol_render(scene, &camera, nullptr, handle);
             }}};
}

std::vector<NamedCall> calls(nicol_environment handle, const Everything& with) {
    const nicol_scene scene = with.scene;
    return {{"environment_retain", [=] { return nicol_environment_retain(handle); }},
            // NULL is darkness there and no error.
            {"scene_set_environment", [=] {
                 return handle == nullptr ? nicol_environment_retain(handle)
                                          : nicol_scene_set_environment(scene, handle, nullptr, 0);
             }}};
}

std::vector<NamedCall> calls(nicol_material handle, const Everything& with) {
    const nicol_scene scene = with.scene;
    const nicol_mesh mesh = with.mesh;
    return {{"material_retain", [=] { return nicol_material_retain(handle); }},
            {"scene_add_instance", [=] {
                 nicol_instance instance = NICOL_INSTANCE_INIT;
                 instance.mesh = mesh;
                 instance.material = handle;
                 return nicol_scene_add_instance(scene, &instance, nullptr);
             }}};
}

std::vector<NamedCall> calls(nicol_mesh handle, const Everything& with) {
    std::vector<NamedCall> all = calls(handle);
    const nicol_scene scene = with.scene;
    const nicol_material material = with.material;
    all.push_back({"scene_add_instance", [=] {
                       nicol_instance instance = NICOL_INSTANCE_INIT;
                       instance.mesh = handle;
                       instance.material = material;
                       return nicol_scene_add_instance(scene, &instance, nullptr);
                   }});
    return all;
}

std::vector<NamedCall> calls(nicol_context handle, const Everything&) {
    return calls(handle);
}

void expect_refusal(const std::vector<NamedCall>& list, const std::string& kind) {
    for (const NamedCall& named : list) {
        CAPTURE(named.name);
        FAILS(named.call(), NICOL_ERROR_INVALID_HANDLE, kind);
    }
}

// What stands for no live handle of this kind: NULL, an address that was never one, and the other kinds.
template <class Handle>
void check_strangers(const Everything& all, const char* kind) {
    CAPTURE(kind);
    std::vector<const void*> strangers{nullptr, marker<void*>()};
    for (const void* other :
         {static_cast<const void*>(all.context), static_cast<const void*>(all.environment),
          static_cast<const void*>(all.material), static_cast<const void*>(all.mesh),
          static_cast<const void*>(all.scene), static_cast<const void*>(all.framebuffer)}) {
        strangers.push_back(other);
    }
    int own = 0;
    for (const void* stranger : strangers) {
        const auto handle = static_cast<Handle>(const_cast<void*>(stranger));
        if constexpr (std::is_same_v<Handle, nicol_context>) {
            if (handle == all.context && ++own > 0) continue;
        } else if constexpr (std::is_same_v<Handle, nicol_environment>) {
            if (handle == all.environment && ++own > 0) continue;
        } else if constexpr (std::is_same_v<Handle, nicol_material>) {
            if (handle == all.material && ++own > 0) continue;
        } else if constexpr (std::is_same_v<Handle, nicol_mesh>) {
            if (handle == all.mesh && ++own > 0) continue;
        } else if constexpr (std::is_same_v<Handle, nicol_scene>) {
            if (handle == all.scene && ++own > 0) continue;
        } else {
            if (handle == all.framebuffer && ++own > 0) continue;
        }
        expect_refusal(calls(handle, all), kind);
    }
    CHECK(own == 1);
}

// Release functions of a set of handles, by position.
std::vector<std::function<nicol_result()>> releases(const Everything& all) {
    return {[=] { return nicol_context_release(all.context); },
            [=] { return nicol_environment_release(all.environment); },
            [=] { return nicol_material_release(all.material); },
            [=] { return nicol_mesh_release(all.mesh); },
            [=] { return nicol_scene_release(all.scene); },
            [=] { return nicol_framebuffer_release(all.framebuffer); }};
}

}  // namespace

TEST_CASE("releasing NULL does nothing") {
    OK(nicol_context_release(nullptr));
    OK(nicol_environment_release(nullptr));
    OK(nicol_material_release(nullptr));
    OK(nicol_mesh_release(nullptr));
    OK(nicol_scene_release(nullptr));
    OK(nicol_framebuffer_release(nullptr));
}

TEST_CASE("every function refuses NULL, strangers and handles of other kinds") {
    on_every_backend([](nicol_context context) {
        const Everything all(context);
        check_strangers<nicol_context>(all, "nicol_context");
        check_strangers<nicol_environment>(all, "nicol_environment");
        check_strangers<nicol_material>(all, "nicol_material");
        check_strangers<nicol_mesh>(all, "nicol_mesh");
        check_strangers<nicol_scene>(all, "nicol_scene");
        check_strangers<nicol_framebuffer>(all, "nicol_framebuffer");
        // Which kind it was is part of the message.
        FAILS(nicol_mesh_retain(reinterpret_cast<nicol_mesh>(all.scene)), NICOL_ERROR_INVALID_HANDLE,
              "nicol_scene");
        // Nor can one be released as another.
        FAILS(nicol_mesh_release(reinterpret_cast<nicol_mesh>(all.scene)), NICOL_ERROR_INVALID_HANDLE,
              "nicol_mesh");
        std::uint32_t channels = 0;
        OK(nicol_scene_get_channels(all.scene, &channels));
        for (std::size_t i = 1; i < 6; ++i) OK(releases(all)[i]());
    });
}

TEST_CASE("every function refuses a released handle, and no handle can be released twice") {
    on_every_backend([](nicol_context context) {
        OK(nicol_context_retain(context));  // one for the helper that releases it
        const Everything gone(context);
        for (const auto& release : releases(gone)) OK(release());
        OK(nicol_context_retain(context));
        const nicol_context other = make_context(NICOL_BACKEND_OSMESA);
        OK(nicol_context_release(other));
        // Their addresses may be used again by handles made later, so nothing is made from here on.
        expect_refusal(calls(other), "released");
        expect_refusal(calls(gone.environment, gone), "");
        expect_refusal(calls(gone.material, gone), "");
        expect_refusal(calls(gone.mesh, gone), "");
        expect_refusal(calls(gone.scene, gone), "");
        expect_refusal(calls(gone.framebuffer, gone), "");
        FAILS(nicol_context_release(other), NICOL_ERROR_INVALID_HANDLE, "released");
        for (std::size_t i = 1; i < 6; ++i)
            FAILS(releases(gone)[i](), NICOL_ERROR_INVALID_HANDLE, "released");
        OK(nicol_context_release(context));
    });
}

TEST_CASE("a handle lives until each of its references is released") {
    on_every_backend([](nicol_context context) {
        const Everything all(context);
        const std::vector<std::function<nicol_result()>> retains{
            [&] { return nicol_context_retain(all.context); },
            [&] { return nicol_environment_retain(all.environment); },
            [&] { return nicol_material_retain(all.material); },
            [&] { return nicol_mesh_retain(all.mesh); },
            [&] { return nicol_scene_retain(all.scene); },
            [&] { return nicol_framebuffer_retain(all.framebuffer); }};
        for (std::size_t i = 0; i < retains.size(); ++i) {
            CAPTURE(i);
            for (int n = 0; n < 5; ++n) OK(retains[i]());
            for (int n = 0; n < 5; ++n) OK(releases(all)[i]());
            OK(retains[i]());  // still alive
            OK(releases(all)[i]());
            if (i == 0) continue;  // the helper releases the context
            OK(releases(all)[i]());
            FAILS(retains[i](), NICOL_ERROR_INVALID_HANDLE, "released");
        }
    });
}

TEST_CASE("handles may be released in any order") {
    // Each of the 720 orders of six handles, with a few contexts only: the context is retained for all but
    // every 60th order, where it goes for good in the middle.
    for (const nicol_backend backend : every_backend) {
        CAPTURE(backend);
        nicol_context context = make_context(backend);
        std::vector<std::size_t> order(6);
        std::iota(order.begin(), order.end(), std::size_t{0});
        int count = 0;
        do {
            const bool last = ++count % 60 == 0;
            if (!last) OK(nicol_context_retain(context));
            const Everything all(context);
            if (count % 4 != 0) all.connect();
            if (last) {
                const nicol_camera camera = front_camera();
                OK(nicol_render(all.scene, &camera, nullptr, all.framebuffer));
            }
            for (const std::size_t i : order) OK(releases(all)[i]());
            if (last) context = make_context(backend);
        } while (std::next_permutation(order.begin(), order.end()));
        CHECK(count == 720);
        OK(nicol_context_release(context));
    }
}

TEST_CASE("objects work on after their context and their parts were released") {
    for (const nicol_backend backend : every_backend) {
        CAPTURE(backend);
        const Everything all(make_context(backend));
        all.connect();
        OK(nicol_context_release(all.context));
        OK(nicol_environment_release(all.environment));
        OK(nicol_material_release(all.material));
        OK(nicol_mesh_release(all.mesh));
        const nicol_camera camera = front_camera();
        OK(nicol_render(all.scene, &camera, nullptr, all.framebuffer));
        OK(nicol_scene_release(all.scene));
        CHECK(read_plane(all.framebuffer, NICOL_PLANE_S0)[5] > 0);
        OK(nicol_framebuffer_release(all.framebuffer));
    }
}

TEST_CASE("objects of different contexts do not mix") {
    const nicol_context contexts[] = {make_context(NICOL_BACKEND_EGL), make_context(NICOL_BACKEND_OSMESA)};
    const Everything a(contexts[0]), b(contexts[1]);
    nicol_instance instance = NICOL_INSTANCE_INIT;
    std::uint32_t id = 77;
    instance.mesh = b.mesh;
    instance.material = a.material;
    FAILS(nicol_scene_add_instance(a.scene, &instance, &id), NICOL_ERROR_INVALID_HANDLE, "contexts");
    instance.mesh = a.mesh;
    instance.material = b.material;
    FAILS(nicol_scene_add_instance(a.scene, &instance, &id), NICOL_ERROR_INVALID_HANDLE, "contexts");
    CHECK(id == 77);
    FAILS(nicol_scene_set_environment(a.scene, b.environment, nullptr, 0), NICOL_ERROR_INVALID_HANDLE,
          "contexts");
    const nicol_camera camera = front_camera();
    FAILS(nicol_render(a.scene, &camera, nullptr, b.framebuffer), NICOL_ERROR_INVALID_HANDLE, "contexts");
    FAILS(nicol_render(b.scene, &camera, nullptr, a.framebuffer), NICOL_ERROR_INVALID_HANDLE, "contexts");
    for (const Everything* all : {&a, &b}) {
        for (const auto& release : releases(*all)) OK(release());
    }
}

TEST_CASE("threads may share and drop handles while others use them") {
    on_every_backend([](nicol_context context) {
        for (int round = 0; round < 10; ++round) {
            OK(nicol_context_retain(context));
            const Everything all(context);
            all.connect();
            const nicol_camera camera = front_camera();
            std::vector<std::string> wrong(4);
            std::vector<std::thread> threads;
            for (std::size_t t = 0; t < wrong.size(); ++t) {
                threads.emplace_back([&, t] {
                    const auto expect_alive_or_gone = [&](nicol_result result) {
                        if (result != NICOL_OK && result != NICOL_ERROR_INVALID_HANDLE)
                            wrong[t] = nicol_last_error();
                    };
                    for (int n = 0; n < 3; ++n) {
                        expect_alive_or_gone(nicol_render(all.scene, &camera, nullptr, all.framebuffer));
                        std::uint32_t vertices = 0, triangles = 0;
                        expect_alive_or_gone(nicol_mesh_get_size(all.mesh, &vertices, &triangles));
                    }
                    // The first thread to come drops what the others still use.
                    for (std::size_t i = 1; i < 6; ++i) expect_alive_or_gone(releases(all)[i]());
                });
            }
            for (std::thread& thread : threads) thread.join();
            for (const std::string& message : wrong) CHECK(message == "");
            for (std::size_t i = 1; i < 6; ++i) CHECK(releases(all)[i]() == NICOL_ERROR_INVALID_HANDLE);
            OK(nicol_context_release(context));
        }
    });
}
