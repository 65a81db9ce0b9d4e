// SPDX-License-Identifier: MIT
// Devices on which a context can be created.
#include <mutex>
#include <set>
#include <vector>

#include "boundary.hpp"
#include "gl/device_list.hpp"
#include "gl/pci_address.hpp"
#include "initialiser.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

// Returns a copy that lives as long as the library, one for all equal texts. The set is never destroyed,
// because callers keep the strings.
const char* kept(const std::string& text) {
    static std::mutex mutex;
    static auto* texts = new std::set<std::string>;
    const std::lock_guard lock(mutex);
    return texts->insert(text).first->c_str();
}

}  // namespace

nicol_result nicol_device_count(uint32_t* count) {
    return guarded([&] {
        require(count, "count");
        *count = static_cast<uint32_t>(gl::list_devices().size());
    });
}

nicol_result nicol_device_get_info(uint32_t device, nicol_device_info* info) {
    return guarded([&] {
        const std::vector<gl::Device> devices = gl::list_devices();
        if (device < 1 || device > devices.size()) {
            refuse("device is " + std::to_string(device) + "; there are " + std::to_string(devices.size()) +
                   ", counted from 1");
        }
        const gl::Device& found = devices[device - 1];
        nicol_device_info out = NICOL_DEVICE_INFO_INIT;
        out.software = found.software ? 1 : 0;
        out.name = kept(found.name);
        out.vendor = kept(found.vendor);
        out.file = kept(found.file);
        out.pci_address = kept(gl::pci_address(found.file));
        write_struct(info, out, "info");
    });
}

NICOL_INITIALISER(nicol_device_info, NICOL_DEVICE_INFO_INIT)
