// SPDX-License-Identifier: MIT
#include "entry_points.hpp"

#include <nicol_files.h>

#include <array>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

using nicol::defaults;
using nicol::Job;
using nicol::Texture;

// A function and its name. NOLINTNEXTLINE(bugprone-macro-parentheses): these are names
#define NAMED(function) #function, function

struct EntryPoints::Objects {
    nicol_context context;
    std::filesystem::path folder;
    Texture texture = create<Texture>(nicol_texture_create_checkerboard, context, nullptr, nullptr, nullptr);
    Mesh mesh = create<Mesh>(nicol_mesh_create_sphere, context);
    Material material = create<Material>(nicol_material_create_diffuse, context, nullptr);
    Environment light = create<Environment>(nicol_environment_create_constant, context, nullptr);
    Scene scene = create<Scene>(nicol_scene_create, context);
    Scene loaded;
    Framebuffer framebuffer = create<Framebuffer>(nicol_framebuffer_create, context, size(), size(), 1U);
    std::uint32_t instance = 0;
    nicol_camera camera = defaults(nicol_camera_init);

    Objects(nicol_context given, std::filesystem::path files) : context(given), folder(std::move(files)) {
        auto placed = defaults(nicol_instance_init);
        placed.mesh = mesh.get();
        placed.material = material.get();
        check(nicol_scene_add_instance(scene.get(), &placed, &instance));
        check(nicol_scene_set_environment(scene.get(), light.get(), nullptr, 1));
        const double eye[] = {0, 0, 4}, middle[] = {0, 0, 0}, up[] = {0, 1, 0};
        check(nicol_camera_look_at(&camera, eye, middle, up));
        loaded = create<Scene>(nicol_scene_load, context, NICOL_BENCH_ASSETS "/solids.gltf", nullptr, 0U);
    }
    [[nodiscard]] std::string file(const char* name) const { return (folder / name).string(); }
};

namespace {

template <class... Parameters, class... Arguments>
void call(const EntryPoints::Watch& watch, const char* name, nicol_result (*function)(Parameters...),
          Arguments... arguments) {
    watch(name, [&] { check(function(arguments...)); });
}

template <class Object, class... Parameters, class... Arguments>
Object make(const EntryPoints::Watch& watch, const char* name, nicol_result (*function)(Parameters...),
            Arguments... arguments) {
    typename Object::pointer handle = nullptr;
    call(watch, name, function, arguments..., &handle);
    return Object(handle);
}

// Retains and releases an object.
template <class Handle>
void keep(const EntryPoints::Watch& watch, const char* retain_name, nicol_result (*retain)(Handle),
          const char* release_name, nicol_result (*release)(Handle), Handle handle) {
    call(watch, retain_name, retain, handle);
    call(watch, release_name, release, handle);
}

/// A file of the assets in memory.
struct MemoryFile {
    std::string bytes;
    nicol_memory_file file = defaults(nicol_memory_file_init);

