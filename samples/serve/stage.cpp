// SPDX-License-Identifier: MIT
#include "stage.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>

#include "camera.hpp"
#include "common/failure.hpp"
#include "common/handles.hpp"
#include "deflate.hpp"
#include "digest.hpp"
#include "exr.hpp"
#include "field.hpp"
#include "observe.hpp"
#include "planes.hpp"
#include "png.hpp"

namespace {

/// Optimisation with which an image depends on the images before it. An address always has the same bytes.
constexpr std::uint32_t kHistoryShows = NICOL_OPTIMISATION_RAYS;
constexpr std::uint32_t kProbeSide = 33;  // odd, so that a pixel lies in the middle

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> exr_names(std::uint32_t channels) {
    if (channels == 1) return {"Y"};
    if (channels == 3) return {"B", "G", "R"};
    std::vector<std::string> names;
    for (std::uint32_t c = 0; c < channels; ++c) names.push_back((c < 10 ? "0" : "") + std::to_string(c));
    return names;
}

std::string encode_float_image(FloatImage image, Observer observer) {
    if (observer == Observer::dolp || observer == Observer::aolp) {
        const std::size_t at = observer == Observer::aolp ? 0 : 1;
        for (std::size_t i = 0; i < image.data.size() / 2; ++i) image.data[i] = image.data[2 * i + at];
        image.data.resize(image.data.size() / 2);
        image.values = 1;
    }
    if (image.values == 3)  // OpenEXR's order is B G R
        for (std::size_t i = 0; i < image.data.size(); i += 3) std::swap(image.data[i], image.data[i + 2]);
    return encode_exr(image.width, image.height, exr_names(image.values), image.data);
}

/// Returns the digest of all files of a scene, in the scene's order, so that an exchange of two meshes' names
/// changes it.
std::string digest_of(nicol_scene scene) {
    std::uint32_t count = 0;
    check(nicol_scene_get_file_count(scene, &count));
    std::string digests;
    for (std::uint32_t i = 0; i < count; ++i) {
        nicol_scene_file file = NICOL_SCENE_FILE_INIT;
        check(nicol_scene_get_file(scene, i, &file));
        digests += file.digest;
    }
    return hex(sha256(digests));
}

/// Lights a scene of glTF, which has no environments, evenly from all around if the file has no lights.
void light_if_dark(nicol_context context, nicol_scene scene) {
    nicol_scene_file first = NICOL_SCENE_FILE_INIT;
    check(nicol_scene_get_file(scene, 0, &first));
    if (!lower_case(std::filesystem::path(first.path).extension().string()).starts_with(".gl")) return;
    std::uint32_t lights = 0;
    check(nicol_scene_get_light_count(scene, &lights));
    if (lights > 0) return;
    nicol_environment even = nullptr;
    check(nicol_environment_create_constant(context, nullptr, &even));
    const Environment owner(even);
    check(nicol_scene_set_environment(scene, even, nullptr, 1));
}

/// Returns the bytes of the OpenEXR file with Stokes vectors.
std::string exr_file(nicol_framebuffer framebuffer) {
    std::string content;
    const nicol_sink_callback append = [](void* user, const void* bytes, std::uint64_t size) {
        // Exceptions must not pass through the library.
        try {
            static_cast<std::string*>(user)->append(static_cast<const char*>(bytes), size);
            return std::int32_t{1};
        } catch (const std::bad_alloc&) {
            return std::int32_t{0};
        }
    };
    check(nicol_framebuffer_encode_exr(framebuffer, append, &content));
    return content;
}

/// Resolves the names in an uploaded scene.
std::int32_t find_uploaded(void* user, const char* name, nicol_file_content* content) {
    const auto& files = static_cast<const Upload*>(user)->files;
    const auto found = std::ranges::find(files, std::string_view(name), &UploadedFile::name);
    if (found == files.end()) return 0;
    content->bytes = found->bytes.data();
    content->byte_size = found->bytes.size();
    return 1;
}

}  // namespace

Stage::Stage(nicol_context context, const std::filesystem::path& path) : context_(context) {
    info_.id = path.stem();
    nicol_scene scene = nullptr;
    check(nicol_scene_load(context, path.c_str(), nullptr, 0, &scene));
    prepare(scene);
}

Stage::Stage(nicol_context context, const Upload& upload) : context_(context) {
    info_.id = upload.id;
    const UploadedFile& first = upload.files.front();
    nicol_memory_file file = NICOL_MEMORY_FILE_INIT;
    file.name = first.name.c_str();
    file.bytes = first.bytes.data();
    file.byte_size = first.bytes.size();
    file.resolve = find_uploaded;
    file.resolve_user = const_cast<Upload*>(&upload);  // find_uploaded() only reads it
    nicol_scene scene = nullptr;
    check(nicol_scene_load_memory(context, &file, nullptr, 0, &scene));
    prepare(scene);
}

void Stage::prepare(nicol_scene scene) {
    scene_.reset(scene);
    info_.digest = digest_of(scene);
    light_if_dark(context_, scene);
    check(nicol_scene_get_camera(scene, &camera_));
    check(nicol_scene_get_film_size(scene, &info_.width, &info_.height));
    check(nicol_scene_get_channels(scene, &info_.channels));
    nicol_environment environment = nullptr;
    check(nicol_scene_get_environment(scene, &environment, light_to_world_, &light_scale_));
    environment_.reset(environment);
    info_.up = vertical_axis(camera_);
    info_.fov = camera_.fov > 0 ? camera_.fov : 45;
    info_.orbit = orbit_of(camera_, info_.up, centre_depth());
}

