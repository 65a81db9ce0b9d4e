// SPDX-License-Identifier: MIT
#include "devices/gl/device_shadow_grid.hpp"

#include <algorithm>
#include <vector>

#include "gl/draw.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using Slots = ShadowGrid::Slots;

// Size of a work space, if one group of vertices needs no more.
constexpr std::size_t kWorkBytes = std::size_t{1} << 25;

// Sum in the layout of glsl/sums.comp.
struct Sum {
    std::int32_t first = 0;
    std::int32_t second = -1;
    std::int32_t terms = 0;
    std::int32_t factor = 0;
};

std::int32_t index(std::size_t i) {
    return static_cast<std::int32_t>(i);
}

// Returns the number of components: an even and an odd part of each Stokes component.
std::size_t components(const ShadowGrid& grid) {
    return 2 * grid.pairs_in().size();
}
// Returns the numbers per vertex: four sums per component, row and column.
std::size_t numbers_on_columns(const ShadowGrid& grid) {
    return 4 * components(grid) * grid.rows() * grid.columns();
}
// Returns the numbers per vertex: one per component, row and slot.
std::size_t numbers_on_slots(const ShadowGrid& grid) {
    return components(grid) * grid.rows() * grid.slots().begin[4];
}

// Returns rows times columns times Stokes components.
unsigned points(const ShadowGrid& grid) {
    return static_cast<unsigned>(grid.pairs_in().size() * grid.rows() * grid.columns());
}

// Returns the vertices of a chunk, few enough to keep the work space small. Work groups are many even if
// these vertices are few.
std::size_t chunk(const ShadowGrid& grid, std::size_t vertices) {
    const std::size_t groups = kWorkBytes / (numbers_on_columns(grid) * sizeof(float) * gl::kGroupOfVertices);
    return std::clamp<std::size_t>(groups, 1, gl::groups_for(vertices)) * gl::kGroupOfVertices;
}

}  // namespace

DeviceShadowGrid::DeviceShadowGrid(const std::shared_ptr<gl::Context>& context,
                                   const VisibilityProduct& shadows)
    : context_(context),
      gather_(gl::Program::compute(context, "shadow_gather.comp")),
      sums_(gl::Program::compute(context, "sums.comp")),
      multiply_(gl::Program::compute(context, "shadow_grid.comp")),
      store_(gl::Program::compute(context, "shadow_store.comp")),
      samples_(context, shadows),
      points_(points(*shadows.grid())),
      chunk_(chunk(*shadows.grid(), shadows.vertices().size())),
      orders_(over_orders(*shadows.grid())),
      degrees_(over_degrees(*shadows.grid())),
      columns_(over_columns(*shadows.grid())),
      rows_(over_rows(*shadows.grid(), shadows.layout().size())),
      column_numbers_(numbers_on_columns(*shadows.grid()) * chunk_),
      slot_numbers_(numbers_on_slots(*shadows.grid()) * chunk_) {
    const auto stride = static_cast<int>(chunk_);
    gather_.set("gathered_stride", stride);
    store_.set("gathered_stride", stride);
    gather_.set("gathered_step", static_cast<int>(column_numbers_));
    store_.set("gathered_step", static_cast<int>(column_numbers_));
    sums_.set("stride", stride);
    multiply_.set("stride", stride);
    multiply_.set("light_step", static_cast<int>(column_numbers_));
    multiply_.set("points", static_cast<int>(shadows.grid()->rows() * shadows.grid()->columns()));
    multiply_.set("samples_of_vertex", static_cast<int>(shadows.numbers_of_vertex()));
    multiply_.set("scale", shadows.unit() / kFixedOne);
}

DeviceShadowGrid::Sums DeviceShadowGrid::over_orders(const ShadowGrid& grid) const {
    std::vector<Sum> sums(numbers_on_slots(grid));
    std::vector<float> factors;
    auto to = sums.begin();
    for (const ShadowGrid::Pair& pair : grid.pairs_in()) {
        for (const ShadowGrid::Component& component : pair) {
            for (std::size_t row = 0; row < grid.rows(); ++row, to += grid.slots().begin[4]) {
                const std::size_t factor = factors.size() + row * component.harmonics;
                for (const ShadowGrid::Run& run : component.runs) {
                    to[run.slot] = {.first = index(component.begin + run.first),
                                    .terms = index(run.last - run.first),
                                    .factor = index(factor + run.first)};
                }
            }
            factors.insert(factors.end(), component.on_rows.begin(), component.on_rows.end());
        }
    }
    return {gl::storage(context_, sums), gl::storage(context_, factors), static_cast<unsigned>(sums.size())};
}

DeviceShadowGrid::Sums DeviceShadowGrid::over_degrees(const ShadowGrid& grid) const {
    const Slots& slots = grid.slots();
    std::vector<Sum> sums;
    for (std::size_t component = 0; component < components(grid); ++component) {
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t row = 0; row < grid.rows(); ++row) {
                for (std::size_t column = 0; column < grid.columns(); ++column) {
                    const std::size_t begin = (component * grid.rows() + row) * slots.begin[4];
                    sums.push_back({.first = index(begin + slots.begin[k]),
                                    .terms = index(slots.begin[k + 1] - slots.begin[k]),
                                    .factor = index(column * slots.begin[4] + slots.begin[k])});
                }
            }
        }
    }
    return {gl::storage(context_, sums), gl::storage(context_, slots.table),
            static_cast<unsigned>(sums.size())};
}

