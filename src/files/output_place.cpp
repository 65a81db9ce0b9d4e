// SPDX-License-Identifier: MIT
#include "files/output_place.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

#include "error.hpp"

namespace nicol {
namespace {

namespace fs = std::filesystem;

bool is_number(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns the process whose open file `path` is, in a folder such as /proc/1234/fd; 0 if `path` is no open
/// file.
long process_of(const fs::path& path) {
    std::error_code error;
    const fs::path folder = fs::canonical(path.parent_path(), error);
    if (error || folder.filename() != "fd" || !is_number(path.filename().string())) return 0;
    fs::path process = folder.parent_path();
    // A thread shares the open files of its process.
    if (process.parent_path().filename() == "task") process = process.parent_path().parent_path();
    const std::string name = process.filename().string();
    if (process.parent_path() != "/proc" || !is_number(name)) return 0;
    long number = 0;
    std::from_chars(name.data(), name.data() + name.size(), number);
    return number;
}

}  // namespace

OutputPlace output_place(const fs::path& target) {
    constexpr int most_links = 40;  // the limit of Linux
    if (!target.has_filename()) cannot_write(target, EISDIR);
    OutputPlace place{.file = target};
    std::error_code error;
    for (int links = 0;; ++links) {
        if (links == most_links) cannot_write(target, ELOOP);
        const fs::path beside = place.file.has_parent_path() ? place.file.parent_path() : fs::path(".");
        if (const long process = process_of(beside / place.file.filename()); process != 0) {
            place.stream = true;
            const std::string number = place.file.filename().string();
            if (process == ::getpid())
                std::from_chars(number.data(), number.data() + number.size(), place.descriptor);
            return place;
        }
        if (!fs::is_symlink(fs::symlink_status(place.file, error))) break;
        const fs::path next = fs::read_symlink(place.file, error);
        if (error) cannot_write(target, error.value());
        place.file = next.is_absolute() ? next : beside / next;
    }
    const fs::file_status status = fs::status(place.file, error);
    if (fs::is_directory(status)) cannot_write(target, EISDIR);
    place.stream = fs::exists(status) && !fs::is_regular_file(status);
    return place;
}

void cannot_write(const fs::path& target, int error) {
    const std::string reason = error != 0 ? std::generic_category().message(error) : "the disk may be full";
    throw Error(ErrorCode::write_failed, target.string() + ": cannot be written (" + reason +
                                             "); the folder must exist, be writable and have space");
}

}  // namespace nicol
