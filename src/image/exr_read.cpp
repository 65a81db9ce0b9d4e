// SPDX-License-Identifier: MIT
// Reading of Stokes images from OpenEXR files.
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <algorithm>

#include "error.hpp"
#include "image/exr_input.hpp"
#include "image/exr_layout.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

void check_vectors(const path& file, const Imath::Box2i& window, std::size_t channels) {
    if (columns_of(window) * rows_of(window) * channels > kMaxImageVectors)
        throw Error(ErrorCode::unsupported, file.string() + ": " + std::to_string(columns_of(window)) +
                                                " x " + std::to_string(rows_of(window)) + " pixels with " +
                                                std::to_string(channels) +
                                                " channels; pixels times channels may be at most " +
                                                std::to_string(kMaxImageVectors));
}

StokesImage displayed_image(const StokesImage& image, const Imath::Box2i& data, const Imath::Box2i& display) {
    StokesImage out(static_cast<int>(columns_of(display)), static_cast<int>(rows_of(display)),
                    image.channels);
    out.wavelengths = image.wavelengths;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t from = image.data.size() / channels, to = out.data.size() / channels;
    for (std::size_t c = 0; c < channels; ++c)
        std::ranges::copy(displayed(std::span(image.data).subspan(c * from, from), 4, data, display),
                          out.data.begin() + static_cast<std::ptrdiff_t>(c * to));
    return out;
}

StokesImage read_pixels(const path& file, Imf::MultiPartInputFile& input, std::span<const double> wavelengths,
                        const LoadBudget& budget) {
    const Imf::Header& header = input.header(0);
    const ExrLayout layout = find_exr_layout(file, header, wavelengths);
    const Imath::Box2i window = header.dataWindow(), display = header.displayWindow();
    check_display_window(file, display);

    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    const std::size_t channels = layout.names.size();
    for (const Imath::Box2i& box : {window, display}) {
        check_vectors(file, box, channels);
        budget.take_memory(4 * sizeof(float) * columns_of(box) * rows_of(box) * channels);
        if (window == display) break;
    }
    StokesImage image(width, height, static_cast<int>(channels));
    image.wavelengths = layout.wavelengths;
    const std::size_t plane_floats =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < layout.names.size(); ++c) {
        for (std::size_t p = 0; p < 4; ++p) {
            if (layout.names[c][p].empty()) continue;
            buffer.insert(
                layout.names[c][p],
                Imf::Slice::Make(Imf::FLOAT, image.data.data() + c * plane_floats + p, window,
                                 4 * sizeof(float), 4 * sizeof(float) * static_cast<std::size_t>(width)));
        }
    }
    Imf::InputPart part(input, 0);
    part.setFrameBuffer(buffer);
    read_exr_rows(part, budget);

    if (window != display) image = displayed_image(image, window, display);

    const std::size_t plane = image.data.size() / channels;
    for (std::size_t c = 0; c < layout.names.size(); ++c) {
        const std::size_t first = c * plane;
        for (std::size_t p = 0; p < 4; ++p) {
            const std::string& name = layout.names[c][p];
            if (name.empty()) continue;
            budget.check();
            for (std::size_t i = first + p; i < first + plane; i += 4)
                require_finite_pixel(file, name, (i - first) / 4, image.width, image.data[i]);
        }
        if (layout.left_handed)
            for (std::size_t i = first + 3; i < first + plane; i += 4) image.data[i] = -image.data[i];
    }
    return image;
}

}  // namespace

StokesImage read_exr(const path& file, std::span<const double> wavelengths, const LoadBudget& budget) {
    StokesImage image;
    read_exr_input(file, budget, [&](Imf::MultiPartInputFile& input) {
        image = read_pixels(file, input, wavelengths, budget);
    });
    return image;
}

}  // namespace nicol
