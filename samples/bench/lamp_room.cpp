// SPDX-License-Identifier: MIT
#include "lamp_room.hpp"

#include <nicol_files.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "stage.hpp"

void write_lamp_room(const std::filesystem::path& path, nicol_backend backend) {
    constexpr std::uint32_t width = 128, height = 64;
    std::vector<float> pixels(std::size_t{3} * width * height, 0.07F);
    for (const auto& [row, column] : {std::pair{9U, 20U}, {14U, 52U}, {20U, 90U}, {11U, 117U}}) {
        for (std::size_t c = 0; c < 3; ++c)
            pixels[3 * (std::size_t{row} * width + column) + c] = 1000.0F - 100.0F * static_cast<float>(c);
    }
    const Context context = make_context(backend, "");
    nicol_image image = NICOL_IMAGE_INIT;
    image.width = width;
    image.height = height;
    image.channels = 3;
    image.components = 1;
    image.pixels = pixels.data();
    image.byte_size = pixels.size() * sizeof(float);
    nicol_environment handle = nullptr;
    check(nicol_environment_create_image(context.get(), &image, &handle));
    const Environment lamps(handle);
    check(nicol_environment_write(lamps.get(), nullptr, path.string().c_str()));
}
