// SPDX-License-Identifier: MIT
// The devices that a context can be asked for.
#pragma once

#include <string>
#include <vector>

namespace nicol::gl {

/// One of EGL's device list, in which ContextRequest::device counts from 0.
struct Device {
    std::string name;    ///< the renderer's as far as EGL tells, else what opens it: "/dev/dri/card0"
    std::string vendor;  ///< or empty
    std::string file;    ///< of the kernel's, such as /dev/dri/renderD128; or empty
    bool software;       ///< the processor rasterises
};

/// Asks EGL now, without making a context. Empty where there is no EGL or it lists nothing.
[[nodiscard]] std::vector<Device> list_devices();

}  // namespace nicol::gl
