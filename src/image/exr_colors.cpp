// SPDX-License-Identifier: MIT
#include "image/exr_colors.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>

#include <string>
#include <utility>
#include <vector>

#include "files/file_error.hpp"
#include "image/exr_input.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

std::vector<std::string> names_of(const path& file, const Imf::ChannelList& list) {
    const auto has = [&](const std::string& name) { return list.findChannel(name) != nullptr; };
    std::vector<std::string> names;
    if (has("RY") || has("BY"))
        unsupported_file(file, "stores luminance and chroma (RY, BY); write R G B instead");
    if (has("R") && has("G") && has("B"))
        names = {"R", "G", "B"};
    else if (has("Y"))
        names = {"Y"};
    else
        invalid_file(file, "has neither R G B nor Y");
    if (has("A")) names.emplace_back("A");
    for (const std::string& name : names) {
        const Imf::Channel& channel = *list.findChannel(name);
        if (channel.xSampling != 1 || channel.ySampling != 1)
            unsupported_file(file, "channel " + name + " is subsampled; write it at full resolution");
    }
    return names;
}

Bitmap read_pixels(const path& file, Imf::MultiPartInputFile& input, const LoadBudget& budget) {
    const Imf::Header& header = input.header(0);
    const Imath::Box2i window = header.dataWindow(), display = header.displayWindow();
    check_display_window(file, display);
    const std::vector<std::string> names = names_of(file, header.channels());
    const std::size_t columns = columns_of(window);
    budget.take_memory(sizeof(float) * columns * rows_of(window) * names.size());
    std::vector<float> values(columns * rows_of(window) * names.size());
    Imf::FrameBuffer buffer;
    const std::size_t step = names.size() * sizeof(float);
    for (std::size_t c = 0; c < names.size(); ++c)
        buffer.insert(names[c],
                      Imf::Slice::Make(Imf::FLOAT, values.data() + c, window, step, step * columns));
    Imf::InputPart part(input, 0);
    part.setFrameBuffer(buffer);
    read_exr_rows(part, budget);
    if (window != display) {
        budget.take_memory(sizeof(float) * columns_of(display) * rows_of(display) * names.size());
        values = displayed(values, names.size(), window, display);
    }
    Bitmap out{.width = static_cast<int>(columns_of(display)),
               .height = static_cast<int>(rows_of(display)),
               .channels = static_cast<int>(names.size()),
               .linear = true,
               .values = std::move(values)};
    for (std::size_t i = 0; i < out.values.size(); ++i)
        require_finite_pixel(file, names[i % names.size()], i / names.size(), out.width, out.values[i]);
    return out;
}

}  // namespace

Bitmap read_exr_colors(const path& file, const LoadBudget& budget) {
    Bitmap out;
    read_exr_input(file, budget,
                   [&](Imf::MultiPartInputFile& input) { out = read_pixels(file, input, budget); });
    return out;
}

}  // namespace nicol
