// SPDX-License-Identifier: MIT
#include "signature.hpp"

#include <openssl/crypto.h>

#include <charconv>
#include <fstream>

#include "common/failure.hpp"
#include "digest.hpp"
#include "problem.hpp"
#include "query.hpp"

namespace {

constexpr std::size_t kMinKeyBytes = 16;

[[noreturn]] void refuse(const std::string& parameter, const std::string& detail, const std::string& range) {
    throw Refusal({.status = 403, .detail = detail, .parameter = parameter, .range = range});
}

std::string unhex(std::string_view text) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
        unsigned value = 0;
        const auto [end, error] = std::from_chars(text.data() + i, text.data() + i + 2, value, 16);
        if (error != std::errc() || end != text.data() + i + 2) return {};
        bytes += static_cast<char>(value);
    }
    return bytes;
}

}  // namespace

std::vector<std::string> read_keys(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw Failure("--keys: " + path.string() + ": cannot be read");
    std::vector<std::string> keys;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty() || line.front() == '#') continue;
        const std::string key = line.size() % 2 == 0 ? unhex(line) : std::string();
        if (key.size() < kMinKeyBytes)
            throw Failure("--keys: " + path.string() + ": line " + std::to_string(number) + " is no key of " +
                          std::to_string(kMinKeyBytes) + " or more bytes in hexadecimal");
        keys.push_back(key);
    }
    if (keys.empty()) throw Failure("--keys: " + path.string() + ": holds no key");
    return keys;
}

void check_signature(std::string_view target, const std::vector<std::string>& keys, std::int64_t now) {
    const std::string range = "HMAC-SHA-256 of what precedes it, 64 hexadecimal digits, the last parameter";
    constexpr std::string_view name = "sig=";
    const std::size_t digits = 2 * Digest().size();
    const std::size_t length = 1 + name.size() + digits;
    if (target.size() <= length) refuse("sig", "The request must be signed.", range);
    const std::string_view text = target.substr(0, target.size() - length);
    const std::string_view tail = target.substr(text.size());
    const char separator = text.find('?') == std::string_view::npos ? '?' : '&';
    if (tail.front() != separator || tail.substr(1, name.size()) != name)
        refuse("sig", "The request must be signed.", range);
    const std::string_view given = tail.substr(1 + name.size());
    bool right = false;
    for (const std::string& key : keys) {
        const std::string wanted = hex(hmac_sha256(key, text));
        right |= CRYPTO_memcmp(wanted.data(), given.data(), digits) == 0;
    }
    if (!right) refuse("sig", "The signature does not fit the request.", range);

    const Target parsed = parse_target(text);
    const std::string* expires = parsed.find("expires");
    if (expires == nullptr) return;
    std::int64_t until = 0;
    const auto [end, error] = std::from_chars(expires->data(), expires->data() + expires->size(), until);
    if (error != std::errc() || end != expires->data() + expires->size() || until < now)
        refuse("expires", "The signed request has expired.", "seconds since 1970, later than now");
}

std::string signed_target(std::string_view target, std::string_view key) {
    std::string result(target);
    result += target.find('?') == std::string_view::npos ? '?' : '&';
    return result + "sig=" + hex(hmac_sha256(key, target));
}