    explicit MemoryFile(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
        file.bytes = bytes.data();
        file.byte_size = bytes.size();
    }
};

void make_textures(const EntryPoints::Watch& watch, nicol_context context, nicol_texture texture) {
    constexpr std::array<std::uint8_t, 4> texels{0, 85, 170, 255};
    auto image = defaults(nicol_texture_image_init);
    image.pixels = texels.data();
    image.byte_size = texels.size();
    image.width = image.height = 2;
    image.channels = 1;
    image.type = NICOL_TEXEL_UINT8;
    make<Texture>(watch, NAMED(nicol_texture_create_image), context, &image, nullptr);
    make<Texture>(watch, NAMED(nicol_texture_load), context, NICOL_BENCH_ASSETS "/bands_color.png", nullptr);
    const MemoryFile png(NICOL_BENCH_ASSETS "/bands_color.png");
    make<Texture>(watch, NAMED(nicol_texture_load_memory), context, &png.file, nullptr);
    make<Texture>(watch, NAMED(nicol_texture_create_checkerboard), context, nullptr, nullptr, nullptr);
    make<Texture>(watch, NAMED(nicol_texture_create_vertex_colors), context);
    make<Texture>(watch, NAMED(nicol_texture_create_face_colors), context);
    keep(watch, NAMED(nicol_texture_retain), NAMED(nicol_texture_release), texture);
}

void make_meshes(const EntryPoints::Watch& watch, nicol_context context, nicol_mesh mesh) {
    constexpr float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    constexpr std::uint32_t indices[] = {0, 1, 2};
    auto data = defaults(nicol_mesh_data_init);
    data.positions = positions;
    data.indices = indices;
    data.vertex_count = 3;
    data.triangle_count = 1;
    make<Mesh>(watch, NAMED(nicol_mesh_create), context, &data);
    const auto base = create<Mesh>(nicol_mesh_create, context, &data);
    auto deformation = defaults(nicol_deformation_init);
    deformation.vertex_count = 3;
    deformation.positions = positions;
    make<Mesh>(watch, NAMED(nicol_mesh_create_deformed), context, base.get(), &deformation);
    make<Mesh>(watch, NAMED(nicol_mesh_load), context, NICOL_BENCH_ASSETS "/plinth.ply");
    const MemoryFile ply(NICOL_BENCH_ASSETS "/plinth.ply");
    make<Mesh>(watch, NAMED(nicol_mesh_load_memory), context, &ply.file);
    make<Mesh>(watch, NAMED(nicol_mesh_create_sphere), context);
    make<Mesh>(watch, NAMED(nicol_mesh_create_divided_sphere), context, 4U);
    make<Mesh>(watch, NAMED(nicol_mesh_create_rectangle), context);
    make<Mesh>(watch, NAMED(nicol_mesh_create_cube), context);
    make<Mesh>(watch, NAMED(nicol_mesh_create_disk), context);
    const double from[] = {0, 0, 0}, to[] = {0, 0, 1};
    make<Mesh>(watch, NAMED(nicol_mesh_create_cylinder), context, from, to, 0.5);
    std::uint32_t vertices = 0, triangles = 0;
    call(watch, NAMED(nicol_mesh_get_size), mesh, &vertices, &triangles);
    std::array<double, 3> lower{}, upper{};
    call(watch, NAMED(nicol_mesh_get_bounds), mesh, lower.data(), upper.data());
    keep(watch, NAMED(nicol_mesh_retain), NAMED(nicol_mesh_release), mesh);
}

void make_environments(const EntryPoints::Watch& watch, nicol_context context, nicol_environment light,
                       const std::string& file) {
    const auto sky = defaults(nicol_sky_init);
    make<Environment>(watch, NAMED(nicol_environment_create_constant), context, nullptr);
    make<Environment>(watch, NAMED(nicol_environment_create_sky), context, &sky);
    constexpr std::array<double, 4> coefficients{1, 0, 0, 0};
    make<Environment>(watch, NAMED(nicol_environment_create_psh), context, 0U, 1U, coefficients.data(),
                      coefficients.size());
    constexpr std::array<float, 8 * 4> pixels{};
    auto image = defaults(nicol_image_init);
    image.pixels = pixels.data();
    image.byte_size = sizeof pixels;
    image.components = 1;
    image.width = 8;
    image.height = 4;
    image.channels = 1;
    make<Environment>(watch, NAMED(nicol_environment_create_image), context, &image);
    make<Environment>(watch, NAMED(nicol_environment_load), context, NICOL_BENCH_ASSETS "/forest_blurred.exr",
                      nullptr);
    const MemoryFile exr(NICOL_BENCH_ASSETS "/forest_blurred.exr");
    make<Environment>(watch, NAMED(nicol_environment_load_memory), context, &exr.file, nullptr);
    auto info = defaults(nicol_environment_info_init);
    call(watch, NAMED(nicol_environment_get_info), light, &info);
    call(watch, NAMED(nicol_environment_write), light, nullptr, file.c_str());
    keep(watch, NAMED(nicol_environment_retain), NAMED(nicol_environment_release), light);
}

nicol_callback_material grey() {
    auto parameters = defaults(nicol_callback_material_init);
    parameters.mueller = [](void*, std::uint32_t, const double*, const double*, double* mueller) {
        std::fill_n(mueller, 16, 0.0);
        mueller[0] = 0.1;
        return std::int32_t{1};
    };
    return parameters;
}

void make_materials(const EntryPoints::Watch& watch, nicol_context context, nicol_material base,
                    nicol_texture texture, nicol_texture colours, const std::string& file) {
    const auto pplastic = defaults(nicol_pplastic_init);
    const auto plastic = defaults(nicol_plastic_init);
    const auto principled = defaults(nicol_principled_init);
    const auto conductor = defaults(nicol_conductor_init);
    const auto glass = defaults(nicol_dielectric_init);
    const auto function = grey();
    make<Material>(watch, NAMED(nicol_material_create_pplastic), context, &pplastic);
    make<Material>(watch, NAMED(nicol_material_create_plastic), context, &plastic);
    make<Material>(watch, NAMED(nicol_material_create_principled), context, &principled);
    make<Material>(watch, NAMED(nicol_material_create_diffuse), context, nullptr);
    make<Material>(watch, NAMED(nicol_material_create_conductor), context, &conductor);
    make<Material>(watch, NAMED(nicol_material_create_dielectric), context, &glass);
    make<Material>(watch, NAMED(nicol_material_create_callback), context, &function);
    make<Material>(watch, NAMED(nicol_material_create_twosided), context, base);
    make<Material>(watch, NAMED(nicol_material_create_scaled), context, base, texture);
    make<Material>(watch, NAMED(nicol_material_create_blend), context, base, base, texture);
    make<Material>(watch, NAMED(nicol_material_create_normal_map), context, base, colours, 0U);
    make<Material>(watch, NAMED(nicol_material_create_bump_map), context, base, texture, 0.1);
    make<Material>(watch, NAMED(nicol_material_create_rotated), context, base, nullptr, 30.0);
    make<Material>(watch, NAMED(nicol_material_create_mask), context, base, texture);
    call(watch, NAMED(nicol_material_write), base, nullptr, file.c_str());
    make<Material>(watch, NAMED(nicol_material_load_psh), context, file.c_str(), nullptr);
    const MemoryFile npz(file);
    make<Material>(watch, NAMED(nicol_material_load_psh_memory), context, &npz.file, nullptr);
    keep(watch, NAMED(nicol_material_retain), NAMED(nicol_material_release), base);
}

void edit_instances(const EntryPoints::Watch& watch, nicol_scene scene, std::uint32_t id, nicol_mesh mesh,
                    nicol_material material) {
    auto placed = defaults(nicol_instance_init);
    placed.mesh = mesh;
    placed.material = material;
    std::uint32_t added = 0, count = 0;
    std::array<std::uint32_t, 2> ids{};
    call(watch, NAMED(nicol_scene_add_instance), scene, &placed, &added);
    call(watch, NAMED(nicol_scene_get_instance_count), scene, &count);
    std::array<double, 3> lower{}, upper{};
    call(watch, NAMED(nicol_scene_get_bounds), scene, lower.data(), upper.data());
    call(watch, NAMED(nicol_scene_get_instance_ids), scene, ids.data(), std::uint64_t{2});
    call(watch, NAMED(nicol_scene_remove_instance), scene, added);
    call(watch, NAMED(nicol_scene_set_transform), scene, id, placed.to_world);
    call(watch, NAMED(nicol_scene_set_mesh), scene, id, mesh);
    call(watch, NAMED(nicol_scene_set_material), scene, id, material);
    std::uint32_t flags = 0;
    call(watch, NAMED(nicol_scene_set_instance_flags), scene, id, NICOL_INSTANCE_INVISIBLE);
    call(watch, NAMED(nicol_scene_get_instance_flags), scene, id, &flags);
    call(watch, NAMED(nicol_scene_get_instance), scene, id, nullptr, nullptr, placed.to_world);
    auto emission = defaults(nicol_emission_init);
    call(watch, NAMED(nicol_scene_set_emission), scene, id, &emission);
    call(watch, NAMED(nicol_scene_get_emission), scene, id, &emission, nullptr);
    check(nicol_scene_set_emission(scene, id, nullptr));
}

void edit_lights(const EntryPoints::Watch& watch, nicol_scene scene, nicol_environment environment) {
    auto light = defaults(nicol_light_init);
    std::uint32_t id = 0, count = 0;
    call(watch, NAMED(nicol_scene_add_light), scene, &light, &id);
    call(watch, NAMED(nicol_scene_set_light), scene, id, &light);
    call(watch, NAMED(nicol_scene_get_light), scene, id, &light, nullptr);
    call(watch, NAMED(nicol_scene_get_light_count), scene, &count);
    call(watch, NAMED(nicol_scene_get_light_ids), scene, &id, std::uint64_t{1});
    call(watch, NAMED(nicol_scene_remove_light), scene, id);
    call(watch, NAMED(nicol_scene_set_environment), scene, environment, nullptr, 1.0);
    call(watch, NAMED(nicol_scene_hide_emitters), scene, 0U);
    double scale = 0;
    make<Environment>(
        watch, "nicol_scene_get_environment",
        +[](nicol_scene from, double* factor, nicol_environment* got) {
            return nicol_scene_get_environment(from, got, nullptr, factor);
        },
        scene, &scale);
}

void edit_elements(const EntryPoints::Watch& watch, nicol_scene scene) {
    auto element = defaults(nicol_polarization_element_init);
    std::uint32_t id = 0, count = 0;
    call(watch, NAMED(nicol_scene_add_polarization_element), scene, &element, &id);
    call(watch, NAMED(nicol_scene_set_polarization_element), scene, id, &element);
    call(watch, NAMED(nicol_scene_get_polarization_element), scene, id, &element);
    call(watch, NAMED(nicol_scene_get_polarization_element_textures), scene, id, nullptr, nullptr);
    call(watch, NAMED(nicol_scene_get_polarization_element_count), scene, &count);
    call(watch, NAMED(nicol_scene_get_polarization_element_ids), scene, &id, std::uint64_t{1});
    call(watch, NAMED(nicol_scene_remove_polarization_element), scene, id);
}

void ask_scene(const EntryPoints::Watch& watch, nicol_scene loaded) {
    std::uint32_t number = 0, other = 0;
    std::int32_t depth = 0;
    nicol_filter filter = NICOL_FILTER_INIT;
    auto camera = defaults(nicol_camera_init);
    auto file = defaults(nicol_scene_file_init);
    call(watch, NAMED(nicol_scene_get_camera), loaded, &camera);
    watch("nicol_scene_set_time", [&] {
        const nicol_result result = nicol_scene_set_time(loaded, 1);
        if (result != NICOL_ERROR_UNSUPPORTED) check(result);  // the file has no animation
    });
    call(watch, NAMED(nicol_scene_get_film_size), loaded, &number, &other);
    call(watch, NAMED(nicol_scene_get_sample_count), loaded, &number);
    call(watch, NAMED(nicol_scene_get_filter), loaded, &filter);
    call(watch, NAMED(nicol_scene_get_max_depth), loaded, &depth);
    call(watch, NAMED(nicol_scene_get_aovs), loaded, &number);
    call(watch, NAMED(nicol_scene_get_file_count), loaded, &number);
    call(watch, NAMED(nicol_scene_get_file), loaded, 0U, &file);
    call(watch, NAMED(nicol_scene_get_channels), loaded, &number);
    keep(watch, NAMED(nicol_scene_retain), NAMED(nicol_scene_release), loaded);
}

// Computes a gradient by instances.
void find_gradient(const EntryPoints::Watch& watch, nicol_scene scene, const nicol_camera& camera) {
    constexpr std::uint32_t side = 8;
    std::uint32_t channels = 0, instances = 0;
    check(nicol_scene_get_channels(scene, &channels));
    check(nicol_scene_get_instance_count(scene, &instances));
    std::vector<float> pixels(std::size_t{side} * side * channels * 4, 1.0F);
    auto picture = defaults(nicol_stokes_image_init);
    picture.width = picture.height = side;
    picture.channels = channels;
    picture.pixels = pixels.data();
    picture.byte_size = pixels.size() * sizeof(float);
    std::vector<double> of_instances(std::size_t{instances} * channels);
    auto gradient = defaults(nicol_gradient_init);
    gradient.instances = of_instances.data();
    gradient.instances_count = of_instances.size();
    auto options = defaults(nicol_render_options_init);
    options.physical = 0;
    options.order_low = options.order_high = 3;
    options.shade_at = NICOL_SHADE_AT_PIXELS;
    call(watch, NAMED(nicol_render_adjoint), scene, &camera, &options, &picture, &gradient);
}

}  // namespace

