// SPDX-License-Identifier: MIT
// Fuzzer of the OpenEXR reader.
#include "image/stokes_image.hpp"
#include "memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static nicol::fuzz::MemoryFile memory;
    const std::filesystem::path& file = memory.hold(nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const nicol::StokesImage image = nicol::read_exr(file);
        image.check("the image");
    });
    return 0;
}
