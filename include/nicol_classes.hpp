// SPDX-License-Identifier: MIT
// Classes of nicol.hpp, which includes this file. Made of the C headers by samples/bindings/generate.py:
// change those, not this file. nicol_scene_load() is the function Scene::load(), nicol_scene_get_camera()
// the method get_camera() of a Scene, and nicol_render() the function nicol::render(). The C headers say
// what each function does. Arguments are those of C, with std::span for an array and its length. Results
// are returned instead of written through pointers. A failure throws Error.
#ifndef NICOL_CLASSES_HPP
#define NICOL_CLASSES_HPP

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

#include "nicol.hpp"

// clang-format off
namespace nicol {

class Context : public Owned<nicol_context, nicol_context_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static Context create(const nicol_context_options* options = nullptr) {
        auto context = nicol_context{};
        check(nicol_context_create(options, &context));
        return Context(context);
    }
    void set_log(nicol_log_callback log, void* log_user) const {
        check(nicol_context_set_log(get(), log, log_user));
    }
    [[nodiscard]] nicol_context_info get_info() const {
        auto info = defaults(nicol_context_info_init);
        check(nicol_context_get_info(get(), &info));
        return info;
    }
    [[nodiscard]] static Context create_host(const nicol_host* host, const nicol_context_options* options = nullptr) {
        auto context = nicol_context{};
        check(nicol_context_create_host(host, options, &context));
        return Context(context);
    }
};

class Environment : public Owned<nicol_environment, nicol_environment_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static Environment load(nicol_context context, const char* path, const nicol_environment_load_options* options = nullptr) {
        auto environment = nicol_environment{};
        check(nicol_environment_load(context, path, options, &environment));
        return Environment(environment);
    }
    [[nodiscard]] static Environment load_memory(nicol_context context, const nicol_memory_file* file, const nicol_environment_load_options* options = nullptr) {
        auto environment = nicol_environment{};
        check(nicol_environment_load_memory(context, file, options, &environment));
        return Environment(environment);
    }
    [[nodiscard]] static Environment create_image(nicol_context context, const nicol_image* image) {
        auto environment = nicol_environment{};
        check(nicol_environment_create_image(context, image, &environment));
        return Environment(environment);
    }
    [[nodiscard]] static Environment create_constant(nicol_context context, const nicol_spectrum* radiance) {
        auto environment = nicol_environment{};
        check(nicol_environment_create_constant(context, radiance, &environment));
        return Environment(environment);
    }
    [[nodiscard]] static Environment create_sky(nicol_context context, const nicol_sky* sky) {
        auto environment = nicol_environment{};
        check(nicol_environment_create_sky(context, sky, &environment));
        return Environment(environment);
    }
    [[nodiscard]] static Environment create_psh(nicol_context context, uint32_t order, uint32_t channels, std::span<const double> coefficients) {
        auto environment = nicol_environment{};
        check(nicol_environment_create_psh(context, order, channels, coefficients.data(), coefficients.size(), &environment));
        return Environment(environment);
    }
    [[nodiscard]] nicol_environment_info get_info() const {
        auto info = defaults(nicol_environment_info_init);
        check(nicol_environment_get_info(get(), &info));
        return info;
    }
    void write(const nicol_file_options* options, const char* path) const {
        check(nicol_environment_write(get(), options, path));
    }
};

class Texture : public Owned<nicol_texture, nicol_texture_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static Texture create_image(nicol_context context, const nicol_texture_image* image, const nicol_texture_options* options = nullptr) {
        auto texture = nicol_texture{};
        check(nicol_texture_create_image(context, image, options, &texture));
        return Texture(texture);
    }
    [[nodiscard]] static Texture load(nicol_context context, const char* path, const nicol_texture_options* options = nullptr) {
        auto texture = nicol_texture{};
        check(nicol_texture_load(context, path, options, &texture));
        return Texture(texture);
    }
    [[nodiscard]] static Texture load_memory(nicol_context context, const nicol_memory_file* file, const nicol_texture_options* options = nullptr) {
        auto texture = nicol_texture{};
        check(nicol_texture_load_memory(context, file, options, &texture));
        return Texture(texture);
    }
    [[nodiscard]] static Texture create_checkerboard(nicol_context context, const nicol_spectrum* color0, const nicol_spectrum* color1, const double to_uv[9]) {
        auto texture = nicol_texture{};
        check(nicol_texture_create_checkerboard(context, color0, color1, to_uv, &texture));
        return Texture(texture);
    }
    [[nodiscard]] static Texture create_vertex_colors(nicol_context context) {
        auto texture = nicol_texture{};
        check(nicol_texture_create_vertex_colors(context, &texture));
        return Texture(texture);
    }
    [[nodiscard]] static Texture create_face_colors(nicol_context context) {
        auto texture = nicol_texture{};
        check(nicol_texture_create_face_colors(context, &texture));
        return Texture(texture);
    }
};

