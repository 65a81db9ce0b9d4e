// SPDX-License-Identifier: MIT
// Small files that decompress to large ones.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

/// Returns `count` zero bytes as a zlib stream.
inline std::string deflated_zeros(std::uint64_t count) {
    z_stream stream{};
    deflateInit(&stream, 9);
    const std::vector<unsigned char> zeros(1 << 20);
    std::vector<unsigned char> packed(1 << 20);
    std::string out;
    const auto run = [&](int flush) {
        do {
            stream.next_out = packed.data();
            stream.avail_out = static_cast<uInt>(packed.size());
            deflate(&stream, flush);
            out.append(reinterpret_cast<const char*>(packed.data()), packed.size() - stream.avail_out);
        } while (stream.avail_out == 0);
    };
    while (count > 0) {
        const std::uint64_t some = count < zeros.size() ? count : zeros.size();
        stream.next_in = const_cast<unsigned char*>(zeros.data());
        stream.avail_in = static_cast<uInt>(some);
        run(Z_NO_FLUSH);
        count -= some;
    }
    run(Z_FINISH);
    deflateEnd(&stream);
    return out;
}

/// Returns a black grey-scale PNG of `bits` per pixel whose data inflate to `inflated` bytes.
inline std::string black_png(std::uint32_t width, std::uint32_t height, char bits, std::uint64_t inflated) {
    const auto number = [](std::uint64_t value) {
        std::string out;
        for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(value >> shift);
        return out;
    };
    const auto chunk = [&](const std::string& name, const std::string& content) {
        const std::string checked = name + content;
        return number(content.size()) + checked +
               number(crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                            static_cast<uInt>(checked.size())));
    };
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", number(width) + number(height) + std::string{bits, 0, 0, 0, 0}) +
           chunk("IDAT", deflated_zeros(inflated)) + chunk("IEND", "");
}
