// SPDX-License-Identifier: MIT
// Writing of images to PNG files.
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <string>

#include "error.hpp"
#include "files/atomic_file.hpp"
#include "image/png.hpp"

namespace nicol {
namespace {

std::size_t row_bytes(const PngImage& image) {
    return static_cast<std::size_t>(image.width) * (image.grey ? 1 : 3) * (image.deep ? 2 : 1);
}

void check(const PngImage& image) {
    if (image.width < 1 || image.height < 1 || image.width > kMaxImageSide || image.height > kMaxImageSide ||
        image.bytes.size() != row_bytes(image) * static_cast<std::size_t>(image.height))
        throw Error(ErrorCode::invalid_argument,
                    "write_png: image of " + std::to_string(image.width) + " x " +
                        std::to_string(image.height) + " with " + std::to_string(image.bytes.size()) +
                        " bytes; it needs height rows of " + std::to_string(row_bytes(image)) +
                        ", sides of 1 to " + std::to_string(kMaxImageSide));
    for (const auto& [keyword, text] : image.text) {
        const bool fit =
            !keyword.empty() && keyword.size() <= 79 && keyword.front() != ' ' && keyword.back() != ' ' &&
            std::all_of(keyword.begin(), keyword.end(), [](char c) { return c >= 32 && c < 127; });
        if (!fit || text.find('\0') != std::string::npos)
            throw Error(ErrorCode::invalid_argument,
                        "write_png: keyword \"" + keyword +
                            "\" must be 1 to 79 printable characters, and its text free of zero bytes");
    }
}

/// Writes all rows. libpng leaves by longjmp, which must not skip destructors, so this function has only
/// plain values. Returns false on failure.
bool write_rows(png_structp png, png_infop info, std::FILE* file, const PngImage& image, png_text* text,
                int text_count) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng has nothing else
    png_init_io(png, file);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 image.deep ? 16 : 8, image.grey ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (image.noisy) {
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
        png_set_compression_strategy(png, Z_RLE);
    }
    if (image.srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_RELATIVE);
    png_set_text(png, info, text, text_count);
    png_write_info(png, info);
    const png_size_t row = row_bytes(image);
    for (int y = 0; y < image.height; ++y)
        png_write_row(png, image.bytes.data() + static_cast<png_size_t>(y) * row);
    png_write_end(png, nullptr);
    return true;
}

}  // namespace

void write_png(const std::filesystem::path& path, const PngImage& image) {
    AtomicFile file(path);
    encode_png(file.handle(), path.string(), image);
    file.commit();
}

void encode_png(std::FILE* file, const std::string& name, const PngImage& image) {
    check(image);
    std::vector<std::pair<std::string, std::string>> entries(image.text.begin(), image.text.end());
    entries.emplace_back("Software", "Nicol " NICOL_VERSION_STRING);
    std::vector<png_text> text(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        text[i].compression = PNG_TEXT_COMPRESSION_NONE;
        text[i].key = entries[i].first.data();
        text[i].text = entries[i].second.data();
        text[i].text_length = entries[i].second.size();
    }

    const auto quiet = [](png_structp, png_const_charp) {};
    // libpng prints errors if the error function is null. An error function must not return, but may longjmp.
    const auto leave = [](png_structp png, png_const_charp) { png_longjmp(png, 1); };
    bool memory_short = false;
    const auto allocate = [](png_structp png, png_alloc_size_t size) {
        void* const block = std::malloc(size);
        if (block == nullptr) *static_cast<bool*>(png_get_mem_ptr(png)) = true;
        return block;
    };
    const auto release = [](png_structp, png_voidp block) { std::free(block); };
    png_structp png = png_create_write_struct_2(PNG_LIBPNG_VER_STRING, nullptr, leave, quiet, &memory_short,
                                                allocate, release);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    const bool written =
        info != nullptr && write_rows(png, info, file, image, text.data(), static_cast<int>(text.size()));
    png_destroy_write_struct(&png, &info);
    if (memory_short) throw std::bad_alloc();
    if (!written)
        throw Error(ErrorCode::write_failed, name + ": cannot be written as PNG; the disk may be full");
}

}  // namespace nicol
