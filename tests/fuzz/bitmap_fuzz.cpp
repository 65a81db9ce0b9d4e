// SPDX-License-Identifier: MIT
// Fuzzer of the PNG, JPEG, BMP, TGA and Radiance HDR readers. Input without a known signature is read as TGA.
#include "image/bitmap.hpp"
#include "memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    // TGA has no signature, so the reader recognizes it by the suffix.
    const std::filesystem::path file = "input.tga";
    const nicol::LoadLimits limits = nicol::fuzz::in_memory(file, nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const nicol::Bitmap bitmap = nicol::read_bitmap(file, limits);
        nicol::unpolarized_image(bitmap).check("the image");
    });
    return 0;
}
