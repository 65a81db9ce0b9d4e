// SPDX-License-Identifier: MIT
#include "image/jpeg.hpp"

#include <turbojpeg.h>

#include <cstdint>
#include <memory>
#include <new>
#include <string>

#include "files/file_error.hpp"

namespace nicol {
namespace {

struct Destroy {
    void operator()(void* decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<void, Destroy>;

Decoder make_decoder() {
    Decoder decoder(tjInitDecompress());
    if (decoder == nullptr) throw std::bad_alloc();
    return decoder;
}

[[noreturn]] void fail(const std::filesystem::path& file, const Decoder& decoder) {
    const std::string reason = tjGetErrorStr2(decoder.get());
    // TurboJPEG reports a lack of memory only in this text.
    for (const char* shortage : {"Insufficient memory", "Memory allocation failure"})
        if (reason.find(shortage) != std::string::npos) throw std::bad_alloc();
    invalid_file(file, "is damaged or truncated (" + reason + ")");
}

/// Limit of scans times pixels, because each scan passes over all pixels and decoding cannot be interrupted.
constexpr std::uint64_t kMaxScannedPixels = std::uint64_t{1} << 32;

/// Counts the scans by their marker, which appears nowhere else in coded pixels.
std::uint64_t count_scans(std::string_view bytes) {
    constexpr std::string_view marker = "\xff\xda";
    std::uint64_t scans = 0;
    for (std::size_t at = bytes.find(marker); at != std::string_view::npos;
         at = bytes.find(marker, at + marker.size()))
        ++scans;
    return scans;
}

const unsigned char* data_of(std::string_view bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

}  // namespace

bool is_jpeg(std::string_view bytes) {
    return bytes.starts_with("\xff\xd8\xff");
}

void read_jpeg_header(const std::filesystem::path& file, std::string_view bytes, Bitmap& out) {
    const Decoder decoder = make_decoder();
    int subsampling = 0;
    int colours = 0;
    if (tjDecompressHeader3(decoder.get(), data_of(bytes), static_cast<unsigned long>(bytes.size()),
                            &out.width, &out.height, &subsampling, &colours) != 0)
        fail(file, decoder);
    out.channels = colours == TJCS_GRAY ? 1 : 3;
}

void read_jpeg_pixels(const std::filesystem::path& file, std::string_view bytes, Bitmap& out) {
    const std::uint64_t scans = count_scans(bytes);
    if (scans * static_cast<std::uint64_t>(out.width) * static_cast<std::uint64_t>(out.height) >
        kMaxScannedPixels)
        unsupported_file(file, std::to_string(scans) + " scans of " + std::to_string(out.width) + " x " +
                                   std::to_string(out.height) + " pixels; their product may be " +
                                   std::to_string(kMaxScannedPixels));
    const Decoder decoder = make_decoder();
    out.codes.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) *
                     static_cast<std::size_t>(out.channels));
    const int format = out.channels == 1 ? TJPF_GRAY : TJPF_RGB;
    constexpr int flags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
    if (tjDecompress2(decoder.get(), data_of(bytes), static_cast<unsigned long>(bytes.size()),
                      out.codes.data(), out.width, 0, out.height, format, flags) != 0)
        fail(file, decoder);
}

}  // namespace nicol
