// SPDX-License-Identifier: MIT
// Fuzzer of the OpenEXR reader.
#include "image/stokes_image.hpp"
#include "memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::filesystem::path file = "input.exr";
    const nicol::LoadLimits limits = nicol::fuzz::in_memory(file, nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const nicol::StokesImage image = nicol::read_exr(file, {}, limits);
        image.check("the image");
    });
    return 0;
}
