// SPDX-License-Identifier: MIT
// A fast, non-cryptographic hash of content.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace nicol {

/// Hash of 128 bits over a sequence of bytes, independent of how the sequence is split into pieces.
class ContentHash {
public:
    ContentHash& add(std::span<const unsigned char> bytes) {
        std::size_t at = 0;
        while (at < bytes.size() && pending_ != 0) take(bytes[at++]);
        for (; bytes.size() - at >= 8; at += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at, 8);
            mix(word);
        }
        while (at < bytes.size()) take(bytes[at++]);
        length_ += bytes.size();
        return *this;
    }
    ContentHash& add(const std::string& text) {
        return add({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }

    /// Returns the hash as 32 hexadecimal digits.
    [[nodiscard]] std::string text() const {
        ContentHash last = *this;
        last.mix(word_);
        last.mix(length_);
        last.mix(0);
        std::string out;
        for (const std::uint64_t half : {last.a_, last.b_})
            for (int shift = 60; shift >= 0; shift -= 4) out += "0123456789abcdef"[half >> shift & 15];
        return out;
    }

private:
    void take(unsigned char byte) {
        word_ |= std::uint64_t{byte} << (8 * pending_);
        if (++pending_ < 8) return;
        mix(word_);
        word_ = 0;
        pending_ = 0;
    }
    // Mixes a word into two lanes with different odd multipliers (from the golden ratio and from sqrt 2).
    // Shifts move high bits down, which multiplication does not.
    void mix(std::uint64_t word) {
        a_ = (a_ ^ word) * 0x9e3779b97f4a7c15;
        a_ ^= a_ >> 32;
        b_ = (b_ + word) * 0xb504f333f9de6485;
        b_ ^= b_ >> 29;
    }

    std::uint64_t a_ = 0x243f6a8885a308d3;
    std::uint64_t b_ = 0x13198a2e03707344;
    std::uint64_t word_ = 0;
    std::uint64_t length_ = 0;
    int pending_ = 0;
};

}  // namespace nicol
