// SPDX-License-Identifier: MIT
#include "devices/gl/device_shade.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "gl/draw.hpp"

namespace nicol {

namespace {

// Returns a layout's runs in the layout of shade.comp.
std::vector<std::array<std::int32_t, 4>> runs_of(const LightLayout& layout) {
    std::vector<std::array<std::int32_t, 4>> runs;
    for (const LightLayout::Run& run : layout.runs()) {
        runs.push_back({static_cast<std::int32_t>(run.even), static_cast<std::int32_t>(run.odd),
                        static_cast<std::int32_t>(run.count), run.sign > 0 ? run.m : -run.m});
    }
    return runs;
}

// Returns the rows of each channel, [angle].
std::vector<std::vector<float>> rows_of(const ResponseTable& table) {
    std::vector<std::vector<float>> all(static_cast<std::size_t>(table.channels()));
    for (int c = 0; c < table.channels(); ++c) {
        std::vector<float>& rows = all[static_cast<std::size_t>(c)];
        for (int angle = 0; angle < table.angles(); ++angle) {
            const std::span<const float> from = table.rows(angle, c);
            rows.insert(rows.end(), from.begin(), from.end());
        }
    }
    return all;
}

}  // namespace

DeviceTable::DeviceTable(const std::shared_ptr<gl::Context>& context, const LightLayout& layout,
                         const ResponseTable& table)
    : row_size_(static_cast<int>(table.row_size())),
      pairs_(static_cast<int>(layout.row_size())),
      runs_(static_cast<int>(layout.runs().size())),
      angles_(table.angles()),
      makes_linear_(table.makes(1) || table.makes(2)),
      makes_circular_(table.makes(3)),
      run_buffer_(gl::storage(context, runs_of(layout))),
      rows_(context, rows_of(table)) {}

DeviceShade::DeviceShade(const std::shared_ptr<gl::Context>& context)
    : program_(gl::Program::compute(context, "shade.comp")) {}

void DeviceShade::set_view(const Viewpoint& view) {
    set_view_uniforms(program_, view);
}

void DeviceShade::run(const DeviceTable& table, const DeviceLight& light, std::size_t first, std::size_t last,
                      const DevicePoints& points) {
    const std::size_t begin = gl::bind_vertices(*points.positions, 0, 3, first, last);
    std::ignore = gl::bind_vertices(*points.normals, 1, 3, first, last);
    program_.set("points", glm::ivec3(first - begin, first - light.first(), last - first));
    program_.set("stride", static_cast<int>(light.stride()));
    program_.set("row_size", table.row_size_);
    program_.set("pairs", table.pairs_);
    program_.set("runs_of_row", table.runs_);
    program_.set("angles", table.angles_);
    program_.set("makes_linear", table.makes_linear_ ? 1 : 0);
    program_.set("makes_circular", table.makes_circular_ ? 1 : 0);
    table.run_buffer_.bind_storage(5);
    const bool one_light = light.channels() == 1;
    const StokesBuffer& stokes = *points.stokes;
    program_.set("light_step", one_light ? 0 : static_cast<int>(light.channel_step()));
    program_.set("table_step", static_cast<int>(table.rows_.step()));
    program_.set("result_step", static_cast<int>(stokes.step()));
    const std::size_t largest =
        std::max({light.channel_bytes(), table.rows_.bytes(), stokes.channel_bytes()});
    gl::for_independent_channels(
        *program_.context(), stokes.channels(), largest, [&](gl::ChannelGroup channels) {
            light.bind(2, one_light ? gl::ChannelGroup{.first = 0, .count = 1} : channels);
            table.rows_.bind(3, channels);
            std::ignore = stokes.bind(4, channels, first, last);
            gl::dispatch(program_, gl::groups_for(last - first), 1, static_cast<unsigned>(channels.count));
        });
}

}  // namespace nicol
