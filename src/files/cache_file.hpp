// SPDX-License-Identifier: MIT
// Files that save computing something again: trusted only where everything fits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

/// What a file must say about itself: magic, format version and a key that names what the content was made
/// from, in that order. The content follows and, at the end, a hash of all before it.
class CacheFile {
public:
    enum class State {
        complete,  ///< read
        missing,   ///< there is no such file
        unfit,     ///< there is one, but not this
    };
    struct Outcome {
        State state = State::missing;
        std::string reason;  ///< of unfit, a predicate: "is damaged"
    };

    /// The file in `folder` is named after a hash of key and version, with `suffix`.
    CacheFile(const std::filesystem::path& folder, std::string_view magic, std::uint32_t version,
              std::string_view key, std::string_view suffix);

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

    /// Fills the parts, one after the other. Unless the result is complete their content means nothing.
    [[nodiscard]] Outcome read(std::span<const std::span<unsigned char>> parts) const;
    /// The same of one part of unknown length, at most `most` bytes.
    [[nodiscard]] Outcome read(std::vector<unsigned char>& part, std::uint64_t most) const;
    /// Makes the folder where it is missing; the file appears complete or not at all. Returns why it could
    /// not be written, or an empty string.
    [[nodiscard]] std::string write(std::span<const std::span<const unsigned char>> parts) const;

private:
    // The length of the content, or why there is none that fits.
    [[nodiscard]] Outcome find(std::uint64_t& length) const;

    std::string header_;
    std::filesystem::path path_;
};

/// The bytes of numbers.
template <class T>
[[nodiscard]] std::span<const unsigned char> bytes_of(std::span<const T> numbers) {
    return {reinterpret_cast<const unsigned char*>(numbers.data()), numbers.size_bytes()};
}
template <class T>
[[nodiscard]] std::span<unsigned char> writable_bytes_of(std::span<T> numbers) {
    return {reinterpret_cast<unsigned char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace nicol
