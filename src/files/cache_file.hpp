// SPDX-License-Identifier: MIT
// Cache files that are used only if key, version, length and hash are right.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

/// Cache file. Its header has a magic, a format version and a key that identifies the inputs of the content.
/// The content follows, then a hash of all preceding bytes.
class CacheFile {
public:
    enum class State {
        complete,  ///< the file was read
        missing,   ///< there is no such file
        unfit,     ///< the file is damaged or has other content
    };
    struct Outcome {
        State state = State::missing;
        std::string reason;  ///< reason for `unfit`, a predicate: "is damaged"
    };

    /// Names the file in `folder` by a hash of key and version, with `suffix`.
    CacheFile(const std::filesystem::path& folder, std::string_view magic, std::uint32_t version,
              std::string_view key, std::string_view suffix);

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

    /// Fills the parts one after the other. The parts are valid only if the result is `complete`. Reading a
    /// file makes it the last that make_room() removes.
    [[nodiscard]] Outcome read(std::span<const std::span<unsigned char>> parts) const;
    /// Reads content of unknown length, at most `most` bytes, into one part. The part is valid only if the
    /// result is `complete`.
    [[nodiscard]] Outcome read(std::vector<unsigned char>& part, std::uint64_t most) const;
    /// Creates the folder if it is missing, makes room in it (make_room()) and writes the file atomically.
    /// Returns the reason of a failure, or an empty string.
    [[nodiscard]] std::string write(std::span<const std::span<const unsigned char>> parts) const;

private:
    // Finds the length of the content, or the reason why the file is unfit.
    [[nodiscard]] Outcome find(std::uint64_t& length) const;

    std::string header_;
    std::filesystem::path path_;
};

/// Returns the bytes of numbers.
template <class T>
[[nodiscard]] std::span<const unsigned char> bytes_of(std::span<const T> numbers) {
    return {reinterpret_cast<const unsigned char*>(numbers.data()), numbers.size_bytes()};
}
template <class T>
[[nodiscard]] std::span<unsigned char> writable_bytes_of(std::span<T> numbers) {
    return {reinterpret_cast<unsigned char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace nicol
