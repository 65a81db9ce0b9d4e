// SPDX-License-Identifier: MIT
// Address of a device on the PCI bus, by which other interfaces list the same device.
#pragma once

#include <filesystem>
#include <string>

namespace nicol::gl {

/// Returns the address of a device file's device, such as "0000:65:00.0", or "" if the device is on no PCI
/// bus. `system` is the folder in which the kernel lists devices.
[[nodiscard]] std::string pci_address(const std::filesystem::path& device_file,
                                      const std::filesystem::path& system = "/sys");

}  // namespace nicol::gl