EntryPoints::EntryPoints(nicol_context context, std::filesystem::path folder)
    : objects_(std::make_unique<Objects>(context, std::move(folder))) {}
EntryPoints::~EntryPoints() = default;

void EntryPoints::all(const Watch& watch, std::uint32_t texture) {
    assets(watch);
    images(watch);
    jobs(watch);
    if (texture != 0) host(watch, texture);
}

void EntryPoints::assets(const Watch& watch) {
    const Objects& o = *objects_;
    auto info = defaults(nicol_context_info_init);
    call(watch, NAMED(nicol_context_get_info), o.context, &info);
    call(watch, NAMED(nicol_context_set_log), o.context, nullptr, nullptr);
    keep(watch, NAMED(nicol_context_retain), NAMED(nicol_context_release), o.context);
    make_textures(watch, o.context, o.texture.get());
    make_meshes(watch, o.context, o.mesh.get());
    make_environments(watch, o.context, o.light.get(), o.file("light.npz"));
    const auto colours =
        create<Texture>(nicol_texture_load, o.context, NICOL_BENCH_ASSETS "/tiles_normals.png", nullptr);
    make_materials(watch, o.context, o.material.get(), o.texture.get(), colours.get(),
                   o.file("material.npz"));
}

void EntryPoints::images(const Watch& watch) {
    Objects& o = *objects_;
    make<Scene>(watch, NAMED(nicol_scene_create), o.context);
    make<Scene>(watch, NAMED(nicol_scene_load), o.context, NICOL_BENCH_ASSETS "/solids.gltf", nullptr, 0U);
    const MemoryFile gltf(NICOL_BENCH_ASSETS "/solids.gltf");
    make<Scene>(watch, NAMED(nicol_scene_load_memory), o.context, &gltf.file, nullptr, 0U);
    edit_instances(watch, o.scene.get(), o.instance, o.mesh.get(), o.material.get());
    edit_lights(watch, o.scene.get(), o.light.get());
    edit_elements(watch, o.scene.get());
    ask_scene(watch, o.loaded.get());
    make<Framebuffer>(watch, NAMED(nicol_framebuffer_create), o.context, size(), size(), 3U);
    keep(watch, NAMED(nicol_framebuffer_retain), NAMED(nicol_framebuffer_release), o.framebuffer.get());
    const auto other = create<Framebuffer>(nicol_framebuffer_create, o.context, size(), size(), 1U);
    call(watch, NAMED(nicol_framebuffer_blend), o.framebuffer.get(), other.get(), 0.5);
    call(watch, NAMED(nicol_framebuffer_resize), o.framebuffer.get(), size(), size() + 1);
    check(nicol_framebuffer_resize(o.framebuffer.get(), size(), size()));
    o.camera.shift[0] += 0.001;
    call(watch, NAMED(nicol_render), o.scene.get(), &o.camera, nullptr, o.framebuffer.get());
    o.camera.shift[0] += 0.001;
    const nicol_framebuffer framebuffers[] = {o.framebuffer.get()};
    call(watch, NAMED(nicol_render_views), o.scene.get(), &o.camera, framebuffers, 1U, nullptr);
    find_gradient(watch, o.scene.get(), o.camera);
    reads(watch, o.framebuffer.get());
}

