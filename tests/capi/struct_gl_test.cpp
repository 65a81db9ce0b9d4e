// SPDX-License-Identifier: MIT
// Descriptors of older and newer callers, and of callers that forgot the size.
#include <cstring>
#include <memory>

#include "capi.hpp"

using namespace capi_test;

namespace {

// A copy of `value` cut or filled up with zeros to `size` bytes, in a block of just that size, so that a
// sanitizer sees what reads further.
template <class T>
class Sized {
public:
    Sized(const T& value, std::size_t size) : block_(std::max(size, sizeof(std::uint32_t))) {
        std::memcpy(block_.data(), &value, std::min(size, sizeof(T)));
        const auto stored = static_cast<std::uint32_t>(size);
        std::memcpy(block_.data(), &stored, sizeof stored);
    }
    T* get() { return reinterpret_cast<T*>(block_.data()); }
    unsigned char& byte(std::size_t i) { return block_[i]; }
    const std::vector<unsigned char>& bytes() const { return block_; }

private:
    std::vector<unsigned char> block_;
};

// `call` must succeed with `good`; `older` is a size at which a caller of an older version would end.
template <class T, class Call>
void check_input(const T& good, std::size_t older, const char* name, Call call) {
    CAPTURE(name);
    FAILS(call(static_cast<const T*>(nullptr)), NICOL_ERROR_INVALID_ARGUMENT, name);
    OK(call(&good));
    for (const std::uint32_t size : {0U, 1U, 3U, 65537U, UINT32_MAX}) {
        T wrong = good;
        wrong.struct_size = size;
        FAILS(call(&wrong), NICOL_ERROR_INVALID_ARGUMENT, std::string(name) + "->struct_size");
    }
    Sized<T> newer(good, sizeof(T) + 24);
    OK(call(newer.get()));
    for (const std::size_t at : {sizeof(T), sizeof(T) + 11, sizeof(T) + 23}) {
        newer.byte(at) = 1;
        FAILS(call(newer.get()), NICOL_ERROR_INVALID_ARGUMENT, name);
        newer.byte(at) = 0;
    }
    Sized<T> cut(good, older);
    OK(call(cut.get()));
}

// The same for a struct that the library fills.
template <class T, class Call>
void check_output(const char* name, Call call) {
    CAPTURE(name);
    FAILS(call(static_cast<T*>(nullptr)), NICOL_ERROR_INVALID_ARGUMENT, name);
    T whole{};
    whole.struct_size = sizeof(T);
    OK(call(&whole));
    for (const std::uint32_t size : {0U, 3U}) {
        T wrong;
        std::memset(&wrong, 0x7e, sizeof wrong);
        wrong.struct_size = size;
        const T before = wrong;
        FAILS(call(&wrong), NICOL_ERROR_INVALID_ARGUMENT, std::string(name) + "->struct_size");
        CHECK(std::memcmp(&wrong, &before, sizeof wrong) == 0);
    }
    // An older caller gets what it has room for, a newer one keeps what this version does not know.
    Sized<T> older(whole, 8);
    OK(call(older.get()));
    CHECK(older.get()->struct_size == 8);
    Sized<T> newer(whole, sizeof(T) + 8);
    newer.byte(sizeof(T) + 3) = 77;
    OK(call(newer.get()));
    CHECK(newer.get()->struct_size == sizeof(T) + 8);
    CHECK(newer.byte(sizeof(T) + 3) == 77);
    CHECK(std::memcmp(newer.bytes().data() + 4, reinterpret_cast<unsigned char*>(&whole) + 4, 4) == 0);
}

}  // namespace

TEST_CASE("context options of any version") {
    for (const nicol_backend backend : every_backend) {
        nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
        options.backend = backend;
        const auto create = [](const nicol_context_options* given) {
            nicol_context context = marker<nicol_context>();
            const nicol_result result = nicol_context_create(given, &context);
            if (result == NICOL_OK) {
                OK(nicol_context_release(context));
            } else {
                CHECK(context == marker<nicol_context>());
            }
            return result;
        };
        // NULL is allowed here: all defaults. The rest is as everywhere.
        OK(create(nullptr));
        for (const std::uint32_t size : {0U, 3U, UINT32_MAX}) {
            nicol_context_options wrong = options;
            wrong.struct_size = size;
            FAILS(create(&wrong), NICOL_ERROR_INVALID_ARGUMENT, "options->struct_size");
        }
        Sized<nicol_context_options> newer(options, sizeof options + 8);
        OK(create(newer.get()));
        newer.byte(sizeof options + 7) = 1;
        FAILS(create(newer.get()), NICOL_ERROR_INVALID_ARGUMENT, "options");
        Sized<nicol_context_options> older(options, offsetof(nicol_context_options, device));
        OK(create(older.get()));
    }
}

