// SPDX-License-Identifier: MIT
#include "devices/gl/device_shade.hpp"

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

}  // namespace

DeviceTable::DeviceTable(const std::shared_ptr<gl::Context>& context, const LightLayout& layout,
                         const ResponseTable& table)
    : row_size_(static_cast<int>(table.row_size())),
      pairs_(static_cast<int>(layout.row_size())),
      runs_(static_cast<int>(layout.runs().size())),
      angles_(table.angles()),
      makes_linear_(table.makes(1) || table.makes(2)),
      makes_circular_(table.makes(3)),
      run_buffer_(gl::storage(context, runs_of(layout))) {
    std::vector<float> rows;
    for (int c = 0; c < table.channels(); ++c) {
        rows.clear();
        for (int angle = 0; angle < angles_; ++angle) {
            const std::span<const float> from = table.rows(angle, c);
            rows.insert(rows.end(), from.begin(), from.end());
        }
        channels_.push_back(gl::storage(context, rows));
    }
}

DeviceShade::DeviceShade(const std::shared_ptr<gl::Context>& context)
    : program_(gl::Program::compute(context, "shade.comp")) {}

void DeviceShade::set_view(const Viewpoint& view) {
    set_view_uniforms(program_, view);
}

void DeviceShade::run(const DeviceTable& table, const DeviceLight& light, std::size_t first, std::size_t last,
                      const DevicePoints& points) {
    const std::size_t begin = gl::bind_vertices(*points.positions, 0, 3, first, last);
    std::ignore = gl::bind_vertices(*points.normals, 1, 3, first, last);
    program_.set("first", static_cast<int>(first - begin));
    program_.set("light_first", static_cast<int>(first - light.first()));
    program_.set("count", static_cast<int>(last - first));
    program_.set("stride", static_cast<int>(light.stride()));
    program_.set("row_size", table.row_size_);
    program_.set("pairs", table.pairs_);
    program_.set("runs_of_row", table.runs_);
    program_.set("angles", table.angles_);
    program_.set("makes_linear", table.makes_linear_ ? 1 : 0);
    program_.set("makes_circular", table.makes_circular_ ? 1 : 0);
    table.run_buffer_.bind_storage(5);
    const gl::IndependentDispatches of_channels(*program_.context());
    for (std::size_t c = 0; c < points.stokes.size(); ++c) {
        light.bind(2, light.channels() == 1 ? 0 : static_cast<int>(c));
        table.channels_[table.channels_.size() == 1 ? 0 : c].bind_storage(3);
        std::ignore = gl::bind_vertices(*points.stokes[c], 4, 4, first, last);
        gl::dispatch(program_, gl::groups_for(last - first));
    }
}

}  // namespace nicol