class Material : public Owned<nicol_material, nicol_material_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static Material create_pplastic(nicol_context context, const nicol_pplastic* parameters) {
        auto material = nicol_material{};
        check(nicol_material_create_pplastic(context, parameters, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_plastic(nicol_context context, const nicol_plastic* parameters) {
        auto material = nicol_material{};
        check(nicol_material_create_plastic(context, parameters, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_principled(nicol_context context, const nicol_principled* parameters) {
        auto material = nicol_material{};
        check(nicol_material_create_principled(context, parameters, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_diffuse(nicol_context context, const nicol_spectrum* reflectance) {
        auto material = nicol_material{};
        check(nicol_material_create_diffuse(context, reflectance, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_conductor(nicol_context context, const nicol_conductor* parameters) {
        auto material = nicol_material{};
        check(nicol_material_create_conductor(context, parameters, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_dielectric(nicol_context context, const nicol_dielectric* parameters) {
        auto material = nicol_material{};
        check(nicol_material_create_dielectric(context, parameters, &material));
        return Material(material);
    }
    [[nodiscard]] static Material load_measured(nicol_context context, const char* path, const nicol_measured* options = nullptr) {
        auto material = nicol_material{};
        check(nicol_material_load_measured(context, path, options, &material));
        return Material(material);
    }
    [[nodiscard]] static Material load_measured_memory(nicol_context context, const nicol_memory_file* file, const nicol_measured* options = nullptr) {
        auto material = nicol_material{};
        check(nicol_material_load_measured_memory(context, file, options, &material));
        return Material(material);
    }
    [[nodiscard]] static Material load_psh(nicol_context context, const char* path, const nicol_psh_matrix* options = nullptr) {
        auto material = nicol_material{};
        check(nicol_material_load_psh(context, path, options, &material));
        return Material(material);
    }
    [[nodiscard]] static Material load_psh_memory(nicol_context context, const nicol_memory_file* file, const nicol_psh_matrix* options = nullptr) {
        auto material = nicol_material{};
        check(nicol_material_load_psh_memory(context, file, options, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_twosided(nicol_context context, nicol_material front) {
        auto material = nicol_material{};
        check(nicol_material_create_twosided(context, front, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_scaled(nicol_context context, nicol_material base, nicol_texture scale) {
        auto material = nicol_material{};
        check(nicol_material_create_scaled(context, base, scale, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_blend(nicol_context context, nicol_material first, nicol_material second, nicol_texture weight) {
        auto material = nicol_material{};
        check(nicol_material_create_blend(context, first, second, weight, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_normal_map(nicol_context context, nicol_material base, nicol_texture normals, uint32_t mirrored_y) {
        auto material = nicol_material{};
        check(nicol_material_create_normal_map(context, base, normals, mirrored_y, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_bump_map(nicol_context context, nicol_material base, nicol_texture heights, double scale) {
        auto material = nicol_material{};
        check(nicol_material_create_bump_map(context, base, heights, scale, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_rotated(nicol_context context, nicol_material base, nicol_texture directions, double angle) {
        auto material = nicol_material{};
        check(nicol_material_create_rotated(context, base, directions, angle, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_mask(nicol_context context, nicol_material base, nicol_texture opacity) {
        auto material = nicol_material{};
        check(nicol_material_create_mask(context, base, opacity, &material));
        return Material(material);
    }
    [[nodiscard]] static Material create_callback(nicol_context context, const nicol_callback_material* parameters) {
        auto material = nicol_material{};
        check(nicol_material_create_callback(context, parameters, &material));
        return Material(material);
    }
    void write(const nicol_file_options* options, const char* path) const {
        check(nicol_material_write(get(), options, path));
    }
};

class Mesh : public Owned<nicol_mesh, nicol_mesh_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static Mesh load(nicol_context context, const char* path) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_load(context, path, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh load_memory(nicol_context context, const nicol_memory_file* file) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_load_memory(context, file, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create(nicol_context context, const nicol_mesh_data* data) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create(context, data, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create_sphere(nicol_context context) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create_sphere(context, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create_divided_sphere(nicol_context context, uint32_t segments) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create_divided_sphere(context, segments, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create_rectangle(nicol_context context) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create_rectangle(context, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create_cube(nicol_context context) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create_cube(context, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create_disk(nicol_context context) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create_disk(context, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create_cylinder(nicol_context context, const double p0[3], const double p1[3], double radius) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create_cylinder(context, p0, p1, radius, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] static Mesh create_deformed(nicol_context context, nicol_mesh base, const nicol_deformation* deformation) {
        auto mesh = nicol_mesh{};
        check(nicol_mesh_create_deformed(context, base, deformation, &mesh));
        return Mesh(mesh);
    }
    [[nodiscard]] std::tuple<uint32_t, uint32_t> get_size() const {
        auto vertices = uint32_t{};
        auto triangles = uint32_t{};
        check(nicol_mesh_get_size(get(), &vertices, &triangles));
        return {vertices, triangles};
    }
    [[nodiscard]] std::tuple<std::array<double, 3>, std::array<double, 3>> get_bounds() const {
        std::array<double, 3> lower{};
        std::array<double, 3> upper{};
        check(nicol_mesh_get_bounds(get(), lower.data(), upper.data()));
        return {lower, upper};
    }
};

class Scene : public Owned<nicol_scene, nicol_scene_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static Scene create(nicol_context context) {
        auto scene = nicol_scene{};
        check(nicol_scene_create(context, &scene));
        return Scene(scene);
    }
    [[nodiscard]] static Scene load(nicol_context context, const char* path, std::span<const char* const> definitions = {}) {
        auto scene = nicol_scene{};
        check(nicol_scene_load(context, path, definitions.data(), static_cast<uint32_t>(definitions.size()), &scene));
        return Scene(scene);
    }
    void set_time(double time) const {
        check(nicol_scene_set_time(get(), time));
    }
    [[nodiscard]] static Scene load_memory(nicol_context context, const nicol_memory_file* file, std::span<const char* const> definitions = {}) {
        auto scene = nicol_scene{};
        check(nicol_scene_load_memory(context, file, definitions.data(), static_cast<uint32_t>(definitions.size()), &scene));
        return Scene(scene);
    }
    uint32_t add_instance(const nicol_instance* instance) const {
        auto id = uint32_t{};
        check(nicol_scene_add_instance(get(), instance, &id));
        return id;
    }
    void set_transform(uint32_t id, const double to_world[16]) const {
        check(nicol_scene_set_transform(get(), id, to_world));
    }
    void set_mesh(uint32_t id, nicol_mesh mesh) const {
        check(nicol_scene_set_mesh(get(), id, mesh));
    }
    void set_material(uint32_t id, nicol_material material) const {
        check(nicol_scene_set_material(get(), id, material));
    }
    void set_instance_flags(uint32_t id, uint32_t flags) const {
        check(nicol_scene_set_instance_flags(get(), id, flags));
    }
    [[nodiscard]] uint32_t get_instance_flags(uint32_t id) const {
        auto flags = uint32_t{};
        check(nicol_scene_get_instance_flags(get(), id, &flags));
        return flags;
    }
    void remove_instance(uint32_t id) const {
        check(nicol_scene_remove_instance(get(), id));
    }
    [[nodiscard]] std::tuple<Mesh, Material, std::array<double, 16>> get_instance(uint32_t id) const {
        auto mesh = nicol_mesh{};
        auto material = nicol_material{};
        std::array<double, 16> to_world{};
        check(nicol_scene_get_instance(get(), id, &mesh, &material, to_world.data()));
        return {Mesh(mesh), Material(material), to_world};
    }
    [[nodiscard]] std::tuple<std::array<double, 3>, std::array<double, 3>> get_bounds() const {
        std::array<double, 3> lower{};
        std::array<double, 3> upper{};
        check(nicol_scene_get_bounds(get(), lower.data(), upper.data()));
        return {lower, upper};
    }
    [[nodiscard]] uint32_t get_instance_count() const {
        auto instances = uint32_t{};
        check(nicol_scene_get_instance_count(get(), &instances));
        return instances;
    }
    void get_instance_ids(std::span<uint32_t> ids) const {
        check(nicol_scene_get_instance_ids(get(), ids.data(), ids.size()));
    }
    void set_environment(nicol_environment environment, const double to_world[16], double scale) const {
        check(nicol_scene_set_environment(get(), environment, to_world, scale));
    }
    [[nodiscard]] std::tuple<Environment, std::array<double, 16>, double> get_environment() const {
        auto environment = nicol_environment{};
        std::array<double, 16> to_world{};
        auto scale = double{};
        check(nicol_scene_get_environment(get(), &environment, to_world.data(), &scale));
        return {Environment(environment), to_world, scale};
    }
    void hide_emitters(uint32_t hide) const {
        check(nicol_scene_hide_emitters(get(), hide));
    }
    uint32_t add_light(const nicol_light* light) const {
        auto id = uint32_t{};
        check(nicol_scene_add_light(get(), light, &id));
        return id;
    }
    void set_light(uint32_t id, const nicol_light* light) const {
        check(nicol_scene_set_light(get(), id, light));
    }
    void remove_light(uint32_t id) const {
        check(nicol_scene_remove_light(get(), id));
    }
    [[nodiscard]] std::tuple<nicol_light, Texture> get_light(uint32_t id) const {
        auto light = defaults(nicol_light_init);
        auto texture = nicol_texture{};
        check(nicol_scene_get_light(get(), id, &light, &texture));
        return {light, Texture(texture)};
    }
    [[nodiscard]] uint32_t get_light_count() const {
        auto lights = uint32_t{};
        check(nicol_scene_get_light_count(get(), &lights));
        return lights;
    }
    void get_light_ids(std::span<uint32_t> ids) const {
        check(nicol_scene_get_light_ids(get(), ids.data(), ids.size()));
    }
    void set_emission(uint32_t id, const nicol_emission* emission) const {
        check(nicol_scene_set_emission(get(), id, emission));
    }
    [[nodiscard]] std::tuple<nicol_emission, Texture> get_emission(uint32_t id) const {
        auto emission = defaults(nicol_emission_init);
        auto texture = nicol_texture{};
        check(nicol_scene_get_emission(get(), id, &emission, &texture));
        return {emission, Texture(texture)};
    }
    uint32_t add_polarization_element(const nicol_polarization_element* element) const {
        auto id = uint32_t{};
        check(nicol_scene_add_polarization_element(get(), element, &id));
        return id;
    }
    void set_polarization_element(uint32_t id, const nicol_polarization_element* element) const {
        check(nicol_scene_set_polarization_element(get(), id, element));
    }
    void remove_polarization_element(uint32_t id) const {
        check(nicol_scene_remove_polarization_element(get(), id));
    }
    [[nodiscard]] nicol_polarization_element get_polarization_element(uint32_t id) const {
        auto element = defaults(nicol_polarization_element_init);
        check(nicol_scene_get_polarization_element(get(), id, &element));
        return element;
    }
    [[nodiscard]] std::tuple<Texture, Texture> get_polarization_element_textures(uint32_t id) const {
        auto angle = nicol_texture{};
        auto retardance = nicol_texture{};
        check(nicol_scene_get_polarization_element_textures(get(), id, &angle, &retardance));
        return {Texture(angle), Texture(retardance)};
    }
    [[nodiscard]] uint32_t get_polarization_element_count() const {
        auto elements = uint32_t{};
        check(nicol_scene_get_polarization_element_count(get(), &elements));
        return elements;
    }
    void get_polarization_element_ids(std::span<uint32_t> ids) const {
        check(nicol_scene_get_polarization_element_ids(get(), ids.data(), ids.size()));
    }
    [[nodiscard]] nicol_camera get_camera() const {
        auto camera = defaults(nicol_camera_init);
        check(nicol_scene_get_camera(get(), &camera));
        return camera;
    }
    [[nodiscard]] std::tuple<uint32_t, uint32_t> get_film_size() const {
        auto width = uint32_t{};
        auto height = uint32_t{};
        check(nicol_scene_get_film_size(get(), &width, &height));
        return {width, height};
    }
    [[nodiscard]] uint32_t get_sample_count() const {
        auto samples = uint32_t{};
        check(nicol_scene_get_sample_count(get(), &samples));
        return samples;
    }
    [[nodiscard]] int32_t get_max_depth() const {
        auto max_depth = int32_t{};
        check(nicol_scene_get_max_depth(get(), &max_depth));
        return max_depth;
    }
    [[nodiscard]] uint32_t get_aovs() const {
        auto aovs = uint32_t{};
        check(nicol_scene_get_aovs(get(), &aovs));
        return aovs;
    }
    [[nodiscard]] uint32_t get_file_count() const {
        auto count = uint32_t{};
        check(nicol_scene_get_file_count(get(), &count));
        return count;
    }
    [[nodiscard]] nicol_scene_file get_file(uint32_t index) const {
        auto file = defaults(nicol_scene_file_init);
        check(nicol_scene_get_file(get(), index, &file));
        return file;
    }
    [[nodiscard]] uint32_t get_channels() const {
        auto channels = uint32_t{};
        check(nicol_scene_get_channels(get(), &channels));
        return channels;
    }
    [[nodiscard]] nicol_filter get_filter() const {
        auto filter = defaults(nicol_filter_init);
        check(nicol_scene_get_filter(get(), &filter));
        return filter;
    }
};

class Framebuffer : public Owned<nicol_framebuffer, nicol_framebuffer_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static Framebuffer create(nicol_context context, uint32_t width, uint32_t height, uint32_t channels) {
        auto framebuffer = nicol_framebuffer{};
        check(nicol_framebuffer_create(context, width, height, channels, &framebuffer));
        return Framebuffer(framebuffer);
    }
    void resize(uint32_t width, uint32_t height) const {
        check(nicol_framebuffer_resize(get(), width, height));
    }
    [[nodiscard]] std::tuple<uint32_t, uint32_t, uint32_t> get_size() const {
        auto width = uint32_t{};
        auto height = uint32_t{};
        auto channels = uint32_t{};
        check(nicol_framebuffer_get_size(get(), &width, &height, &channels));
        return {width, height, channels};
    }
    void blend(nicol_framebuffer other, double weight) const {
        check(nicol_framebuffer_blend(get(), other, weight));
    }
    [[nodiscard]] nicol_statistics get_statistics() const {
        auto statistics = defaults(nicol_statistics_init);
        check(nicol_framebuffer_get_statistics(get(), &statistics));
        return statistics;
    }
    void read(nicol_plane plane, uint32_t channel, float* pixels, uint64_t row_stride, uint64_t byte_size) const {
        check(nicol_framebuffer_read(get(), plane, channel, pixels, row_stride, byte_size));
    }
    void read_plane(const nicol_plane_buffer* to) const {
        check(nicol_framebuffer_read_plane(get(), to));
    }
    void write_exr(const char* path) const {
        check(nicol_framebuffer_write_exr(get(), path));
    }
    void encode_exr(nicol_sink_callback sink, void* user) const {
        check(nicol_framebuffer_encode_exr(get(), sink, user));
    }
    void write_png(const nicol_observation* observation, const char* path) const {
        check(nicol_framebuffer_write_png(get(), observation, path));
    }
    void encode_png(const nicol_observation* observation, nicol_sink_callback sink, void* user) const {
        check(nicol_framebuffer_encode_png(get(), observation, sink, user));
    }
    void expose(const nicol_sensor* sensor, uint64_t frame, const nicol_raw_image* to) const {
        check(nicol_framebuffer_expose(get(), sensor, frame, to));
    }
    [[nodiscard]] static Framebuffer create_textures(nicol_context context, std::span<const uint32_t> textures) {
        auto framebuffer = nicol_framebuffer{};
        check(nicol_framebuffer_create_textures(context, textures.data(), static_cast<uint32_t>(textures.size()), &framebuffer));
        return Framebuffer(framebuffer);
    }
    [[nodiscard]] nicol_gl_texture get_texture(uint32_t channel) const {
        auto texture = defaults(nicol_gl_texture_init);
        check(nicol_framebuffer_get_texture(get(), channel, &texture));
        return texture;
    }
    void draw_plane(nicol_plane plane, uint32_t channel, const nicol_texture_target* target) const {
        check(nicol_framebuffer_draw_plane(get(), plane, channel, target));
    }
    void draw_stokes(uint32_t channel, const nicol_texture_target* target) const {
        check(nicol_framebuffer_draw_stokes(get(), channel, target));
    }
    void draw_observation(const nicol_observation* observation, const nicol_texture_target* target) const {
        check(nicol_framebuffer_draw_observation(get(), observation, target));
    }
};

class Job : public Owned<nicol_job, nicol_job_release> {
public:
    using Owned::Owned;
    nicol_job_status poll() const {
        auto status = defaults(nicol_job_status_init);
        check(nicol_job_poll(get(), &status));
        return status;
    }
    void wait(uint32_t timeout_ms) const {
        check(nicol_job_wait(get(), timeout_ms));
    }
    void cancel() const {
        check(nicol_job_cancel(get()));
    }
};

class PshTransform : public Owned<nicol_psh_transform, nicol_psh_transform_release> {
public:
    using Owned::Owned;
    [[nodiscard]] static PshTransform create(const nicol_psh_sampling* sampling) {
        auto transform = nicol_psh_transform{};
        check(nicol_psh_transform_create(sampling, &transform));
        return PshTransform(transform);
    }
    [[nodiscard]] std::tuple<uint32_t, uint32_t> get_size() const {
        auto rows = uint32_t{};
        auto columns = uint32_t{};
        check(nicol_psh_transform_get_size(get(), &rows, &columns));
        return {rows, columns};
    }
    void get_rows(double* theta, double* weight, uint64_t count) const {
        check(nicol_psh_transform_get_rows(get(), theta, weight, count));
    }
};

inline uint32_t device_count() {
    auto count = uint32_t{};
    check(nicol_device_count(&count));
    return count;
}

inline nicol_device_info device_get_info(uint32_t device) {
    auto info = defaults(nicol_device_info_init);
    check(nicol_device_get_info(device, &info));
    return info;
}

inline void camera_look_at(nicol_camera* camera, const double origin[3], const double target[3], const double up[3]) {
    check(nicol_camera_look_at(camera, origin, target, up));
}

inline void camera_set_opencv(nicol_camera* camera, const double K[9], const double R[9], const double t[3], uint32_t width, uint32_t height) {
    check(nicol_camera_set_opencv(camera, K, R, t, width, height));
}

inline std::tuple<std::array<double, 9>, std::array<double, 9>, std::array<double, 3>> camera_get_opencv(const nicol_camera* camera, uint32_t width, uint32_t height) {
    std::array<double, 9> K{};
    std::array<double, 9> R{};
    std::array<double, 3> t{};
    check(nicol_camera_get_opencv(camera, width, height, K.data(), R.data(), t.data()));
    return {K, R, t};
}

inline void camera_frame(nicol_camera* camera, const double lower[3], const double upper[3], uint32_t width, uint32_t height) {
    check(nicol_camera_frame(camera, lower, upper, width, height));
}

inline nicol_light sky_get_sun(const nicol_sky* sky) {
    auto light = defaults(nicol_light_init);
    check(nicol_sky_get_sun(sky, &light));
    return light;
}

inline void render_options_set_quality(nicol_render_options* options, nicol_quality quality) {
    check(nicol_render_options_set_quality(options, quality));
}

inline void render(nicol_scene scene, const nicol_camera* camera, const nicol_render_options* options, nicol_framebuffer framebuffer) {
    check(nicol_render(scene, camera, options, framebuffer));
}

inline void render_views(nicol_scene scene, const nicol_camera* cameras, const nicol_framebuffer* framebuffers, uint32_t count, const nicol_render_options* options = nullptr) {
    check(nicol_render_views(scene, cameras, framebuffers, count, options));
}

[[nodiscard]] inline Job render_async(nicol_scene scene, const nicol_camera* camera, const nicol_render_options* options, nicol_framebuffer framebuffer) {
    auto job = nicol_job{};
    check(nicol_render_async(scene, camera, options, framebuffer, &job));
    return Job(job);
}

inline void sensor_set_preset(nicol_sensor* sensor, nicol_sensor_preset preset) {
    check(nicol_sensor_set_preset(sensor, preset));
}

inline void sensor_load(nicol_sensor* sensor, const char* path) {
    check(nicol_sensor_load(sensor, path));
}

inline void sensor_load_memory(nicol_sensor* sensor, const nicol_memory_file* file) {
    check(nicol_sensor_load_memory(sensor, file));
}

inline void sensor_add_element(nicol_sensor* sensor, const nicol_polarization_element* element, double extinction_ratio) {
    check(nicol_sensor_add_element(sensor, element, extinction_ratio));
}

inline void sensor_expose(const nicol_sensor* sensor, const nicol_stokes_image* light, uint64_t frame, const nicol_raw_image* to) {
    check(nicol_sensor_expose(sensor, light, frame, to));
}

inline void sensor_write_png(const nicol_sensor* sensor, const nicol_raw_image* raw, const char* path) {
    check(nicol_sensor_write_png(sensor, raw, path));
}

inline void sensor_demosaic(const nicol_sensor* sensor, const nicol_raw_image* raw, nicol_demosaic method, const nicol_stokes_image* to) {
    check(nicol_sensor_demosaic(sensor, raw, method, to));
}

inline void render_adjoint(nicol_scene scene, const nicol_camera* camera, const nicol_render_options* options, const nicol_stokes_image* picture, const nicol_gradient* gradient) {
    check(nicol_render_adjoint(scene, camera, options, picture, gradient));
}

inline void psh_project_image(const nicol_image* image, uint32_t order, std::span<double> coefficients) {
    check(nicol_psh_project_image(image, order, coefficients.data(), coefficients.size()));
}

inline void psh_project_environment(nicol_environment environment, uint32_t order, std::span<double> coefficients) {
    check(nicol_psh_project_environment(environment, order, coefficients.data(), coefficients.size()));
}

inline uint32_t psh_project_file(const char* path, uint32_t order, std::span<double> coefficients) {
    auto channels = uint32_t{};
    check(nicol_psh_project_file(path, order, &channels, coefficients.data(), coefficients.size()));
    return channels;
}

inline void psh_analyze(nicol_psh_transform transform, uint64_t vectors, std::span<const double> samples, std::span<double> coefficients) {
    check(nicol_psh_analyze(transform, vectors, samples.data(), samples.size(), coefficients.data(), coefficients.size()));
}

inline void psh_synthesize(nicol_psh_transform transform, uint64_t vectors, std::span<const double> coefficients, std::span<double> samples) {
    check(nicol_psh_synthesize(transform, vectors, coefficients.data(), coefficients.size(), samples.data(), samples.size()));
}

inline void psh_evaluate(uint32_t order, uint64_t vectors, std::span<const double> coefficients, std::span<const double> directions, std::span<double> stokes) {
    check(nicol_psh_evaluate(order, vectors, coefficients.data(), coefficients.size(), directions.data(), directions.size(), stokes.data(), stokes.size()));
}

inline void psh_rotate(uint32_t order, uint64_t vectors, std::span<const double> in, const double rotation[9], std::span<double> out) {
    check(nicol_psh_rotate(order, vectors, in.data(), in.size(), rotation, out.data(), out.size()));
}

inline void psh_reflect(uint32_t order, uint64_t vectors, std::span<const double> in, std::span<double> out) {
    check(nicol_psh_reflect(order, vectors, in.data(), in.size(), out.data(), out.size()));
}

inline void psh_multiply(uint32_t scalar_order, std::span<const double> scalar, uint32_t order, uint64_t vectors, std::span<const double> in, uint32_t order_out, std::span<double> out) {
    check(nicol_psh_multiply(scalar_order, scalar.data(), scalar.size(), order, vectors, in.data(), in.size(), order_out, out.data(), out.size()));
}

inline void psh_shadow_matrix(uint32_t scalar_order, std::span<const double> scalar, uint32_t order_out, uint32_t order_in, std::span<double> matrix) {
    check(nicol_psh_shadow_matrix(scalar_order, scalar.data(), scalar.size(), order_out, order_in, matrix.data(), matrix.size()));
}

inline void psh_project_matrix(const nicol_psh_mueller_field* field, std::span<double> matrix) {
    check(nicol_psh_project_matrix(field, matrix.data(), matrix.size()));
}

inline void psh_apply_matrix(uint32_t order_out, uint32_t order_in, std::span<const double> matrix, uint64_t vectors, std::span<const double> in, std::span<double> out) {
    check(nicol_psh_apply_matrix(order_out, order_in, matrix.data(), matrix.size(), vectors, in.data(), in.size(), out.data(), out.size()));
}

inline void psh_compose_matrix(uint32_t order_out, uint32_t order_between, uint32_t order_in, std::span<const double> second, std::span<const double> first, std::span<double> matrix) {
    check(nicol_psh_compose_matrix(order_out, order_between, order_in, second.data(), second.size(), first.data(), first.size(), matrix.data(), matrix.size()));
}

inline void psh_project_kernel(nicol_psh_kernel_callback callback, void* user, uint32_t order, uint32_t rows, std::span<double> bands) {
    check(nicol_psh_project_kernel(callback, user, order, rows, bands.data(), bands.size()));
}

inline void psh_kernel_at(uint32_t order, std::span<const double> bands, std::span<const double> theta, std::span<double> mueller) {
    check(nicol_psh_kernel_at(order, bands.data(), bands.size(), theta.data(), theta.size(), mueller.data(), mueller.size()));
}

inline void psh_convolve(uint32_t order, std::span<const double> bands, uint64_t vectors, std::span<const double> in, std::span<double> out) {
    check(nicol_psh_convolve(order, bands.data(), bands.size(), vectors, in.data(), in.size(), out.data(), out.size()));
}

inline void psh_kernel_matrix(uint32_t order, std::span<const double> bands, std::span<double> matrix) {
    check(nicol_psh_kernel_matrix(order, bands.data(), bands.size(), matrix.data(), matrix.size()));
}

inline void psh_nearest_kernel(uint32_t order, std::span<const double> matrix, std::span<double> bands) {
    check(nicol_psh_nearest_kernel(order, matrix.data(), matrix.size(), bands.data(), bands.size()));
}

inline nicol_file_kind file_identify(const char* path) {
    auto kind = nicol_file_kind{};
    check(nicol_file_identify(path, &kind));
    return kind;
}

inline nicol_light_report file_describe_light(const char* path, const nicol_file_options* options, std::span<double> energy) {
    auto report = defaults(nicol_light_report_init);
    check(nicol_file_describe_light(path, options, &report, energy.data(), energy.size()));
    return report;
}

inline nicol_material_report file_describe_material(const char* path, const nicol_file_options* options, std::span<double> energy) {
    auto report = defaults(nicol_material_report_init);
    check(nicol_file_describe_material(path, options, &report, energy.data(), energy.size()));
    return report;
}

inline void file_convert(const char* in, const nicol_file_options* options, const char* out) {
    check(nicol_file_convert(in, options, out));
}

inline void file_demosaic(const char* in, const nicol_sensor* sensor, nicol_demosaic method, const char* out) {
    check(nicol_file_demosaic(in, sensor, method, out));
}

inline void file_combine_angles(const char* at_0, const char* at_45, const char* at_90, const char* at_135, const char* out) {
    check(nicol_file_combine_angles(at_0, at_45, at_90, at_135, out));
}

inline void psh_write_file(const char* path, uint32_t order, uint64_t vectors, std::span<const double> coefficients) {
    check(nicol_psh_write_file(path, order, vectors, coefficients.data(), coefficients.size()));
}

}  // namespace nicol
// clang-format on

#endif