/// Returns the depth at the middle of the scene's image. If nothing is visible there: the median depth, or 1
/// for an empty image.
double Stage::centre_depth() const {
    nicol_framebuffer framebuffer = nullptr;
    check(nicol_framebuffer_create(context_, kProbeSide, kProbeSide, info_.channels, &framebuffer));
    const Framebuffer owner(framebuffer);
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.disabled_optimisations = kHistoryShows;
    options.aovs = NICOL_AOV_DEPTH;
    check(nicol_render(scene_.get(), &camera_, &options, framebuffer));
    std::vector<float> depth(std::size_t{kProbeSide} * kProbeSide);
    check(nicol_framebuffer_read(framebuffer, NICOL_PLANE_DEPTH, 0, depth.data(), 0,
                                 depth.size() * sizeof(float)));
    const auto middle = static_cast<double>(depth[depth.size() / 2]);
    if (std::isfinite(middle)) return middle;
    std::erase_if(depth, [](float d) { return !std::isfinite(d); });
    if (depth.empty()) return 1;
    const auto half = depth.begin() + static_cast<std::ptrdiff_t>(depth.size() / 2);
    std::ranges::nth_element(depth, half);
    return static_cast<double>(*half);
}

void Stage::make_framebuffer(std::uint32_t width, std::uint32_t height) {
    if (framebuffer_ && width == width_ && height == height_) return;
    nicol_framebuffer framebuffer = nullptr;
    check(nicol_framebuffer_create(context_, width, height, info_.channels, &framebuffer));
    framebuffer_.reset(framebuffer);
    width_ = width;
    height_ = height;
    has_view_ = false;
}

void Stage::draw(const View& view, const Progress& progress, ResultHead& head) {
    head.unchanged = has_view_ && view == view_ ? 1 : 0;
    if (head.unchanged != 0) return;
    const nicol_camera camera = camera_of(view, camera_, info_.up);
    make_framebuffer(view.width, view.height);
    has_view_ = false;
    if (environment_ && (view.light != light_ || view.light_tilt != light_tilt_)) {
        double rotated[16];
        rotate_light(view, info_.up, light_to_world_, rotated);
        check(nicol_scene_set_environment(scene_.get(), environment_.get(), rotated, light_scale_));
        light_ = view.light;
        light_tilt_ = view.light_tilt;
    }
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.disabled_optimisations = kHistoryShows;
    if (view.order_low >= 0) options.order_low = static_cast<std::uint32_t>(view.order_low);
    if (view.order_high >= 0) options.order_high = static_cast<std::uint32_t>(view.order_high);
    if (view.tolerance > 0) options.tolerance = view.tolerance;
    options.pixel_samples = view.samples;
    options.progress = progress.callback;
    options.progress_user = progress.user;
    check(nicol_render(scene_.get(), &camera, &options, framebuffer_.get()));
    view_ = view;
    has_view_ = true;
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    check(nicol_framebuffer_get_statistics(framebuffer_.get(), &statistics));
    head.ms = {statistics.project_ms, statistics.bake_ms, statistics.relight_ms,
               statistics.shade_ms,   statistics.draw_ms, 0};
}

std::string Stage::render(const ImageRequest& request, const Progress& progress, ResultHead& head) {
    draw(request.view, progress, head);
    const auto start = std::chrono::steady_clock::now();
    head.scale = static_cast<float>(request.scale);
    std::string content = encode(request, head);
    head.ms.back() = milliseconds_since(start);
    return content;
}

std::string Stage::encode(const ImageRequest& request, ResultHead& head) const {
    switch (request.format) {
        case Format::stokes_f16:
        case Format::stokes_f32:
            return stokes(request.format == Format::stokes_f16);
        case Format::stokes_planes: {
            const Planes planes = planes_of(stokes(true), width_, height_, request.bits);
            head.components = planes.components;
            if (!request.deflate) return planes.bytes;
            return deflated(planes.bytes, request.bits > 0 ? Deflate::size : Deflate::speed);
        }
        case Format::stokes_exr:
            return exr_file(framebuffer_.get());
        case Format::exr:
            return encode_float_image(observe(framebuffer_.get(), request), request.observer);
        default: {
            const FloatImage seen = observe(framebuffer_.get(), request);
            const bool curve = request.observer == Observer::s0 || request.observer == Observer::polarizer;
            return encode_png(seen.width, seen.height, colours(seen, request.observer, head.scale), curve);
        }
    }
}

/// Returns [channel][row][column][4], little-endian.
std::string Stage::stokes(bool half) const {
    const std::size_t plane = std::size_t{width_} * height_ * 4 * (half ? 2 : 4);
    std::string content(plane * info_.channels, '\0');
    for (std::uint32_t c = 0; c < info_.channels; ++c) {
        nicol_plane_buffer to = NICOL_PLANE_BUFFER_INIT;
        to.plane = NICOL_PLANE_STOKES;
        to.format = half ? NICOL_FORMAT_FLOAT16 : NICOL_FORMAT_FLOAT32;
        to.channel = c;
        to.pixels = content.data() + c * plane;
        to.byte_size = plane;
        check(nicol_framebuffer_read_plane(framebuffer_.get(), &to));
    }
    return content;
}