TEST_CASE("asset descriptors of any version") {
    on_every_backend([](nicol_context context) {
        const std::vector<float> pixels(4, 0.5F);
        nicol_image image = NICOL_IMAGE_INIT;
        image.width = image.height = 2;
        image.channels = image.components = 1;
        image.pixels = pixels.data();
        image.byte_size = pixels.size() * sizeof(float);
        const auto from_image = [&](const nicol_image* given) {
            nicol_environment made = nullptr;
            const nicol_result result = nicol_environment_create_image(context, given, &made);
            CHECK((made != nullptr) == (result == NICOL_OK));
            OK(nicol_environment_release(made));
            return result;
        };
        check_input(image, offsetof(nicol_image, release), "image", from_image);

        nicol_sky sky = NICOL_SKY_INIT;
        sky.dop_max = 0.5F;
        const auto from_sky = [&](const nicol_sky* given) {
            nicol_environment made = nullptr;
            const nicol_result result = nicol_environment_create_sky(context, given, &made);
            CHECK((made != nullptr) == (result == NICOL_OK));
            OK(nicol_environment_release(made));
            return result;
        };
        check_input(sky, offsetof(nicol_sky, sun_direction), "sky", from_sky);

        const nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        const auto from_plastic = [&](const nicol_pplastic* given) {
            nicol_material made = nullptr;
            const nicol_result result = nicol_material_create_pplastic(context, given, &made);
            CHECK((made != nullptr) == (result == NICOL_OK));
            OK(nicol_material_release(made));
            return result;
        };
        check_input(plastic, offsetof(nicol_pplastic, alpha), "parameters", from_plastic);

        const nicol_conductor metal = NICOL_CONDUCTOR_INIT;
        const auto from_metal = [&](const nicol_conductor* given) {
            nicol_material made = nullptr;
            const nicol_result result = nicol_material_create_conductor(context, given, &made);
            CHECK((made != nullptr) == (result == NICOL_OK));
            OK(nicol_material_release(made));
            return result;
        };
        check_input(metal, offsetof(nicol_conductor, specular_reflectance), "parameters", from_metal);

        nicol_callback_material function = NICOL_CALLBACK_MATERIAL_INIT;
        function.mueller = [](void*, std::uint32_t, const double[3], const double[3],
                              double mueller[16]) -> std::int32_t {
            for (int i = 0; i < 16; ++i) mueller[i] = i == 0 ? 0.1 : 0;
            return 1;
        };
        const auto from_function = [&](const nicol_callback_material* given) {
            nicol_material made = nullptr;
            const nicol_result result = nicol_material_create_callback(context, given, &made);
            CHECK((made != nullptr) == (result == NICOL_OK));
            OK(nicol_material_release(made));
            return result;
        };
        check_input(function, offsetof(nicol_callback_material, user), "parameters", from_function);

        const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const std::uint32_t indices[] = {0, 1, 2};
        nicol_mesh_data data = NICOL_MESH_DATA_INIT;
        data.vertex_count = 3;
        data.triangle_count = 1;
        data.positions = positions;
        data.indices = indices;
        const auto from_data = [&](const nicol_mesh_data* given) {
            nicol_mesh made = nullptr;
            const nicol_result result = nicol_mesh_create(context, given, &made);
            CHECK((made != nullptr) == (result == NICOL_OK));
            OK(nicol_mesh_release(made));
            return result;
        };
        check_input(data, sizeof data, "data", from_data);
        Sized<nicol_mesh_data> cut(data, offsetof(nicol_mesh_data, indices));
        FAILS(from_data(cut.get()), NICOL_ERROR_INVALID_ARGUMENT, "data->indices");
    });
}

