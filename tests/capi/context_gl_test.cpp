// SPDX-License-Identifier: MIT
// Tests of contexts and devices, and of the information that they report.
#include <thread>

#include "capi.hpp"

using namespace capi_test;

TEST_CASE("a context says what it is") {
    for (const nicol_backend backend : {NICOL_BACKEND_AUTOMATIC, NICOL_BACKEND_EGL, NICOL_BACKEND_OSMESA}) {
        const Owned context(make_context(backend));
        nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
        OK(nicol_context_get_info(context, &info));
        if (backend != NICOL_BACKEND_AUTOMATIC) CHECK(info.backend == backend);
        CHECK((info.backend == NICOL_BACKEND_EGL || info.backend == NICOL_BACKEND_OSMESA));
        CHECK(info.software <= 1);
        if (backend == NICOL_BACKEND_OSMESA) CHECK(info.software == 1);
        CHECK(info.threads == std::min(2U, std::thread::hardware_concurrency()));
        CHECK(info.max_framebuffer_size >= 4096);
        CHECK(info.memory_limit == NICOL_NO_LIMIT);
        CHECK(info.vertex_limit == 1 << 26);
        for (const char* text : {info.renderer, info.vendor, info.version}) {
            REQUIRE(text != nullptr);
            CHECK(text[0] != '\0');
        }
        CHECK(std::string(info.version).find('.') != std::string::npos);
        for (const std::string uuid : {info.device_uuid, info.driver_uuid}) {
            CHECK((uuid.empty() || uuid.size() == 32));
            CHECK(uuid.find_first_not_of("0123456789abcdef") == std::string::npos);
        }
        const Owned held(framebuffer_of(context, 64, 32, 1));
        nicol_context_info with_framebuffer = NICOL_CONTEXT_INFO_INIT;
        OK(nicol_context_get_info(context, &with_framebuffer));
        // Stokes vectors and depth, as floats.
        CHECK(with_framebuffer.device_bytes == info.device_bytes + std::uint64_t{64} * 32 * (4 + 1) * 4);
    }
}

TEST_CASE("a context by default uses a thread a core") {
    Owned<nicol_context> context;
    OK(nicol_context_create(nullptr, &context));
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    OK(nicol_context_get_info(context, &info));
    CHECK(info.threads == std::thread::hardware_concurrency());
    CHECK(info.backend != NICOL_BACKEND_AUTOMATIC);
}

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
        REQUIRE(info.pci_address != nullptr);
        if (info.software != 0) CHECK(std::string(info.pci_address) == "");
        nicol_device_info again = NICOL_DEVICE_INFO_INIT;
        OK(nicol_device_get_info(device, &again));
        CHECK(again.name == info.name);  // strings are stored once and not copied again

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