DeviceShadowGrid::Sums DeviceShadowGrid::over_columns(const ShadowGrid& grid) const {
    const Slots& slots = grid.slots();
    std::vector<Sum> sums;
    for (std::size_t component = 0; component < components(grid); ++component) {
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t slot = slots.begin[k]; slot < slots.begin[k + 1]; ++slot) {
                for (std::size_t row = 0; row < grid.rows(); ++row) {
                    const std::size_t begin = (4 * component + k) * grid.rows() + row;
                    sums.push_back({.first = index(begin * grid.columns()),
                                    .terms = index(grid.columns()),
                                    .factor = index(slot * grid.columns())});
                }
            }
        }
    }
    std::vector<float> factors;  // the table transposed
    for (std::size_t slot = 0; slot < slots.begin[4]; ++slot) {
        for (std::size_t column = 0; column < grid.columns(); ++column) {
            factors.push_back(slots.table[column * slots.begin[4] + slot]);
        }
    }
    return {gl::storage(context_, sums), gl::storage(context_, factors), static_cast<unsigned>(sums.size())};
}

// Harmonics of linear polarization have parts in s1 and in s2.
DeviceShadowGrid::Sums DeviceShadowGrid::over_rows(const ShadowGrid& grid, std::size_t size) const {
    std::vector<Sum> sums(size);
    std::vector<float> factors(2 * size * grid.rows());
    std::size_t begin = 0;  // first of a component's slots
    for (const ShadowGrid::Pair& pair : grid.pairs_out()) {
        for (const ShadowGrid::Component& component : pair) {
            for (const ShadowGrid::Run& run : component.runs) {
                for (std::size_t h = run.first; h < run.last; ++h) {
                    Sum& sum = sums[component.begin + h];
                    const std::int32_t from = index((begin + run.slot) * grid.rows());
                    std::size_t factor = 2 * (component.begin + h) * grid.rows();
                    if (sum.terms == 0) {
                        sum = {.first = from, .terms = index(grid.rows()), .factor = index(factor)};
                    } else {
                        sum.second = from;
                        factor += grid.rows();
                    }
                    for (std::size_t row = 0; row < grid.rows(); ++row) {
                        factors[factor + row] = component.on_rows[row * component.harmonics + h];
                    }
                }
            }
            begin += grid.slots().begin[4];
        }
    }
    return {gl::storage(context_, sums), gl::storage(context_, factors), static_cast<unsigned>(size)};
}

void DeviceShadowGrid::run(DeviceLight& light) {
    const std::size_t largest = std::max(column_numbers_, slot_numbers_) * sizeof(float);
    const int most = gl::channels_at_once(*context_, light.channels(),
                                          std::max(largest, light.channel_bytes()), kWorkBytes);
    gl::make_room(context_, on_columns_, static_cast<std::size_t>(most) * column_numbers_ * sizeof(float));
    gl::make_room(context_, on_slots_, static_cast<std::size_t>(most) * slot_numbers_ * sizeof(float));
    for (gl::Program* program : {&gather_, &store_}) {
        program->set("first_vertex", static_cast<int>(light.first()));
        program->set("stride", static_cast<int>(light.stride()));
        program->set("light_step", static_cast<int>(light.channel_step()));
    }
    samples_.for_chunks(
        light, chunk_,
        [&](std::size_t first, std::size_t last, std::size_t first_block, const gl::Buffer& samples) {
            for (gl::Program* program : {&gather_, &sums_, &multiply_, &store_})
                program->set("count", static_cast<int>(last - first));
            for (gl::Program* program : {&gather_, &multiply_, &store_})
                program->set("first", static_cast<int>(first));
            multiply_.set("first_block", static_cast<int>(first_block));
            gl::for_channels(light.channels(), most, [&](gl::ChannelGroup channels) {
                multiply(light, channels, gl::groups_for(last - first), samples);
            });
        });
}

void DeviceShadowGrid::multiply(DeviceLight& light, gl::ChannelGroup channels, unsigned groups,
                                const gl::Buffer& samples) {
    const auto count = static_cast<unsigned>(channels.count);
    const auto copy = [&](const gl::Program& program) {
        samples_.vertices().bind_storage(0);
        on_columns_->bind_storage(1);
        light.bind(2, channels);
        gl::dispatch(program, groups, static_cast<unsigned>(light.coefficients()), count);
    };
    const auto add = [&](const Sums& sums, bool from_columns) {
        sums.rows.bind_storage(0);
        sums.factors.bind_storage(1);
        (from_columns ? on_columns_ : on_slots_)->bind_storage(2);
        (from_columns ? on_slots_ : on_columns_)->bind_storage(3);
        sums_.set("from_step", static_cast<int>(from_columns ? column_numbers_ : slot_numbers_));
        sums_.set("to_step", static_cast<int>(from_columns ? slot_numbers_ : column_numbers_));
        gl::dispatch(sums_, groups, sums.count, count);
    };
    copy(gather_);
    add(orders_, true);
    add(degrees_, false);
    samples.bind_storage(0);
    on_columns_->bind_storage(1);
    gl::dispatch(multiply_, groups, points_, count);
    add(columns_, true);
    add(rows_, false);
    copy(store_);
}

}  // namespace nicol