void EntryPoints::reads(const Watch& watch, nicol_framebuffer framebuffer) {
    const Objects& o = *objects_;
    std::uint32_t width = 0, height = 0, channels = 0;
    call(watch, NAMED(nicol_framebuffer_get_size), framebuffer, &width, &height, &channels);
    auto statistics = defaults(nicol_statistics_init);
    call(watch, NAMED(nicol_framebuffer_get_statistics), framebuffer, &statistics);
    std::vector<float> pixels(std::size_t{width} * height);
    call(watch, NAMED(nicol_framebuffer_read), framebuffer, NICOL_PLANE_S0, 0U, pixels.data(),
         std::uint64_t{0}, pixels.size() * sizeof(float));
    auto plane = defaults(nicol_plane_buffer_init);
    plane.plane = NICOL_PLANE_DOLP;
    plane.pixels = pixels.data();
    plane.byte_size = pixels.size() * sizeof(float);
    call(watch, NAMED(nicol_framebuffer_read_plane), framebuffer, &plane);
    std::vector<std::uint16_t> numbers(std::size_t{width} * height);
    const auto sensor = defaults(nicol_sensor_init);
    auto raw = defaults(nicol_raw_image_init);
    raw.width = width;
    raw.height = height;
    raw.pixels = numbers.data();
    raw.byte_size = numbers.size() * sizeof(std::uint16_t);
    call(watch, NAMED(nicol_framebuffer_expose), framebuffer, &sensor, std::uint64_t{0}, &raw);
    const auto shown = defaults(nicol_observation_init);
    call(watch, NAMED(nicol_framebuffer_write_exr), framebuffer, o.file("image.exr").c_str());
    call(watch, NAMED(nicol_framebuffer_write_png), framebuffer, &shown, o.file("image.png").c_str());
    const nicol_sink_callback sink = [](void*, const void*, std::uint64_t) { return std::int32_t{1}; };
    call(watch, NAMED(nicol_framebuffer_encode_exr), framebuffer, sink, nullptr);
    call(watch, NAMED(nicol_framebuffer_encode_png), framebuffer, &shown, sink, nullptr);
}

