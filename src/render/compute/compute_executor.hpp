// SPDX-License-Identifier: MIT
// relight and shade as compute shaders: what the methods prepare is copied to the device, where the results
// stay.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "render/compute/device_dense.hpp"
#include "render/compute/device_factored.hpp"
#include "render/compute/device_high_orders.hpp"
#include "render/compute/device_shade.hpp"

namespace nicol {

class ComputeExecutor {
public:
    /// Why a context cannot; empty where it can.
    [[nodiscard]] static std::string obstacle(const gl::Context& context);

    /// Stokes vectors go into `buffers`, which must outlive the object.
    ComputeExecutor(std::shared_ptr<gl::Context> context, VertexBuffers& buffers);

    /// relight and shade of every vertex, as far as changes make it necessary, of what the method, and the
    /// high orders unless they are null, have prepared. Adds its times and counts to `statistics`.
    void run(FactoredMethod& method, const HighOrderTransfer* high_orders, const TransferInput& input,
             const DistantLight& light, const Viewpoint& view, bool physical, Workers& workers,
             Progress& progress, Statistics& statistics);
    void run(DenseMethod& method, const HighOrderTransfer* high_orders, const TransferInput& input,
             const DistantLight& light, const Viewpoint& view, bool physical, Workers& workers,
             Progress& progress, Statistics& statistics);

private:
    std::uint64_t make_physical(const TransferInput& input);

    template <class Device, class Method>
    void run_on(Device& device, Method& method, const HighOrderTransfer* high_orders,
                const TransferInput& input, const DistantLight& light, const Viewpoint& view, bool physical,
                Workers& workers, Progress& progress, Statistics& statistics);

    std::shared_ptr<gl::Context> context_;
    VertexBuffers& buffers_;
    std::optional<DeviceShade> shade_;
    DeviceFactored factored_;
    DeviceDense dense_;
    DeviceHighOrders high_orders_;
    std::optional<gl::Program> physical_;
};

}  // namespace nicol
