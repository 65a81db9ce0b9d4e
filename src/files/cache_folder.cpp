// SPDX-License-Identifier: MIT
#include "files/cache_folder.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "error.hpp"

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

}  // namespace nicol
