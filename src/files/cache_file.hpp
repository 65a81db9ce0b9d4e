// SPDX-License-Identifier: MIT
// Cache files that are used only if key, version, length and hash are right, and the size limit of their
// folders, which several processes on several machines may share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

/// Returns the number of bytes that the files of a cache folder may have together: the environment variable
/// NICOL_CACHE_LIMIT (0: no limit), or 4 GiB if the variable is not set or empty. Throws
/// Error(invalid_argument) if the variable is no whole number.
[[nodiscard]] std::uint64_t cache_limit();

/// Makes room in its folder for the cache file `file` of `bytes` bytes, at most `limit`. Removes the cache
/// files that were written or read longest ago until all fit the limit; an older version of `file` does not
/// count. Also removes temporary cache files of AtomicFile that were last written more than an hour before
/// `now`, because their writers were killed. Other files, and files that cannot be read or removed, are
/// neither counted nor touched. `now` is by the clock of the folder's file system.
void make_room(const std::filesystem::path& file, std::uint64_t bytes, std::uint64_t limit,
               std::filesystem::file_time_type now);

/// Returns whether a file has the name of a cache file: 32 hexadecimal digits and a suffix.
[[nodiscard]] bool is_cache_file(const std::filesystem::path& file);

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
