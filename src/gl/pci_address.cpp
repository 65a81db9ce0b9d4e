// SPDX-License-Identifier: MIT
#include "gl/pci_address.hpp"

#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace nicol::gl {

std::string pci_address(const std::filesystem::path& device_file, const std::filesystem::path& system) {
    struct stat status {};
    if (device_file.empty() || ::stat(device_file.c_str(), &status) != 0 || !S_ISCHR(status.st_mode))
        return {};
    const std::string number =
        std::to_string(major(status.st_rdev)) + ":" + std::to_string(minor(status.st_rdev));
    const std::filesystem::path link = system / "dev" / "char" / number / "device";
    std::error_code failure;
    // The bus of a device that is not a PCI device, such as one on a system-on-chip, has another name.
    const std::filesystem::path bus = std::filesystem::read_symlink(link / "subsystem", failure);
    if (failure || bus.filename() != "pci") return {};
    const std::filesystem::path device = std::filesystem::read_symlink(link, failure);
    return failure ? std::string() : device.filename().string();
}

}  // namespace nicol::gl
