// SPDX-License-Identifier: MIT
// Fuzzer of the PNG, JPEG, BMP, TGA and Radiance HDR readers. Input without a known signature is read as TGA.
#include <unistd.h>

#include "image/bitmap.hpp"
#include "memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static nicol::fuzz::MemoryFile memory;
    static const std::filesystem::path file = [] {
        // TGA has no signature, so the reader recognizes it by the suffix.
        const std::filesystem::path link =
            std::filesystem::temp_directory_path() / ("nicol_fuzz_" + std::to_string(::getpid()) + ".tga");
        std::filesystem::remove(link);  // that of a killed process of the same number
        std::filesystem::create_symlink(memory.hold({}), link);
        std::atexit([] { std::filesystem::remove(file); });
        return link;
    }();
    memory.hold(nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const nicol::Bitmap bitmap = nicol::read_bitmap(file);
        nicol::unpolarized_image(bitmap).check("the image");
    });
    return 0;
}
