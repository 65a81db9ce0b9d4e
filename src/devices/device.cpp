// SPDX-License-Identifier: MIT
#include "devices/device.hpp"

#include <array>

#include "devices/cpu/cpu_executor.hpp"
#include "devices/gl/gl_executor.hpp"
#include "error.hpp"

namespace nicol {
namespace {

/// All devices, the best first. Every context can have the last.
constexpr std::array kDevices{&kGlDevice, &kCpuDevice};

}  // namespace

const Device& device_for(Executor wanted, const gl::Context& context) {
    for (const Device* const device : kDevices) {
        if (wanted == Executor::automatic) {
            if (device->preferred(context) && device->obstacle(context).empty()) return *device;
        } else if (wanted == device->executor) {
            const std::string obstacle = device->obstacle(context);
            if (obstacle.empty()) return *device;
            throw Error(ErrorCode::unsupported,
                        std::string("the executor cannot be ") + device->name + ": " + obstacle);
        }
    }
    return *kDevices.back();
}

}  // namespace nicol
