// SPDX-License-Identifier: MIT
#include "files/cache_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "error.hpp"
#include "files/atomic_file.hpp"
#include "files/content_hash.hpp"

namespace nicol {
namespace {

using std::filesystem::file_time_type;
using std::filesystem::path;

constexpr std::uint64_t kDefaultLimit = std::uint64_t{4} << 30;
constexpr std::size_t kDigits = 32;
constexpr std::chrono::hours kAbandoned{1};

struct File {
    path name;
    std::uint64_t bytes;
    file_time_type used;
};

/// Returns the cache files of a folder, without files whose status cannot be read, because other processes
/// may remove files at any time.
std::vector<File> files_of(const path& folder) {
    std::vector<File> found;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (!is_cache_file(entry->path())) continue;
        std::error_code gone;
        // Links are not followed.
        if (entry->symlink_status(gone).type() != std::filesystem::file_type::regular) continue;
        const std::uint64_t bytes = entry->file_size(gone);
        const file_time_type used = entry->last_write_time(gone);
        if (!gone) found.push_back({entry->path(), bytes, used});
    }
    return found;
}

}  // namespace

std::uint64_t cache_limit() {
    const char* set = std::getenv("NICOL_CACHE_LIMIT");
    const std::string_view text = set != nullptr ? set : "";
    if (text.empty()) return kDefaultLimit;
    std::uint64_t limit = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), limit);
    if (error != std::errc() || end != text.data() + text.size())
        throw Error(ErrorCode::invalid_argument, "NICOL_CACHE_LIMIT is \"" + std::string(text) +
                                                     "\"; it must be a number of bytes, or 0 for no limit");
    return limit != 0 ? limit : std::numeric_limits<std::uint64_t>::max();
}

bool is_cache_file(const path& file) {
    const std::string name = file.filename().string();
    return name.size() > kDigits && name[kDigits] == '.' &&
           name.find_first_not_of("0123456789abcdef") == kDigits;
}

void make_room(const path& wanted, std::uint64_t bytes, std::uint64_t limit, file_time_type now) {
    std::vector<File> files = files_of(wanted.parent_path());
    std::error_code ignored;  // errors about files that are gone or belong to another user
    std::erase_if(files, [&](const File& file) {
        const bool temporary = file.name.extension() == ".tmp";
        if (temporary && now - file.used > kAbandoned) std::filesystem::remove(file.name, ignored);
        // Other processes write temporary files now, and `wanted` is replaced.
        return temporary || file.name == wanted;
    });
    std::ranges::sort(files, {}, &File::used);
    std::uint64_t all = bytes;
    for (const File& file : files) all += file.bytes;
    for (const File& file : files) {
        if (all <= limit) return;
        std::filesystem::remove(file.name, ignored);
        all -= file.bytes;
    }
}

namespace {

constexpr std::size_t kHashSize = 32;

}  // namespace

CacheFile::CacheFile(const std::filesystem::path& folder, std::string_view magic, std::uint32_t version,
                     std::string_view key, std::string_view suffix)
    : header_(magic) {
    const auto length = static_cast<std::uint32_t>(key.size());
    for (const std::uint32_t value : {version, length}) {
        header_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    header_ += key;
    path_ = folder / (ContentHash().add(header_).text() + std::string(suffix));
}

CacheFile::Outcome CacheFile::find(std::uint64_t& length) const {
    // Another process may remove the file at any time.
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path_, error);
    if (!std::filesystem::exists(status)) return {State::missing, {}};
    if (!std::filesystem::is_regular_file(status)) return {State::unfit, "cannot be read"};
    const std::uintmax_t all = std::filesystem::file_size(path_, error);
    if (error) return {State::missing, {}};
    if (all < header_.size() + kHashSize) return {State::unfit, "has the wrong length"};
    length = all - header_.size() - kHashSize;
    return {State::complete, {}};
}

CacheFile::Outcome CacheFile::read(std::vector<unsigned char>& part, std::uint64_t most) const {
    std::uint64_t length = 0;
    if (Outcome outcome = find(length); outcome.state != State::complete) return outcome;
    if (length > most) return {State::unfit, "has the wrong length"};
    part.resize(length);
    const std::span<unsigned char> whole(part);
    return read({&whole, 1});
}

CacheFile::Outcome CacheFile::read(std::span<const std::span<unsigned char>> parts) const {
    // The length is checked before anything is read.
    std::uint64_t length = 0;
    if (Outcome outcome = find(length); outcome.state != State::complete) return outcome;
    std::uint64_t expected = 0;
    for (const auto& part : parts) expected += part.size();
    if (length != expected) return {State::unfit, "has the wrong length"};
    std::ifstream in(path_, std::ios::binary);
    std::error_code error;
    if (!in)
        return std::filesystem::exists(path_, error) ? Outcome{State::unfit, "cannot be read"} : Outcome{};
    std::string found(header_.size(), '\0');
    in.read(found.data(), static_cast<std::streamsize>(found.size()));
    if (!in || found != header_) return {State::unfit, "is of another version or made from something else"};
    ContentHash hash;
    hash.add(header_);
    for (const auto& part : parts) {
        in.read(reinterpret_cast<char*>(part.data()), static_cast<std::streamsize>(part.size()));
        hash.add(part);
    }
    std::string stored(kHashSize, '\0');
    in.read(stored.data(), kHashSize);
    if (!in || stored != hash.text()) return {State::unfit, "is damaged"};
    // Marks the file as used now. If the folder is not writable, other processes decide which files it keeps.
    static_cast<void>(::utimensat(AT_FDCWD, path_.c_str(), nullptr, 0));
    return {State::complete, {}};
}

std::string CacheFile::write(std::span<const std::span<const unsigned char>> parts) const {
    try {
        std::uint64_t size = header_.size() + kHashSize;
        for (const auto& part : parts) size += part.size();
        const std::uint64_t limit = cache_limit();
        if (size > limit)
            return path_.string() + ": " + std::to_string(size) + " bytes, more than the limit of " +
                   std::to_string(limit) + " that NICOL_CACHE_LIMIT sets for the whole cache";
        std::filesystem::create_directories(path_.parent_path());
        AtomicFile out(path_);
        ContentHash hash;
        hash.add(header_);
        // A failed write stays recorded in the FILE, where commit() finds it.
        static_cast<void>(std::fwrite(header_.data(), 1, header_.size(), out.handle()));
        for (const auto& part : parts) {
            hash.add(part);
            // fwrite() takes no null pointer, but an empty part may be null.
            if (!part.empty()) static_cast<void>(std::fwrite(part.data(), 1, part.size(), out.handle()));
        }
        const std::string stored = hash.text();
        static_cast<void>(std::fwrite(stored.data(), 1, stored.size(), out.handle()));
        out.sync();
        make_room(path_, size, limit, out.time());
        out.commit();
        return {};
    } catch (const Error& error) {
        return error.what();
    } catch (const std::filesystem::filesystem_error& error) {
        return path_.string() + ": cannot be written (" + error.code().message() + ")";
    }
}

}  // namespace nicol
