// SPDX-License-Identifier: MIT
#include "light/equirect_texels.hpp"

#include <tbb/parallel_for.h>

#include "light/environment_checks.hpp"
#include "light/environment_texels.hpp"

namespace nicol {
namespace {

EquirectTexels texels_of_view(const EquirectView& view, bool polarized, std::size_t channels) {
    EquirectTexels out =
        black_texels(view.width, view.height, false, polarized ? channels : (channels + 3) / 4);
    const auto width = static_cast<std::size_t>(view.width), height = static_cast<std::size_t>(view.height);
    tbb::parallel_for(std::size_t{0}, height, [&](std::size_t row) {
        for (std::size_t c = 0; c < channels; ++c) {
            const float* from =
                view.values + (view.channels == 1 ? 0 : c * view.channel_stride) + row * view.row_stride;
            glm::vec4* const to = &out.texels[((polarized ? c : c / 4) * height + row) * width];
            for (std::size_t x = 0; x < width; ++x, from += view.pixel_stride) {
                if (polarized && view.components == 4)
                    to[x] = {from[0], from[1], from[2], from[3]};
                else
                    to[x][polarized ? 0 : static_cast<glm::length_t>(c % 4)] = from[0];
            }
        }
    });
    return out;
}

}  // namespace

EquirectTexels black_texels(int width, int height, bool centred, std::size_t planes) {
    return {.width = width,
            .height = height,
            .rows = static_cast<float>(centred ? height : height - 1),
            .first_row = centred ? 0.5F : 0.0F,
            .texels = std::vector<glm::vec4>(planes * static_cast<std::size_t>(width) *
                                             static_cast<std::size_t>(height))};
}

EquirectTexels texels_of(const EquirectImage& image, bool polarized, std::size_t channels) {
    return texels_of_view(view_of(image), polarized, channels);
}

EquirectTexels texels_of(const Environment& environment, bool polarized, std::size_t channels) {
    const EquirectView pixels = environment.pixels();
    return pixels.values != nullptr ? texels_of_view(pixels, polarized, channels)
                                    : texels_of(environment.image(), polarized, channels);
}

}  // namespace nicol
