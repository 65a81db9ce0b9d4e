// SPDX-License-Identifier: MIT
// Stokes pictures from OpenEXR.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>

#include "image/exr_names.hpp"
#include "image/exr_structure.hpp"
#include "nicol/error.hpp"
#include "nicol/stokes_image.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

[[noreturn]] void invalid(const path& file, const std::string& what) {
    throw Error(ErrorCode::invalid_file, file.string() + ": " + what);
}

[[noreturn]] void unsupported(const path& file, const std::string& what) {
    throw Error(ErrorCode::unsupported, file.string() + ": " + what);
}

/// What to read: the names of the channels of each Stokes component, empty where there are none.
struct Layout {
    int channels = 0;
    std::array<std::array<std::string, 3>, 4> names;
};

Layout find_layout(const path& file, const Imf::ChannelList& list) {
    const auto has = [&](const std::string& name) { return list.findChannel(name) != nullptr; };
    if (has("RY") || has("BY"))
        unsupported(file, "stores luminance and chroma (RY, BY); write R G B instead");

    std::array<std::string, 3> colours = {"R", "G", "B"};
    Layout layout;
    for (const std::string& colour : colours)
        if (has(colour) || has(exr_channel(0, colour))) layout.channels = 3;
    if (layout.channels == 0 && (has("Y") || has("S0.Y"))) {
        layout.channels = 1;
        colours = {"Y", "", ""};
    }
    if (layout.channels == 0) invalid(file, "has neither R G B nor Y nor S0.R S0.G S0.B nor S0.Y");

    std::array<bool, 4> present{};
    for (std::size_t p = 0; p < 4; ++p)
        for (const std::string& colour : colours)
            present[p] = present[p] || (!colour.empty() && has(exr_channel(p, colour)));
    // s1 and s2 turn into each other with the frame: one without the other describes no light.
    if (present[1] || present[2] || present[3]) present[1] = present[2] = true;

    for (std::size_t p = 0; p < 4; ++p) {
        if (p > 0 && !present[p]) continue;
        for (std::size_t c = 0; c < static_cast<std::size_t>(layout.channels); ++c) {
            const std::string name = p == 0 && !present[0] ? colours[c] : exr_channel(p, colours[c]);
            const Imf::Channel* channel = list.findChannel(name);
            if (channel == nullptr) invalid(file, "has no channel " + name + ", which its others call for");
            if (channel->xSampling != 1 || channel->ySampling != 1)
                unsupported(file, "channel " + name + " is subsampled; write it at full resolution");
            layout.names[p][c] = name;
        }
    }
    return layout;
}

StokesImage read_pixels(const path& file) {
    // No OpenEXR threads (0): its pool is one per process and belongs to the host.
    Imf::MultiPartInputFile input(file.c_str(), 0);
    const Imf::Header& header = input.header(0);
    const Layout layout = find_layout(file, header.channels());
    const Imath::Box2i window = header.dataWindow();

    StokesImage image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, layout.channels);
    const std::size_t plane_floats =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    Imf::FrameBuffer buffer;
    for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (layout.names[p][c].empty()) continue;
            const auto width = static_cast<std::size_t>(image.width);
            buffer.insert(layout.names[p][c],
                          Imf::Slice::Make(Imf::FLOAT, image.data.data() + c * plane_floats + p, window,
                                           4 * sizeof(float), 4 * sizeof(float) * width));
        }
    }
    Imf::InputPart part(input, 0);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);

    for (std::size_t p = 0; p < 4; ++p) {
        for (int c = 0; c < image.channels; ++c) {
            const std::string& name = layout.names[p][static_cast<std::size_t>(c)];
            if (name.empty()) continue;
            const std::size_t first = static_cast<std::size_t>(c) * plane_floats;
            for (std::size_t i = first + p; i < first + plane_floats; i += 4) {
                if (std::isfinite(image.data[i])) continue;
                const std::size_t pixel = (i - first) / 4;
                const auto width = static_cast<std::size_t>(image.width);
                invalid(file, "channel " + name + ", pixel (" + std::to_string(pixel % width) + ", " +
                                  std::to_string(pixel / width) + ") is " +
                                  (std::isnan(image.data[i]) ? "not a number" : "infinite") +
                                  "; all values must be finite");
            }
        }
    }
    return image;
}

}  // namespace

StokesImage read_exr(const path& file) {
    std::error_code error;
    const std::uintmax_t size =
        std::filesystem::is_directory(file, error) ? 0 : std::filesystem::file_size(file, error);
    if (error || size == 0 || !std::ifstream(file)) {
        if (!error && std::filesystem::is_regular_file(file, error) && size == 0) invalid(file, "is empty");
        throw Error(ErrorCode::file_not_found, file.string() + ": cannot be opened for reading" +
                                                   (error ? " (" + error.message() + ")" : ""));
    }
    try {
        check_exr_structure(file, size);
        return read_pixels(file);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        invalid(file, std::string("is damaged or truncated (") + e.what() + ")");
    }
}

}  // namespace nicol