TEST_CASE("options of files of any version, which may be NULL") {
    on_every_backend([](nicol_context context) {
        const Folder folder;
        const std::string path = folder.write("none", "no file");
        const auto check = [&](auto good, auto call) {
            // Where the options are right, the file is looked at.
            FAILS(call(static_cast<decltype(&good)>(nullptr)), NICOL_ERROR_INVALID_FILE, path);
            for (const std::uint32_t size : {0U, 3U, UINT32_MAX}) {
                auto wrong = good;
                wrong.struct_size = size;
                FAILS(call(&wrong), NICOL_ERROR_INVALID_ARGUMENT, "options->struct_size");
            }
            Sized newer(good, sizeof good + 8);
            FAILS(call(newer.get()), NICOL_ERROR_INVALID_FILE, path);
            newer.byte(sizeof good + 5) = 1;
            FAILS(call(newer.get()), NICOL_ERROR_INVALID_ARGUMENT, "options");
            Sized older(good, 8);
            FAILS(call(older.get()), NICOL_ERROR_INVALID_FILE, path);
        };
        check(nicol_environment_load_options NICOL_ENVIRONMENT_LOAD_OPTIONS_INIT,
              [&](const nicol_environment_load_options* options) {
                  nicol_environment out = nullptr;
                  return nicol_environment_load(context, path.c_str(), options, &out);
              });
        check(nicol_measured NICOL_MEASURED_INIT, [&](const nicol_measured* options) {
            nicol_material out = nullptr;
            return nicol_material_load_measured(context, path.c_str(), options, &out);
        });
    });
}

TEST_CASE("scene and render descriptors of any version") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = stage.mesh;
        instance.material = stage.material;
        check_input(instance, offsetof(nicol_instance, to_world), "instance",
                    [&](const nicol_instance* given) {
                        return nicol_scene_add_instance(stage.scene, given, nullptr);
                    });
        check_input(stage.camera, offsetof(nicol_camera, near_clip), "camera",
                    [&](const nicol_camera* given) {
                        return nicol_render(stage.scene, given, nullptr, stage.framebuffer);
                    });

        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.order_low = 1;
        const auto render = [&](const nicol_render_options* given) {
            return nicol_render(stage.scene, &stage.camera, given, stage.framebuffer);
        };
        OK(render(nullptr));
        for (const std::uint32_t size : {0U, 3U, UINT32_MAX}) {
            nicol_render_options wrong = options;
            wrong.struct_size = size;
            FAILS(render(&wrong), NICOL_ERROR_INVALID_ARGUMENT, "options->struct_size");
        }
        Sized<nicol_render_options> newer(options, sizeof options + 8);
        OK(render(newer.get()));
        newer.byte(sizeof options) = 1;
        FAILS(render(newer.get()), NICOL_ERROR_INVALID_ARGUMENT, "options");
        Sized<nicol_render_options> older(options, offsetof(nicol_render_options, progress));
        OK(render(older.get()));

        const Folder folder;
        const nicol_observation image = NICOL_OBSERVATION_INIT;
        const std::string path = folder.file("image.png");
        check_input(image, offsetof(nicol_observation, exposure), "observation",
                    [&](const nicol_observation* given) {
                        return nicol_framebuffer_write_png(stage.framebuffer, given, path.c_str());
                    });
    });
}

TEST_CASE("structs that the library fills, of any version") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        check_output<nicol_context_info>(
            "info", [&](nicol_context_info* info) { return nicol_context_get_info(context, info); });
        check_output<nicol_environment_info>("info", [&](nicol_environment_info* info) {
            return nicol_environment_get_info(stage.environment, info);
        });
        check_output<nicol_statistics>("statistics", [&](nicol_statistics* statistics) {
            return nicol_framebuffer_get_statistics(stage.framebuffer, statistics);
        });
        const Folder folder;
        const std::string path = folder.write("scene.xml", R"(<scene version="3.0.0">
            <sensor type="perspective"><float name="fov" value="50"/>
            <film type="hdrfilm"><integer name="width" value="12"/><integer name="height" value="9"/></film>
            </sensor><shape type="cube"/></scene>)");
        nicol_scene scene = nullptr;
        OK(nicol_scene_load(context, path.c_str(), nullptr, 0, &scene));
        check_output<nicol_camera>(
            "camera", [&](nicol_camera* camera) { return nicol_scene_get_camera(scene, camera); });
        OK(nicol_scene_release(scene));
    });
}
