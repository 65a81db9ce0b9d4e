// SPDX-License-Identifier: MIT
#include "light/equirect_texels.hpp"

namespace nicol {

EquirectTexels black_texels(int width, int height, bool centred, std::size_t planes) {
    return {.width = width,
            .height = height,
            .rows = static_cast<float>(centred ? height : height - 1),
            .first_row = centred ? 0.5F : 0.0F,
            .texels = std::vector<glm::vec4>(planes * static_cast<std::size_t>(width) *
                                             static_cast<std::size_t>(height))};
}

EquirectTexels texels_of(const EquirectImage& image, bool polarized, std::size_t channels) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    EquirectTexels out =
        black_texels(image.width, image.height, false, polarized ? channels : (channels + 3) / 4);
    for (std::size_t c = 0; c < channels; ++c) {
        const float* const from = image.data.data() + (image.channels == 1 ? 0 : 4 * c * count);
        for (std::size_t i = 0; i < count; ++i) {
            if (polarized)
                out.texels[c * count + i] = {from[4 * i], from[4 * i + 1], from[4 * i + 2], from[4 * i + 3]};
            else
                out.texels[c / 4 * count + i][static_cast<glm::length_t>(c % 4)] = from[4 * i];
        }
    }
    return out;
}

}  // namespace nicol
