// SPDX-License-Identifier: MIT
// Where the bytes of an output go.
#pragma once

#include <filesystem>

namespace nicol {

/// The place that an output's name stands for.
struct OutputPlace {
    /// The file itself, after all symbolic links: also where the last link points to nothing yet.
    std::filesystem::path file;
    /// A device, a pipe, or an open file of a process (/proc/self/fd/1, which /dev/stdout points to). Bytes
    /// are written to it; a regular file is replaced instead.
    bool stream = false;
    /// The number of an open file of this process, which keeps its position; -1: the stream is opened by
    /// name.
    int descriptor = -1;
};

/// Throws Error(write_failed) naming `target` where links form a circle or where it is a folder.
[[nodiscard]] OutputPlace output_place(const std::filesystem::path& target);

/// Throws Error(write_failed) with the reason that errno `error` stands for.
[[noreturn]] void cannot_write(const std::filesystem::path& target, int error);

}  // namespace nicol
