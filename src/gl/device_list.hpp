// SPDX-License-Identifier: MIT
// List of the devices on which a context can be made.
#pragma once

#include <string>
#include <vector>

namespace nicol::gl {

/// One device of EGL's list; ContextRequest::device is its position in the list, counted from 0.
struct Device {
    std::string name;    ///< name of the renderer if EGL has it, else the device file: "/dev/dri/card0"
    std::string vendor;  ///< name of the vendor, or empty
    std::string file;    ///< device file of the kernel, such as /dev/dri/renderD128; or empty
    bool software;       ///< whether the processor rasterises
};

/// Returns EGL's devices without making a context. Empty if there is no EGL or it lists nothing.
[[nodiscard]] std::vector<Device> list_devices();

}  // namespace nicol::gl
