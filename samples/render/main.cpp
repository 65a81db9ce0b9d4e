// SPDX-License-Identifier: MIT
// nicol-render: a program that renders a scene file to a Stokes image, using only the C ABI.
#include <nicol.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "common/failure.hpp"
#include "common/handles.hpp"
#include "common/user_cache.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "stats.hpp"

namespace {

void log(void* user, std::uint32_t severity, nicol_result, const char* message) {
    if (severity < NICOL_LOG_NOTICE) return;
    static_cast<ProgressBar*>(user)->clear();
    std::fprintf(stderr, "nicol-render: %s: %s\n", severity >= NICOL_LOG_WARNING ? "warning" : "notice",
                 message);
}

Context make_context(const Options& options, ProgressBar& progress) {
    nicol_context_options wanted = options.load_limits;
    wanted.backend = options.backend;
    wanted.device = options.device;
    wanted.log = log;
    wanted.log_user = &progress;
    const std::string cache = options.cache.empty() ? user_cache_folder() : options.cache;
    wanted.cache_folder = cache.c_str();
    nicol_context context = nullptr;
    check(nicol_context_create(&wanted, &context));
    return Context(context);
}

Scene load_scene(nicol_context context, const Options& options) {
    std::vector<const char*> definitions;
    for (const std::string& definition : options.definitions) definitions.push_back(definition.c_str());
    nicol_scene scene = nullptr;
    check(nicol_scene_load(context, options.scene.c_str(), definitions.data(),
                           static_cast<std::uint32_t>(definitions.size()), &scene));
    return Scene(scene);
}

void light(nicol_context context, nicol_scene scene, const std::string& path) {
    nicol_environment environment = nullptr;
    check(nicol_environment_load(context, path.c_str(), nullptr, &environment));
    const Environment holder(environment);
    check(nicol_scene_set_environment(scene, environment, nullptr, 1));
}

// Rotates the scene's environment about the world's y.
void rotate_environment(nicol_scene scene, double degrees) {
    nicol_environment environment = nullptr;
    double to_world[16], rotated[16], scale = 1;
    check(nicol_scene_get_environment(scene, &environment, to_world, &scale));
    const Environment holder(environment);
    if (environment == nullptr) throw Failure("--rotate-environment: the scene has no environment");
    const double angle = degrees * std::numbers::pi / 180;
    std::copy(to_world, to_world + 16, rotated);
    for (int column = 0; column < 4; ++column) {
        const double x = to_world[column], z = to_world[8 + column];
        rotated[column] = std::cos(angle) * x + std::sin(angle) * z;
        rotated[8 + column] = std::cos(angle) * z - std::sin(angle) * x;
    }
    check(nicol_scene_set_environment(scene, environment, rotated, scale));
}

void look_at(const std::vector<double>& given, nicol_camera& camera) {
    const double* const place = given.data();
    const double* const target = place + 3;
    const bool steep =
        std::hypot(target[0] - place[0], target[2] - place[2]) <= 1e-6 * std::abs(target[1] - place[1]);
    // Straight down, the image's up is the world's -z, straight up its z.
    const double level[3] = {0, 1, 0};
    const double over[3] = {0, 0, target[1] > place[1] ? 1.0 : -1.0};
    check(nicol_camera_look_at(&camera, place, target, steep ? over : level));
    if (given.size() > 6) camera.fov = given[6];
}

Framebuffer make_framebuffer(nicol_context context, nicol_scene scene, const Options& options) {
    std::uint32_t width = 0, height = 0, channels = 0;
    check(nicol_scene_get_film_size(scene, &width, &height));
    check(nicol_scene_get_channels(scene, &channels));
    nicol_framebuffer framebuffer = nullptr;
    check(nicol_framebuffer_create(context, options.width.value_or(width), options.height.value_or(height),
                                   channels, &framebuffer));
    return Framebuffer(framebuffer);
}

// Returns the samples of a pixel that the scene asks for, within what real time is for.
std::uint32_t samples_of(nicol_scene scene) {
    constexpr std::uint32_t without_sampler = 8;
    constexpr std::uint32_t most = 64;
    std::uint32_t count = 0;
    check(nicol_scene_get_sample_count(scene, &count));
    return count == 0 ? without_sampler : std::min(count, most);
}

// Returns the length of light's paths that the scene asks for, as far as the method follows it, which needs
// shadows.
std::int32_t depth_of(nicol_scene scene, const Options& options) {
    std::int32_t depth = 0;
    if (options.method == NICOL_METHOD_DENSE || !options.shadows) return depth;
    check(nicol_scene_get_max_depth(scene, &depth));
    return depth == 1 && options.method != NICOL_METHOD_REFERENCE ? 0 : depth;
}

void frame_all(nicol_scene scene, nicol_framebuffer framebuffer, nicol_camera& camera) {
    double lower[3], upper[3];
    std::uint32_t width = 0, height = 0, channels = 0;
    check(nicol_scene_get_bounds(scene, lower, upper));
    check(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    check(nicol_camera_frame(&camera, lower, upper, width, height));
}

nicol_camera camera_of(nicol_scene scene, nicol_framebuffer framebuffer, const Options& options) {
    nicol_camera camera = NICOL_CAMERA_INIT;
    check(nicol_scene_get_camera(scene, &camera));
    if (!options.look_at.empty()) look_at(options.look_at, camera);
    if (options.frame_all) frame_all(scene, framebuffer, camera);
    return camera;
}

nicol_render_options render_options(nicol_scene scene, const Options& options, ProgressBar& progress) {
    nicol_render_options wanted = NICOL_RENDER_OPTIONS_INIT;
    wanted.pixel_samples = samples_of(scene);
    if (options.quality) check(nicol_render_options_set_quality(&wanted, *options.quality));
    wanted.method = options.method;
    wanted.executor = options.executor;
    wanted.order_low = options.order_low.value_or(wanted.order_low);
    wanted.order_high = options.order_high.value_or(wanted.order_high);
    wanted.high_orders = options.high_orders;
    wanted.shade_at = options.shade_at;
    wanted.pixel_samples = options.pixel_samples.value_or(wanted.pixel_samples);
    if (options.filter)
        wanted.filter.kind = *options.filter;
    else
        check(nicol_scene_get_filter(scene, &wanted.filter));
    wanted.tolerance = options.tolerance.value_or(wanted.tolerance);
    wanted.components = options.components;
    check(nicol_scene_get_aovs(scene, &wanted.aovs));
    wanted.aovs |= options.aovs;
    wanted.shadows = options.shadows ? 1 : 0;
    wanted.bake_directions = options.bake_directions.value_or(wanted.bake_directions);
    wanted.refine_tolerance = options.refine_tolerance.value_or(wanted.refine_tolerance);
    wanted.max_vertices = options.max_vertices;
    wanted.dering = options.dering;
    wanted.physical = options.physical ? 1 : 0;
    wanted.split_lights = options.split_lights;
    wanted.light_samples = options.light_samples.value_or(wanted.light_samples);
    wanted.bsdf_samples = options.bsdf_samples.value_or(wanted.bsdf_samples);
    wanted.samples = options.samples.value_or(wanted.samples);
    wanted.max_depth = options.max_depth ? *options.max_depth : depth_of(scene, options);
    wanted.seed = options.seed;
    wanted.progress = ProgressBar::update;
    wanted.progress_user = &progress;
    return wanted;
}

// Renders the scene as it is, and what the shutter sees after that.
void render(nicol_context context, nicol_scene scene, nicol_framebuffer framebuffer, const Options& options,
            ProgressBar& progress) {
    nicol_render_options wanted = render_options(scene, options, progress);
    nicol_camera camera = camera_of(scene, framebuffer, options);
    check(nicol_render(scene, &camera, &wanted, framebuffer));
    const std::uint32_t pictures = options.shutter ? options.shutter->samples : 1;
    if (pictures > 1) {
        const Framebuffer next = make_framebuffer(context, scene, options);
        wanted.aovs = 0;
        for (std::uint32_t i = 1; i < pictures; ++i) {
            check(nicol_scene_set_time(scene, options.shutter->time_of(i)));
            if (!options.frame_all) camera = camera_of(scene, framebuffer, options);
            ++wanted.seed;
            check(nicol_render(scene, &camera, &wanted, next.get()));
            check(nicol_framebuffer_blend(framebuffer, next.get(), 1.0 / (i + 1)));
        }
    }
    progress.clear();
}

std::string polarizer_name(double angle) {
    std::array<char, 64> name{};
    static_cast<void>(std::snprintf(name.data(), name.size(), "polarizer_%g.png", angle));
    return name.data();
}

void write_images(nicol_framebuffer framebuffer, const Options& options) {
    const std::filesystem::path folder = options.images;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Failure("--images: " + folder.string() + ": cannot make the folder: " + error.message());
    const struct {
        nicol_observation_kind kind;
        const char* name;
    } images[] = {{NICOL_OBSERVATION_S0, "s0.png"},     {NICOL_OBSERVATION_S1, "s1.png"},
                  {NICOL_OBSERVATION_S2, "s2.png"},     {NICOL_OBSERVATION_S3, "s3.png"},
                  {NICOL_OBSERVATION_DOLP, "dolp.png"}, {NICOL_OBSERVATION_AOLP, "aolp.png"}};
    for (const auto& [kind, name] : images) {
        nicol_observation image = NICOL_OBSERVATION_INIT;
        image.kind = kind;
        if (kind == NICOL_OBSERVATION_S0) image.exposure = static_cast<float>(options.exposure);
        check(nicol_framebuffer_write_png(framebuffer, &image, (folder / name).c_str()));
    }
    for (const double angle : options.polarizers) {
        nicol_observation image = NICOL_OBSERVATION_INIT;
        image.kind = NICOL_OBSERVATION_POLARIZER;
        image.exposure = static_cast<float>(options.exposure);
        image.polarizer_angle = static_cast<float>(angle);
        check(nicol_framebuffer_write_png(framebuffer, &image, (folder / polarizer_name(angle)).c_str()));
    }
}

nicol_sensor load_sensor(const Options& options) {
    nicol_sensor sensor = NICOL_SENSOR_INIT;
    if (!options.sensor.empty()) check(nicol_sensor_load(&sensor, options.sensor.c_str()));
    return sensor;
}

void write_mosaic(nicol_framebuffer framebuffer, const nicol_sensor& sensor, const Options& options) {
    nicol_raw_image raw = NICOL_RAW_IMAGE_INIT;
    std::uint32_t channels = 0;
    check(nicol_framebuffer_get_size(framebuffer, &raw.width, &raw.height, &channels));
    std::vector<std::uint16_t> numbers(std::size_t{raw.width} * raw.height);
    raw.pixels = numbers.data();
    raw.byte_size = numbers.size() * sizeof(std::uint16_t);
    check(nicol_framebuffer_expose(framebuffer, &sensor, options.frame, &raw));
    check(nicol_sensor_write_png(&sensor, &raw, options.mosaic.c_str()));
}

void write_stats(nicol_context context, nicol_framebuffer framebuffer, const std::string& path) {
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    check(nicol_context_get_info(context, &info));
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    check(nicol_framebuffer_get_statistics(framebuffer, &statistics));
    std::uint32_t width = 0, height = 0, channels = 0;
    check(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    write_file(path, stats_json(info, width, height, channels, statistics));
}

// Refuses a folder before the work. The library would refuse it only after the work.
void refuse_folder(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw Failure(path + ": cannot write: is a folder; name a file");
}

void print_version() {
    std::printf("nicol-render %s\n", nicol_version_string());
    for (std::uint32_t i = 0; const char* fact = nicol_build_info(i); ++i) std::printf("%s\n", fact);
}

void list_devices() {
    std::uint32_t count = 0;
    check(nicol_device_count(&count));
    for (std::uint32_t device = 1; device <= count; ++device) {
        nicol_device_info info = NICOL_DEVICE_INFO_INIT;
        check(nicol_device_get_info(device, &info));
        const std::string vendor = *info.vendor != '\0' ? std::string(info.vendor) + ", " : "";
        const std::string file =
            *info.file != '\0' && std::string(info.file) != info.name ? std::string(", ") + info.file : "";
        const std::string bus = *info.pci_address != '\0' ? std::string(", PCI ") + info.pci_address : "";
        std::printf("%u: %s%s%s%s%s\n", device, vendor.c_str(), info.name, file.c_str(), bus.c_str(),
                    info.software != 0 ? ", runs on the CPU" : "");
    }
}

void run(const Options& options) {
    refuse_folder(options.output);
    const nicol_sensor sensor = load_sensor(options);
    ProgressBar progress;
    const Context context = make_context(options, progress);
    const Scene scene = load_scene(context.get(), options);
    if (!options.environment.empty()) light(context.get(), scene.get(), options.environment);
    if (options.rotate_environment != 0) rotate_environment(scene.get(), options.rotate_environment);
    const Framebuffer framebuffer = make_framebuffer(context.get(), scene.get(), options);
    render(context.get(), scene.get(), framebuffer.get(), options, progress);
    const char* const output = options.output == kStandardOutput ? "/proc/self/fd/1" : options.output.c_str();
    check(nicol_framebuffer_write_exr(framebuffer.get(), output));
    if (!options.images.empty()) write_images(framebuffer.get(), options);
    if (!options.mosaic.empty()) write_mosaic(framebuffer.get(), sensor, options);
    if (!options.stats.empty()) write_stats(context.get(), framebuffer.get(), options.stats);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Options options = parse_options(argc, argv);
        if (options.action == Options::Action::help)
            std::fputs(usage, stdout);
        else if (options.action == Options::Action::version)
            print_version();
        else if (options.action == Options::Action::list_devices)
            list_devices();
        else
            run(options);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nicol-render: %s\n", one_line(error.what()).c_str());
    } catch (...) {
        std::fputs("nicol-render: an unknown error\n", stderr);
    }
    return 2;
}
