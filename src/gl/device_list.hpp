// SPDX-License-Identifier: MIT
// The devices on which a context can be made.
#pragma once

#include <string>
#include <vector>

namespace nicol::gl {

/// One of EGL's device list, in which ContextRequest::device counts from 0.
struct Device {
    std::string name;    ///< of the renderer if EGL has it, else the device file: "/dev/dri/card0"
    std::string vendor;  ///< or empty
    std::string file;    ///< of the kernel's, such as /dev/dri/renderD128; or empty
    bool software;       ///< the processor rasterises
};

/// Queries EGL, without making a context. Empty if there is no EGL or it lists nothing.
[[nodiscard]] std::vector<Device> list_devices();

}  // namespace nicol::gl
