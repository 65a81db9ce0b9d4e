// SPDX-License-Identifier: MIT
// Cameras and scenes.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "assets.hpp"
#include "camera.hpp"
#include "handles.hpp"
#include "import/load_scene.hpp"
#include "initialiser.hpp"
#include "scene/path_depth.hpp"
#include "scene/rotation.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

SceneParameters parameters_from(const char* const* definitions, std::uint32_t count) {
    if (count > 0) require(definitions, "definitions");
    SceneParameters parameters;
    for (std::uint32_t i = 0; i < count; ++i) {
        require(definitions[i], "definitions[...]");
        const std::string text = definitions[i];
        const std::size_t equals = text.find('=');
        if (equals == 0 || equals == std::string::npos) {
            refuse("the definition \"" + text + "\" must have the form name=value");
        }
        parameters[text.substr(0, equals)] = text.substr(equals + 1);
    }
    return parameters;
}

InstanceRoles roles_from(std::uint32_t flags, const char* name) {
    constexpr std::uint32_t all =
        NICOL_INSTANCE_CASTS_NO_SHADOWS | NICOL_INSTANCE_RECEIVES_NO_SHADOWS | NICOL_INSTANCE_INVISIBLE;
    if ((flags & ~all) != 0)
        refuse(std::string(name) + " is " + std::to_string(flags) +
               "; it must be a sum of NICOL_INSTANCE_...");
    return {.casts_shadows = (flags & NICOL_INSTANCE_CASTS_NO_SHADOWS) == 0,
            .receives_shadows = (flags & NICOL_INSTANCE_RECEIVES_NO_SHADOWS) == 0,
            .visible = (flags & NICOL_INSTANCE_INVISIBLE) == 0};
}

std::uint32_t flags_of(const InstanceRoles& roles) {
    return (roles.casts_shadows ? 0 : NICOL_INSTANCE_CASTS_NO_SHADOWS) |
           (roles.receives_shadows ? 0 : NICOL_INSTANCE_RECEIVES_NO_SHADOWS) |
           (roles.visible ? 0 : NICOL_INSTANCE_INVISIBLE);
}

const Film& film_of(const SceneState& scene) {
    if (!scene.film)
        throw Error(ErrorCode::unsupported, "only a scene loaded from a file has a camera and a film");
    return *scene.film;
}

glm::dmat4 matrix_or_identity(const double* rows) {
    if (rows == nullptr) return glm::dmat4(1.0);
    return matrix(rows);
}

/// Loads a scene, for load().
struct SceneLoader {
    const char* const* definitions;
    std::uint32_t definition_count;

    std::shared_ptr<SceneState> operator()(const std::filesystem::path& path, const LoadBudget& budget,
                                           const SessionPtr& session) const {
        LoadedScene loaded = session->on_workers(
            [&] { return load_scene(path, parameters_from(definitions, definition_count), budget); });
        for (const std::string& notice : loaded.notices) session->notice(notice);
        auto state = std::make_shared<SceneState>(session);
        state->scene = std::move(loaded.scene);
        state->loaded = MemoryShare(session->memory, session->memory ? bytes_of(state->scene) : 0);
        state->film = {.camera = loaded.camera,
                       .width = static_cast<std::uint32_t>(loaded.width),
                       .height = static_cast<std::uint32_t>(loaded.height),
                       .luminance = loaded.luminance,
                       .sample_count = loaded.sample_count,
                       .filter = loaded.filter,
                       .max_depth = loaded.max_depth,
                       .aovs = loaded.aovs};
        state->files = std::move(loaded.files);
        state->animation = std::move(loaded.animation);
        return state;
    }
};

}  // namespace

nicol_result nicol_scene_create(nicol_context context, nicol_scene* scene) {
    return guarded([&] {
        require(scene, "scene");
        const SessionPtr session = resolve(context).session;
        *scene = make_handle<nicol_scene_impl>(session, std::make_shared<SceneState>(session));
    });
}

nicol_result nicol_scene_load(nicol_context context, const char* path, const char* const* definitions,
                              uint32_t definition_count, nicol_scene* scene) {
    return load(context, path, scene, "scene", SceneLoader{definitions, definition_count});
}

