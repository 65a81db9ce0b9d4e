// SPDX-License-Identifier: MIT
// Output files that appear under their name only when they are complete.
#pragma once

#include <csignal>
#include <cstdio>
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

/// Guard that keeps SIGXFSZ and SIGPIPE from the thread that constructs it, so that a file beyond the
/// process's limit and a pipe without a reader are errors of write() instead of the process's end. The
/// destructor restores the thread's mask, and signals that were pending before remain pending. One thread
/// constructs and destroys the object.
class HeldSignals {
public:
    HeldSignals() noexcept;
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

private:
    sigset_t mask_{};   ///< the thread's previous mask
    sigset_t added_{};  ///< signals that are held by this object and were not pending before
};

/// Output file that collects its bytes in a nameless file, or in a temporary file beside the target if the
/// file system has no nameless files. commit() replaces the target, or the file that a symbolic link points
/// to, and keeps the mode and the owner of the replaced file. If the target is a device, a pipe or an open
/// file (OutputPlace::stream), commit() writes the bytes to the target. Without commit() nothing is left
/// behind. For use by one thread.
class AtomicFile {
public:
    /// Throws Error(write_failed) that names the path and the reason.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Returns the file, which can be read, written and positioned whatever the target is.
    [[nodiscard]] std::FILE* handle() const noexcept { return file_; }
    /// Returns the time of the last write, by the clock of the file system.
    [[nodiscard]] std::filesystem::file_time_type time() const;
    /// Flushes the written bytes to the disk, so that after a power failure the file is whole or absent. For
    /// files that live long. A failure of sync() makes commit() fail.
    void sync() noexcept;
    /// Completes the target. Throws Error(write_failed) if any byte could not be written.
    void commit();

private:
    [[noreturn]] void fail(int error) const { cannot_write(target_, error); }
    [[nodiscard]] std::filesystem::path new_name() const;
    void open_beside();
    void keep_mode() const;
    void copy_to_stream() const;
    void close();

    HeldSignals signals_;
    std::filesystem::path target_;  ///< path as given by the caller
    OutputPlace place_;
    std::filesystem::path temporary_;  ///< empty: the file has no name
    std::FILE* file_ = nullptr;
};

}  // namespace nicol
