// SPDX-License-Identifier: MIT
// An output file that appears under its name only when it is complete.
#pragma once

#include <cstdio>
#include <filesystem>

namespace nicol {

/// Writes to a new file beside the target; commit() renames it, and without commit() it is removed.
class AtomicFile {
public:
    /// Throws Error(write_failed) naming the path and the reason.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    [[nodiscard]] std::FILE* handle() const noexcept { return file_; }
    /// When it was last written to, by the clock of its file system.
    [[nodiscard]] std::filesystem::file_time_type time() const;
    /// Has what was written reach the disk, so that after a power failure the file is whole or absent: for
    /// files that live long. What fails here fails again in commit().
    void sync() noexcept;
    /// Flushes, closes and renames. Throws Error(write_failed) if any byte could not be written.
    void commit();

private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_;
    std::filesystem::path temporary_;
    std::FILE* file_ = nullptr;
};

}  // namespace nicol
