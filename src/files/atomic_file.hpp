// SPDX-License-Identifier: MIT
// An output file that appears under its name only when it is complete.
#pragma once

#include <cstdio>
#include <filesystem>

#include "files/held_signals.hpp"
#include "files/output_place.hpp"

namespace nicol {

/// Collects an output in a file without a name (where the file system has none: in a temporary file beside
/// the target). commit() replaces the target, or the file that a symbolic link points to, and keeps the mode
/// and the owner that it had; bytes for a device, a pipe or an open file (OutputPlace::stream) are written to
/// it by commit(). Without commit() nothing is left behind. Used by one thread.
class AtomicFile {
public:
    /// Throws Error(write_failed) naming the path and the reason.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Can be read, written and positioned, whatever the target is.
    [[nodiscard]] std::FILE* handle() const noexcept { return file_; }
    /// When it was last written to, by the clock of its file system.
    [[nodiscard]] std::filesystem::file_time_type time() const;
    /// Has what was written reach the disk, so that after a power failure the file is whole or absent: for
    /// files that live long. What fails here fails again in commit().
    void sync() noexcept;
    /// Throws Error(write_failed) if any byte could not be written.
    void commit();

private:
    [[noreturn]] void fail(int error) const { cannot_write(target_, error); }
    [[nodiscard]] std::filesystem::path new_name() const;
    void open_beside();
    void keep_mode() const;
    void copy_to_stream() const;
    void close();

    HeldSignals signals_;
    std::filesystem::path target_;  ///< as it was given
    OutputPlace place_;
    std::filesystem::path temporary_;  ///< empty: the file has no name
    std::FILE* file_ = nullptr;
};

}  // namespace nicol
