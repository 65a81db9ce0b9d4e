// SPDX-License-Identifier: MIT
// The list of devices, and contexts on them.
#include "capi.hpp"

using namespace capi_test;

TEST_CASE("every device of the list has a name and opens, or says why not") {
    std::uint32_t count = 0;
    OK(nicol_device_count(&count));
    std::size_t opened = 0;
    for (std::uint32_t device = 1; device <= count; ++device) {
        CAPTURE(device);
        nicol_device_info info = NICOL_DEVICE_INFO_INIT;
        OK(nicol_device_get_info(device, &info));
        CHECK(info.software <= 1);
        CHECK(std::string(info.name) != "");
        REQUIRE(info.vendor != nullptr);
        REQUIRE(info.file != nullptr);
        nicol_device_info again = NICOL_DEVICE_INFO_INIT;
        OK(nicol_device_get_info(device, &again));
        CHECK(again.name == info.name);  // strings are kept, not copied once more

        nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
        options.device = device;
        Owned<nicol_context> context;
        const nicol_result result = nicol_context_create(&options, &context);
        if (result != NICOL_OK) {
            CHECK(result == NICOL_ERROR_NO_BACKEND);
            continue;
        }
        ++opened;
        nicol_context_info made = NICOL_CONTEXT_INFO_INIT;
        OK(nicol_context_get_info(context, &made));
        CHECK(made.software == info.software);
        CHECK(made.backend == NICOL_BACKEND_EGL);
    }
    if (count > 0) CHECK(opened > 0);
}

TEST_CASE("devices that are not there are refused, in the list and in a context") {
    std::uint32_t count = 0;
    OK(nicol_device_count(&count));
    nicol_device_info info = NICOL_DEVICE_INFO_INIT;
    info.software = 7;
    for (const std::uint32_t bad : {0U, count + 1, UINT32_MAX}) {
        FAILS(nicol_device_get_info(bad, &info), NICOL_ERROR_INVALID_ARGUMENT, std::to_string(bad));
        CHECK(info.software == 7);
    }
    if (count == 0) return;
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.device = count + 1;
    nicol_context context = marker<nicol_context>();
    FAILS(nicol_context_create(&options, &context), NICOL_ERROR_INVALID_ARGUMENT, "device");
    CHECK(context == marker<nicol_context>());
}