nicol_result nicol_scene_load_memory(nicol_context context, const nicol_memory_file* file,
                                     const char* const* definitions, uint32_t definition_count,
                                     nicol_scene* scene) {
    return load(context, file, scene, "scene", SceneLoader{definitions, definition_count});
}

nicol_result nicol_scene_set_time(nicol_scene scene, double time) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        SceneState& state = *self.content;
        const Edit edit(self);
        if (!state.animation)
            throw Error(ErrorCode::unsupported,
                        "only a scene loaded from a glTF file with animations has times");
        state.animation->set_time(time, self.session->load_limits, state.scene, state.film->camera);
    });
}

nicol_result nicol_scene_add_instance(nicol_scene scene, const nicol_instance* instance, uint32_t* id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const nicol_instance given = read_struct(instance, nicol_instance NICOL_INSTANCE_INIT, "instance");
        const InstanceRoles roles = roles_from(given.flags, "instance->flags");
        const nicol_mesh_impl& mesh = resolve(given.mesh);
        const nicol_material_impl& material = resolve(given.material);
        require_same_context(self, mesh);
        require_same_context(self, material);
        const Edit edit(self);
        const std::uint32_t added = self.content->scene.add({.mesh = mesh.content,
                                                             .material = material.content,
                                                             .to_world = matrix(given.to_world),
                                                             .roles = roles});
        if (id != nullptr) *id = added;
    });
}

nicol_result nicol_scene_set_transform(nicol_scene scene, uint32_t id, const double to_world[16]) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(to_world, "to_world");
        const Edit edit(self);
        self.content->scene.set_transform(id, matrix(to_world));
    });
}

nicol_result nicol_scene_set_mesh(nicol_scene scene, uint32_t id, nicol_mesh mesh) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const nicol_mesh_impl& given = resolve(mesh);
        require_same_context(self, given);
        const Edit edit(self);
        self.content->scene.set_mesh(id, given.content);
    });
}

nicol_result nicol_scene_set_material(nicol_scene scene, uint32_t id, nicol_material material) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const nicol_material_impl& given = resolve(material);
        require_same_context(self, given);
        const Edit edit(self);
        self.content->scene.set_material(id, given.content);
    });
}

nicol_result nicol_scene_set_instance_flags(nicol_scene scene, uint32_t id, uint32_t flags) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const InstanceRoles roles = roles_from(flags, "flags");
        const Edit edit(self);
        self.content->scene.set_roles(id, roles);
    });
}

nicol_result nicol_scene_get_instance_flags(nicol_scene scene, uint32_t id, uint32_t* flags) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(flags, "flags");
        const Edit edit(self);
        *flags = flags_of(self.content->scene.at(id).roles);
    });
}

nicol_result nicol_scene_remove_instance(nicol_scene scene, uint32_t id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        self.content->scene.remove(id);
    });
}

nicol_result nicol_scene_get_instance(nicol_scene scene, uint32_t id, nicol_mesh* mesh,
                                      nicol_material* material, double to_world[16]) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        const Instance& instance = self.content->scene.at(id);
        write_handle(self.session, instance.mesh, mesh,
                     [&] { write_handle(self.session, instance.material, material, [] {}); });
        if (to_world != nullptr) write_matrix(instance.to_world, to_world);
    });
}

nicol_result nicol_scene_get_instance_count(nicol_scene scene, uint32_t* instances) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(instances, "instances");
        const Edit edit(self);
        *instances = static_cast<uint32_t>(self.content->scene.ids().size());
    });
}

nicol_result nicol_scene_get_instance_ids(nicol_scene scene, uint32_t* ids, uint64_t count) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        write_ids(self.content->scene.ids(), ids, count, "instances");
    });
}

nicol_result nicol_scene_set_environment(nicol_scene scene, nicol_environment environment,
                                         const double to_world[16], double scale) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        EnvironmentPtr light;
        if (environment != nullptr) {
            const nicol_environment_impl& source = resolve(environment);
            require_same_context(self, source);
            light = source.content;
        }
        const glm::dmat3 rotation = rotation_of(matrix_or_identity(to_world), "environment");
        const Edit edit(self);
        self.content->scene.set_environment(light, rotation, scale);
    });
}

nicol_result nicol_scene_hide_emitters(nicol_scene scene, uint32_t hide) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const bool hidden = switch_from(hide, "hide");
        const Edit edit(self);
        self.content->scene.hide_emitters(hidden);
    });
}

