// SPDX-License-Identifier: MIT
#include "digest.hpp"

#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <stdexcept>

Digest sha256(std::string_view text) {
    Digest digest{};
    unsigned length = 0;
    if (EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1 ||
        length != digest.size())
        throw std::runtime_error("SHA-256 is not to be had from OpenSSL");
    return digest;
}

Digest hmac_sha256(std::string_view key, std::string_view text) {
    Digest digest{};
    unsigned length = 0;
    if (HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
             reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(),
             &length) == nullptr ||
        length != digest.size())
        throw std::runtime_error("HMAC-SHA-256 is not to be had from OpenSSL");
    return digest;
}

std::string hex(const Digest& digest) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : digest) {
        text += digits[byte >> 4u];
        text += digits[byte & 15u];
    }
    return text;
}

std::string entity_tag(std::string_view text) {
    // 128 bits suffice against accidental collisions; deliberate ones are harmless.
    return '"' + hex(sha256(text)).substr(0, 32) + '"';
}

bool matches(std::string_view if_none_match, std::string_view tag) {
    // Another server's tag may contain commas within its quotes, but no tag of this service does. A search
    // for the tag with its quotes therefore finds only whole elements of the list.
    const std::size_t first = if_none_match.find_first_not_of(" \t");
    if (first == std::string_view::npos) return false;
    const std::size_t last = if_none_match.find_last_not_of(" \t");
    if (if_none_match.substr(first, last - first + 1) == "*") return true;
    return if_none_match.find(tag) != std::string_view::npos;
}
