// SPDX-License-Identifier: MIT
// Publishes a polarization camera's raw frames through shared memory, while the light rotates.
// usage: publish_mosaics SCENE NAME FRAMES
#include <nicol.h>
#include <time.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string_view>
#include <vector>

#include "common/failure.hpp"
#include "common/handles.hpp"
#include "mosaic_frame.hpp"
#include "shared_memory.hpp"

namespace {

/// Returns a * (rotation about the vertical by these degrees).
void rotate_light(const double (&a)[16], double degrees, double (&out)[16]) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double turn[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
    for (int i = 0; i < 16; ++i) {
        out[i] = 0;
        for (int k = 0; k < 4; ++k) out[i] += turn[4 * (i / 4) + k] * a[4 * k + i % 4];
    }
}

std::uint64_t now() {
    timespec t{};
    ::clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<std::uint64_t>(t.tv_sec) * 1'000'000'000u + static_cast<std::uint64_t>(t.tv_nsec);
}

void publish(const char* path, const char* name, std::uint64_t frames) {
    const auto context = create<Context>(nicol_context_create, nullptr);
    const auto scene = create<Scene>(nicol_scene_load, context.get(), path, nullptr, 0);
    nicol_camera camera = NICOL_CAMERA_INIT;
    check(nicol_scene_get_camera(scene.get(), &camera));
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 0;
    check(nicol_scene_get_film_size(scene.get(), &width, &height));
    check(nicol_scene_get_channels(scene.get(), &channels));
    const auto framebuffer =
        create<Framebuffer>(nicol_framebuffer_create, context.get(), width, height, channels);
    double placed[16];
    double scale = 1;
    nicol_environment light = nullptr;
    check(nicol_scene_get_environment(scene.get(), &light, placed, &scale));
    const Environment environment(light);

    const nicol_sensor sensor = NICOL_SENSOR_INIT;
    const SharedMemory memory(name, MosaicFrame::bytes(width, height));
    auto* const header = reinterpret_cast<MosaicHeader*>(memory.bytes().data());
    *header = {.magic = {},
               .layout = 1,
               .width = width,
               .height = height,
               .mosaic = sensor.mosaic,
               .bits = sensor.bits,
               .reserved = 0,
               .sequence = 0,
               .frame = 0,
               .time = 0,
               .reserved2 = 0};
    std::memcpy(header->magic, kMosaicMagic, sizeof header->magic);
    MosaicFrame shared(memory.bytes());

    // The library exposes into memory of the writer's own, so that the frame changes as late and as shortly
    // as it can.
    std::vector<std::uint64_t> words(shared.words());
    nicol_raw_image raw = NICOL_RAW_IMAGE_INIT;
    raw.width = width;
    raw.height = height;
    raw.pixels = words.data();
    raw.byte_size = words.size() * sizeof(std::uint64_t);
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        if (environment) {
            double rotated[16];
            rotate_light(placed, static_cast<double>(frame), rotated);
            check(nicol_scene_set_environment(scene.get(), environment.get(), rotated, scale));
        }
        check(nicol_render(scene.get(), &camera, nullptr, framebuffer.get()));
        const std::uint64_t exposed = now();
        check(nicol_framebuffer_expose(framebuffer.get(), &sensor, frame, &raw));
        shared.write({.frame = frame, .time = exposed}, words);
        std::printf("%llu\n", static_cast<unsigned long long>(frame));
        std::fflush(stdout);
    }
    // Readers may still want the last frame.
    (void)std::getchar();
}

}  // namespace

int main(int argc, char** argv) {
    std::uint64_t frames = 0;
    const std::string_view count = argc == 4 ? argv[3] : "";
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), frames);
    if (argc != 4 || error != std::errc() || end != count.data() + count.size()) {
        std::fputs("usage: publish_mosaics SCENE NAME FRAMES; ends when its input ends\n", stderr);
        return 2;
    }
    try {
        publish(argv[1], argv[2], frames);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "publish_mosaics: %s\n", one_line(e.what()).c_str());
        return 2;
    }
    return 0;
}
