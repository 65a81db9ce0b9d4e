// SPDX-License-Identifier: MIT
// Stokes images from OpenEXR.
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>

#include "error.hpp"
#include "files/file_error.hpp"
#include "image/exr_layout.hpp"
#include "image/exr_structure.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

StokesImage read_pixels(const path& file, std::span<const double> wavelengths) {
    // No OpenEXR threads (0): its pool is one per process and belongs to the host.
    Imf::MultiPartInputFile input(file.c_str(), 0);
    const Imf::Header& header = input.header(0);
    const ExrLayout layout = find_exr_layout(file, header, wavelengths);
    const Imath::Box2i window = header.dataWindow();

    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    const std::size_t channels = layout.names.size();
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels > kMaxImageVectors)
        throw Error(ErrorCode::unsupported, file.string() + ": " + std::to_string(width) + " x " +
                                                std::to_string(height) + " pixels with " +
                                                std::to_string(channels) +
                                                " channels; pixels times channels may be at most " +
                                                std::to_string(kMaxImageVectors));
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
    part.readPixels(window.min.y, window.max.y);

    for (std::size_t c = 0; c < layout.names.size(); ++c) {
        const std::size_t first = c * plane_floats;
        for (std::size_t p = 0; p < 4; ++p) {
            const std::string& name = layout.names[c][p];
            if (name.empty()) continue;
            for (std::size_t i = first + p; i < first + plane_floats; i += 4) {
                if (std::isfinite(image.data[i])) continue;
                const std::size_t pixel = (i - first) / 4;
                const auto columns = static_cast<std::size_t>(width);
                invalid_file(file, "channel " + name + ", pixel (" + std::to_string(pixel % columns) + ", " +
                                       std::to_string(pixel / columns) + ") is " +
                                       (std::isnan(image.data[i]) ? "not a number" : "infinite") +
                                       "; all values must be finite");
            }
        }
        if (layout.left_handed)
            for (std::size_t i = first + 3; i < first + plane_floats; i += 4) image.data[i] = -image.data[i];
    }
    return image;
}

}  // namespace

StokesImage read_exr(const path& file, std::span<const double> wavelengths) {
    std::error_code error;
    const std::uintmax_t size =
        std::filesystem::is_directory(file, error) ? 0 : std::filesystem::file_size(file, error);
    if (error || size == 0 || !std::ifstream(file)) {
        if (!error && std::filesystem::is_regular_file(file, error) && size == 0)
            invalid_file(file, "is empty");
        throw Error(ErrorCode::file_not_found, file.string() + ": cannot be opened for reading" +
                                                   (error ? " (" + error.message() + ")" : ""));
    }
    try {
        check_exr_structure(file, size);
        return read_pixels(file, wavelengths);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        invalid_file(file, std::string("is damaged or truncated (") + e.what() + ")");
    }
}

}  // namespace nicol
