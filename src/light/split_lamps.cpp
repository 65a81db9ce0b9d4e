// SPDX-License-Identifier: MIT
#include "light/split_lamps.hpp"

#include <algorithm>
#include <utility>

#include "light/image_light.hpp"
#include "light/lamp_search.hpp"

namespace nicol {
namespace {

// The pixels and those around them. Columns begin after the widest gap.
EquirectWindow window_around(const std::vector<LampPixels::Pixel>& pixels, const EquirectView& view) {
    const auto [first, last] = std::ranges::minmax(pixels, {}, &LampPixels::Pixel::row);
    std::vector<int> columns;
    columns.reserve(pixels.size());
    for (const auto& at : pixels) columns.push_back(at.column);
    std::ranges::sort(columns);
    int left = columns.front();
    int gap = columns.front() + view.width - columns.back();
    for (std::size_t i = 1; i < columns.size(); ++i) {
        if (columns[i] - columns[i - 1] <= gap) continue;
        gap = columns[i] - columns[i - 1];
        left = columns[i];
    }
    const int top = std::max(first.row - 1, 0);
    return {.width = view.width,
            .height = view.height,
            .top = top,
            .left = left - 1,
            .rows = std::min(last.row + 1, view.height - 1) - top,
            .columns = std::min(view.width - gap + 2, view.width)};
}

// Takes the lamp out of the image.
std::shared_ptr<const Lamp> cut_out(const LampPixels& lamp, const EquirectView& view, EquirectImage& rest) {
    const EquirectWindow window = window_around(lamp.pixels, view);
    const auto channels = static_cast<std::size_t>(view.channels);
    const int across = window.columns + 1;
    std::vector<float> values(static_cast<std::size_t>((window.rows + 1) * across) * channels * 4);
    const float* taken = lamp.values.data();
    for (const auto& at : lamp.pixels) {
        for (int c = 0; c < view.channels; ++c) {
            const auto from = rest.at(c, at.row, at.column);
            for (std::size_t p = 0; p < 4; ++p) from[p] -= taken[4 * static_cast<std::size_t>(c) + p];
        }
        // Where the window goes all around, its first column is its last as well.
        for (int x = (at.column - window.left + view.width) % view.width; x < across; x += view.width) {
            const auto to = static_cast<std::size_t>((at.row - window.top) * across + x) * channels * 4;
            std::copy_n(taken, channels * 4, values.begin() + static_cast<std::ptrdiff_t>(to));
        }
        taken += channels * 4;
    }
    return std::make_shared<const Lamp>(window, view.channels, std::move(values));
}

}  // namespace

SplitLight split_lamps(const EnvironmentPtr& light, int most) {
    const EquirectView view = light != nullptr ? light->pixels() : EquirectView{};
    if (most == 0 || view.values == nullptr) return {light, {}};
    const std::vector<LampPixels> found = find_lamps(view, most);
    if (found.empty()) return {light, {}};
    SplitLight split;
    EquirectImage rest = light->image();
    for (const LampPixels& lamp : found) split.lamps.push_back(cut_out(lamp, view, rest));
    split.rest = std::make_shared<const ImageLight>(std::move(rest));
    return split;
}

}  // namespace nicol
