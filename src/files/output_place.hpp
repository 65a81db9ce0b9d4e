// SPDX-License-Identifier: MIT
// Resolution of an output's name to the file or stream that receives the bytes.
#pragma once

#include <filesystem>

namespace nicol {

/// File or stream that an output's name stands for.
struct OutputPlace {
    /// File after all symbolic links, even if the last link points to nothing yet.
    std::filesystem::path file;
    /// Whether the output is a device, a pipe, or an open file of a process (/proc/self/fd/1, which
    /// /dev/stdout points to). Bytes are written to a stream, whereas a regular file is replaced.
    bool stream = false;
    /// Number of an open file of this process, which keeps its position; -1: the stream is opened by name.
    int descriptor = -1;
};

/// Resolves an output's name. Throws Error(write_failed) that names `target` if links form a circle or if
/// `target` is a folder.
[[nodiscard]] OutputPlace output_place(const std::filesystem::path& target);

/// Throws Error(write_failed) with the reason for which the errno value `error` stands.
[[noreturn]] void cannot_write(const std::filesystem::path& target, int error);

}  // namespace nicol
