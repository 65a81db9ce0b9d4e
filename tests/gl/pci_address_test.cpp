// SPDX-License-Identifier: MIT
// Tests of addresses on the PCI bus, in folders that look like the kernel's.
#include "gl/pci_address.hpp"

#include <doctest/doctest.h>

#include "temporary_folder.hpp"

using nicol::gl::pci_address;

TEST_CASE("a device file has the address of its device if the bus is PCI") {
    // The number of this character device, which every system has.
    const std::filesystem::path file = "/dev/null", number = "dev/char/1:3";
    for (const auto& [bus, address] : {std::pair("pci", "0000:65:00.0"), std::pair("platform", "")}) {
        CAPTURE(bus);
        const TemporaryFolder folder;
        const std::filesystem::path device = folder.path() / "devices/pci0000:64/0000:65:00.0";
        std::filesystem::create_directories(device);
        std::filesystem::create_directories(folder.path() / number);
        std::filesystem::create_symlink(folder.path() / "bus" / bus, device / "subsystem");
        CHECK(pci_address(file, folder.path()).empty());
        std::filesystem::create_symlink(device, folder.path() / number / "device");
        CHECK(pci_address(file, folder.path()) == address);
    }
}

TEST_CASE("what is no device file has no address") {
    const TemporaryFolder folder;
    for (const char* file : {"", "/nonexistent", "/", "/etc/passwd"})
        CHECK(pci_address(file, folder.path()).empty());
}
