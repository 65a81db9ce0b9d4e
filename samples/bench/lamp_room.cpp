// SPDX-License-Identifier: MIT
#include "lamp_room.hpp"

#include <nicol_files.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/light_image.hpp"
#include "stage.hpp"

namespace {

struct Lamp {
    std::size_t row, column;
};

void write_room(const std::filesystem::path& path, nicol_backend backend, std::span<const Lamp> lamps) {
    constexpr std::uint32_t width = 128, height = 64;
    std::vector<float> pixels(std::size_t{3} * width * height, 0.07F);
    for (const auto& [row, column] : lamps) {
        for (std::size_t c = 0; c < 3; ++c)
            pixels[3 * (row * width + column) + c] = 1000.0F - 100.0F * static_cast<float>(c);
    }
    const Context context = make_context(backend, "");
    const nicol_image image = light_image(pixels, width, height, 3, 1);
    nicol_environment handle = nullptr;
    check(nicol_environment_create_image(context.get(), &image, &handle));
    const Environment room(handle);
    check(nicol_environment_write(room.get(), nullptr, path.string().c_str()));
}

}  // namespace

void write_lamp_room(const std::filesystem::path& path, nicol_backend backend) {
    write_room(path, backend, std::array<Lamp, 4>{{{9, 20}, {14, 52}, {20, 90}, {11, 117}}});
}

void write_lamp_behind(const std::filesystem::path& path, nicol_backend backend) {
    write_room(path, backend, std::array<Lamp, 1>{{{16, 8}}});
}
