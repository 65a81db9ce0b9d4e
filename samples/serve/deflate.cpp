// SPDX-License-Identifier: MIT
#include "deflate.hpp"

#include <libdeflate.h>

#include <memory>

#include "common/failure.hpp"

namespace {

/// Returns zlib's level. Level 1 makes rendered images a tenth larger than the default level, in a twelfth of
/// its time, and rounded images a seventh larger.
int level(Deflate matters) {
    return matters == Deflate::speed ? 1 : 6;
}

}  // namespace

std::string deflated(std::string_view data, Deflate matters) {
    struct Free {
        void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
    };
    const std::unique_ptr<libdeflate_compressor, Free> compressor(
        libdeflate_alloc_compressor(level(matters)));
    if (!compressor) throw Failure("out of memory");
    std::string result(libdeflate_zlib_compress_bound(compressor.get(), data.size()), '\0');
    result.resize(
        libdeflate_zlib_compress(compressor.get(), data.data(), data.size(), result.data(), result.size()));
    return result;
}
