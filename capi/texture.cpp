// SPDX-License-Identifier: MIT
// Textures.
#include "texture/texture.hpp"

#include <cstring>

#include "assets.hpp"
#include "initialiser.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

glm::dmat3 uv_matrix(const double* rows) {
    glm::dmat3 m;
    for (glm::length_t row = 0; row < 3; ++row)
        for (glm::length_t column = 0; column < 3; ++column) m[column][row] = rows[3 * row + column];
    return m;
}

struct Options {
    TextureSampling sampling;
    bool raw;
};

Options read(const nicol_texture_options* options) {
    const auto given = read_options(options, nicol_texture_options NICOL_TEXTURE_OPTIONS_INIT);
    require_constant(given.filter, NICOL_TEXTURE_FILTER_MIPMAP, "options->filter",
                     "NICOL_TEXTURE_FILTER_...");
    require_constant(given.wrap, NICOL_TEXTURE_WRAP_CLAMP, "options->wrap", "NICOL_TEXTURE_WRAP_...");
    return {.sampling = {.filter = static_cast<TextureSampling::Filter>(given.filter),
                         .wrap = static_cast<TextureSampling::Wrap>(given.wrap),
                         .to_uv = uv_matrix(given.to_uv)},
            .raw = switch_from(given.raw, "options->raw")};
}

/// Appends numbers of type T divided by `one`, which maps integers to 0..1.
template <class T>
void append(const void* row, std::size_t count, float one, std::vector<float>& values) {
    for (std::size_t i = 0; i < count; ++i) {
        T number;
        std::memcpy(&number, static_cast<const char*>(row) + i * sizeof number, sizeof number);
        values.push_back(static_cast<float>(number) / one);
    }
}

TextureImage image_of(const nicol_texture_image& given, bool raw) {
    require(given.pixels, "image->pixels");
    require_constant(given.type, NICOL_TEXEL_FLOAT32, "image->type", "NICOL_TEXEL_...");
    if (given.reserved != 0) refuse("image->reserved must be 0");
    constexpr std::uint64_t most_pixels = std::uint64_t{3} << 26;
    if (given.width < 1 || given.width > 32768 || given.height < 1 || given.height > 32768 ||
        std::uint64_t{given.width} * given.height > most_pixels) {
        refuse("image is " + std::to_string(given.width) + " x " + std::to_string(given.height) +
               " pixels; width and height must lie in 1 to 32768, their product may be " +
               std::to_string(most_pixels));
    }
    if (given.channels != 1 && given.channels != 3 && given.channels != 4)
        refuse("image->channels is " + std::to_string(given.channels) + "; it must be 1, 3 or 4");
    constexpr std::uint64_t sizes[] = {sizeof(std::uint8_t), sizeof(std::uint16_t), sizeof(float)};
    const std::uint64_t row = std::uint64_t{given.width} * given.channels * sizes[given.type];
    const std::uint64_t stride = given.row_stride == 0 ? row : given.row_stride;
    if (stride < row || stride > (std::uint64_t{1} << 40))
        refuse("image->row_stride is " + std::to_string(stride) + "; a row takes " + std::to_string(row) +
               " bytes");
    const std::uint64_t needed = stride * (given.height - 1) + row;
    if (given.byte_size < needed)
        refuse("image->byte_size is " + std::to_string(given.byte_size) + "; the image takes " +
               std::to_string(needed) + " bytes");
    TextureImage image{.width = static_cast<int>(given.width),
                       .height = static_cast<int>(given.height),
                       .channels = static_cast<int>(given.channels),
                       .values = {}};
    const std::size_t count = std::size_t{given.width} * given.channels;
    image.values.reserve(count * given.height);
    for (std::uint32_t y = 0; y < given.height; ++y) {
        const char* const from = static_cast<const char*>(given.pixels) + stride * y;
        if (given.type == NICOL_TEXEL_UINT8) append<std::uint8_t>(from, count, 255, image.values);
        if (given.type == NICOL_TEXEL_UINT16) append<std::uint16_t>(from, count, 65535, image.values);
        if (given.type == NICOL_TEXEL_FLOAT32) append<float>(from, count, 1, image.values);
    }
    if (!raw && given.type != NICOL_TEXEL_FLOAT32) decode_srgb(image);
    return image;
}

/// Loads a texture, for load().
struct TextureLoader {
    const nicol_texture_options* options;

    TexturePtr operator()(const std::filesystem::path& path, const LoadBudget& budget,
                          const SessionPtr& /*session*/) const {
        const Options how = read(options);
        budget.take_file(path);
        TextureImage image = load_texture_image(path, how.raw, budget);
        budget.take_pixels(
            path, static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height));
        return image_texture(std::move(image), how.sampling);
    }
};

/// Returns three values, equal if only one is given. `channels` becomes the given number if that is larger.
glm::vec3 color_of(const nicol_spectrum* given, double fallback, const char* name, int& channels) {
    static constexpr nicol_spectrum unset = NICOL_SPECTRUM_INIT;
    const std::vector<double> values = spectrum(given != nullptr ? *given : unset, fallback, 1, name);
    if (values.size() != 1 && values.size() != 3)
        refuse(std::string(name) + " has " + std::to_string(values.size()) + " values; a colour has 1 or 3");
    channels = std::max(channels, static_cast<int>(values.size()));
    return values.size() == 1 ? glm::dvec3(values[0]) : glm::dvec3(values[0], values[1], values[2]);
}

}  // namespace

nicol_result nicol_texture_create_image(nicol_context context, const nicol_texture_image* image,
                                        const nicol_texture_options* options, nicol_texture* texture) {
    return create(context, texture, "texture", [&] {
        const auto given = read_struct(image, nicol_texture_image NICOL_TEXTURE_IMAGE_INIT, "image");
        const Options how = read(options);
        return image_texture(image_of(given, how.raw), how.sampling);
    });
}

nicol_result nicol_texture_load(nicol_context context, const char* path, const nicol_texture_options* options,
                                nicol_texture* texture) {
    return load(context, path, texture, "texture", TextureLoader{options});
}

nicol_result nicol_texture_load_memory(nicol_context context, const nicol_memory_file* file,
                                       const nicol_texture_options* options, nicol_texture* texture) {
    return load(context, file, texture, "texture", TextureLoader{options});
}

nicol_result nicol_texture_create_checkerboard(nicol_context context, const nicol_spectrum* color0,
                                               const nicol_spectrum* color1, const double to_uv[9],
                                               nicol_texture* texture) {
    return create(context, texture, "texture", [&] {
        int channels = 1;
        const glm::vec3 first = color_of(color0, 0.4, "color0", channels);
        const glm::vec3 second = color_of(color1, 0.2, "color1", channels);
        return checkerboard_texture(first, second, channels,
                                    to_uv != nullptr ? uv_matrix(to_uv) : glm::dmat3(1.0));
    });
}

nicol_result nicol_texture_create_vertex_colors(nicol_context context, nicol_texture* texture) {
    return create(context, texture, "texture", [] { return mesh_color_texture(ColorsOf::vertices); });
}

nicol_result nicol_texture_create_face_colors(nicol_context context, nicol_texture* texture) {
    return create(context, texture, "texture", [] { return mesh_color_texture(ColorsOf::faces); });
}

nicol_result nicol_texture_retain(nicol_texture texture) {
    return retain(texture);
}
nicol_result nicol_texture_release(nicol_texture texture) {
    return release(texture);
}

NICOL_INITIALISER(nicol_texture_image, NICOL_TEXTURE_IMAGE_INIT)
NICOL_INITIALISER(nicol_texture_options, NICOL_TEXTURE_OPTIONS_INIT)
