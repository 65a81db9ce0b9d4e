// SPDX-License-Identifier: MIT
// Fuzzer of the PNG, JPEG, BMP, TGA and Radiance HDR readers. Input without a known signature is read as TGA.
#include <unistd.h>

#include "image/bitmap.hpp"
#include "memory_file.hpp"

namespace {

/// A link that ends on .tga, for TGA has no signature and the reader recognizes it by the suffix.
class Link {
public:
    explicit Link(const std::filesystem::path& target) {
        std::filesystem::remove(path_);  // that of a killed process of the same number
        std::filesystem::create_symlink(target, path_);
    }
    ~Link() { std::filesystem::remove(path_); }
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("nicol_fuzz_" + std::to_string(::getpid()) + ".tga");
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static nicol::fuzz::MemoryFile memory;
    static const Link link(memory.hold({}));
    memory.hold(nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(link.path(), [&] {
        const nicol::Bitmap bitmap = nicol::read_bitmap(link.path());
        nicol::unpolarized_image(bitmap).check("the image");
    });
    return 0;
}
