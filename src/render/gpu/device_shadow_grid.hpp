// SPDX-License-Identifier: MIT
// relight, second half, on the device: light times what its vertices see, on a grid.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "gl/program.hpp"
#include "render/gpu/device_light.hpp"
#include "render/gpu/device_shadow_numbers.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

/// ShadowGrid in passes over all vertices of a chunk, each from the one work space into the other:
///   split light      [harmonic]
///   sums over l      [component][row][slot]
///   sums over m      [component][cosines of even, odd m, sines of even, odd m][row][column]
///     ... turned into samples, times visibility, and folded back in place
///   sums over phi    [component][slot][row]
///   sums over rows   [harmonic]
/// A component is the even or odd part of a Stokes component; rows, columns and slots are ShadowGrid's.
class DeviceShadowGrid {
public:
    /// The same samples as the host's.
    DeviceShadowGrid(const std::shared_ptr<gl::Context>& context, const VisibilityProduct::Grid& grid);

    /// light = V light for its vertices that do not see all.
    void run(DeviceLight& light);

private:
    // Numbers that are each a sum of products of consecutive others with fixed factors.
    struct Sums {
        gl::Buffer rows;
        gl::Buffer factors;
        unsigned count;
    };

    [[nodiscard]] Sums over_orders(const ShadowGrid& grid) const;
    [[nodiscard]] Sums over_degrees(const ShadowGrid& grid) const;
    [[nodiscard]] Sums over_columns(const ShadowGrid& grid) const;
    [[nodiscard]] Sums over_rows(const ShadowGrid& grid, std::size_t size) const;

    std::shared_ptr<gl::Context> context_;
    gl::Program split_;
    gl::Program sums_;
    gl::Program multiply_;
    gl::Program join_;
    DeviceShadowNumbers samples_;
    unsigned size_;      // of split light
    unsigned points_;    // rows times columns times Stokes components
    std::size_t chunk_;  // vertices
    gl::Buffer split_terms_;
    gl::Buffer join_terms_;
    Sums orders_;
    Sums degrees_;
    Sums columns_;
    Sums rows_;
    gl::Buffer on_columns_;  // both work spaces: [number][shadowed vertex]
    gl::Buffer on_slots_;
};

}  // namespace nicol