void EntryPoints::jobs(const Watch& watch) {
    const Objects& o = *objects_;
    auto options = defaults(nicol_render_options_init);
    const auto job =
        make<Job>(watch, NAMED(nicol_render_async), o.scene.get(), &o.camera, &options, o.framebuffer.get());
    auto status = defaults(nicol_job_status_init);
    call(watch, NAMED(nicol_job_poll), job.get(), &status);
    watch("nicol_job_wait", [&] {
        const nicol_result result = nicol_job_wait(job.get(), 0);
        if (result != NICOL_ERROR_TIMEOUT) check(result);
    });
    keep(watch, NAMED(nicol_job_retain), NAMED(nicol_job_release), job.get());
    call(watch, NAMED(nicol_job_cancel), job.get());
    nicol_job_wait(job.get(), NICOL_WAIT_FOREVER);
}

void EntryPoints::host(const Watch& watch, std::uint32_t texture) {
    const Objects& o = *objects_;
    auto image = defaults(nicol_gl_texture_init);
    call(watch, NAMED(nicol_framebuffer_get_texture), o.framebuffer.get(), 0U, &image);
    auto target = defaults(nicol_texture_target_init);
    target.texture = texture;
    call(watch, NAMED(nicol_framebuffer_draw_stokes), o.framebuffer.get(), 0U, &target);
    call(watch, NAMED(nicol_framebuffer_draw_plane), o.framebuffer.get(), nicol_plane{NICOL_PLANE_DOLP}, 0U,
         &target);
    make<Framebuffer>(watch, NAMED(nicol_framebuffer_create_textures), o.context, &texture, 1U);
    const auto shown = defaults(nicol_observation_init);
    call(watch, NAMED(nicol_framebuffer_draw_observation), o.framebuffer.get(), &shown, &target);
}
