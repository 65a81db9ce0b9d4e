// SPDX-License-Identifier: MIT
// relight and shade as compute shaders: what the methods prepare is copied to the device, where the results
// stay.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "render/gpu/device_dense.hpp"
#include "render/gpu/device_factored.hpp"
#include "render/gpu/device_high_orders.hpp"
#include "render/gpu/device_shade.hpp"

namespace nicol {

class ComputeExecutor {
public:
    /// Why a context cannot; empty where it can.
    [[nodiscard]] static std::string obstacle(const gl::Context& context);

    /// Stokes vectors go into `buffers`; both must outlive the object.
    ComputeExecutor(std::shared_ptr<gl::Context> context, VertexBuffers& buffers,
                    HighOrderTextures& textures);

    /// Of shade, what need not be.
    struct Extras {
        const HighOrderTransfer* high_orders = nullptr;
        bool at_pixels = false;  ///< draw adds the high orders: only the fractions of them are computed
        bool physical = false;   ///< vertices are moved into the physical range
    };

    /// relight and shade of every vertex, as far as changes make it necessary, of what the method and the
    /// high orders have prepared. Adds its times and counts to `statistics`.
    void run(FactoredMethod& method, const Extras& extras, const TransferInput& input,
             const DistantLight& light, const Viewpoint& view, Progress& progress, Statistics& statistics);
    void run(DenseMethod& method, const Extras& extras, const TransferInput& input, const DistantLight& light,
             const Viewpoint& view, Progress& progress, Statistics& statistics);

private:
    std::uint64_t make_physical(const TransferInput& input);

    template <class Device, class Method>
    void run_on(Device& device, Method& method, const Extras& extras, const TransferInput& input,
                const DistantLight& light, const Viewpoint& view, Progress& progress, Statistics& statistics);

    std::shared_ptr<gl::Context> context_;
    VertexBuffers& buffers_;
    std::optional<DeviceShade> shade_;
    DeviceFactored factored_;
    DeviceDense dense_;
    DeviceHighOrders high_orders_;
    std::optional<gl::Program> physical_;
};

}  // namespace nicol