nicol_result nicol_scene_get_environment(nicol_scene scene, nicol_environment* environment,
                                         double to_world[16], double* scale) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(environment, "environment");
        const Edit edit(self);
        const Scene& content = self.content->scene;
        const bool lit = content.environment() != nullptr && content.light_scale() != 0;
        *environment =
            lit ? make_handle<nicol_environment_impl>(self.session, content.environment()) : nullptr;
        if (to_world != nullptr)
            write_matrix(lit ? glm::dmat4(content.light_rotation()) : glm::dmat4(1.0), to_world);
        if (scale != nullptr) *scale = lit ? content.light_scale() : 1;
    });
}

nicol_result nicol_scene_get_bounds(nicol_scene scene, double lower[3], double upper[3]) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(lower, "lower");
        require(upper, "upper");
        const Edit edit(self);
        Box box;
        for (const Instance& instance : self.content->scene.instances())
            box.add(*instance.mesh, instance.to_world);
        if (box.empty()) refuse("the scene has no instances");
        write_box(box, lower, upper);
    });
}

nicol_result nicol_scene_get_camera(nicol_scene scene, nicol_camera* camera) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        std::optional<Edit> edit;  // only a scene with an animation changes its camera
        if (self.content->animation) edit.emplace(self);
        const Camera& from = film_of(*self.content).camera;
        write_struct(camera, camera_to(from), "camera");
    });
}

nicol_result nicol_scene_get_film_size(nicol_scene scene, uint32_t* width, uint32_t* height) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(width, "width");
        require(height, "height");
        const Film& film = film_of(*self.content);
        *width = film.width;
        *height = film.height;
    });
}

nicol_result nicol_scene_get_sample_count(nicol_scene scene, uint32_t* samples) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(samples, "samples");
        *samples = film_of(*self.content).sample_count;
    });
}

nicol_result nicol_scene_get_filter(nicol_scene scene, nicol_filter* filter) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(filter, "filter");
        const ReconstructionFilter& of_film = film_of(*self.content).filter;
        *filter = {.kind = static_cast<nicol_filter_kind>(of_film.kind),
                   .reserved = 0,
                   .size = of_film.size,
                   .b = of_film.b,
                   .c = of_film.c};
    });
}

nicol_result nicol_scene_get_max_depth(nicol_scene scene, int32_t* max_depth) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(max_depth, "max_depth");
        const int depth = film_of(*self.content).max_depth;
        *max_depth = depth == kUnlimitedDepth ? NICOL_DEPTH_UNLIMITED : depth;
    });
}

nicol_result nicol_scene_get_aovs(nicol_scene scene, uint32_t* aovs) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(aovs, "aovs");
        *aovs = film_of(*self.content).aovs;
    });
}

nicol_result nicol_scene_get_file_count(nicol_scene scene, uint32_t* count) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(count, "count");
        *count = static_cast<uint32_t>(self.content->files.size());
    });
}

nicol_result nicol_scene_get_file(nicol_scene scene, uint32_t index, nicol_scene_file* file) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        nicol_scene_file out = NICOL_SCENE_FILE_INIT;
        const std::vector<FileRecord>& files = self.content->files;
        if (index >= files.size())
            refuse("index is " + std::to_string(index) + "; the scene was made of " +
                   std::to_string(files.size()) + " files");
        out.path = files[index].path.c_str();
        out.digest = files[index].digest.c_str();
        out.bytes = files[index].bytes;
        write_struct(file, out, "file");
    });
}

nicol_result nicol_scene_get_channels(nicol_scene scene, uint32_t* channels) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(channels, "channels");
        const Edit edit(self);
        const int parts = self.content->scene.channels();
        const bool luminance = self.content->film && self.content->film->luminance;
        *channels = luminance && parts == 3 ? 1 : static_cast<uint32_t>(parts);
    });
}

nicol_result nicol_scene_retain(nicol_scene scene) {
    return retain(scene);
}
nicol_result nicol_scene_release(nicol_scene scene) {
    return release(scene);
}

NICOL_INITIALISER(nicol_instance, NICOL_INSTANCE_INIT)
NICOL_INITIALISER(nicol_scene_file, NICOL_SCENE_FILE_INIT)
