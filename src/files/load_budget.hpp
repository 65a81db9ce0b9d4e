// SPDX-License-Identifier: MIT
// Limits of loading: bytes, vertices, triangles and time, regardless of the sizes that files claim; and the
// source of the files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "files/file_source.hpp"
#include "progress.hpp"

namespace nicol {

/// Limits for loading one mesh, light or material from a file, or one scene with all files that it names.
struct LoadLimits {
    /// Bytes of files, of decoded images and of decompressed data.
    std::uint64_t bytes = std::uint64_t{8} << 30;
    std::uint64_t vertices = std::uint64_t{1} << 26;   ///< sum over all instances, and sum over all meshes
    std::uint64_t triangles = std::uint64_t{1} << 27;  ///< sum over all instances, and sum over all meshes
    double seconds = 600;
    /// Callback that is called about ten times a second on the loading thread, with "load" and 0. Returning
    /// false cancels the load.
    Progress::Callback progress{};
    /// Source of all files of the load; null: the file system.
    std::shared_ptr<const FileSource> files{};
};

/// Account of one load against its limits. Every reader receives the budget, takes each resource before using
/// it, and calls step() during work. Copies share one account. All functions throw Error(unsupported) that
/// names the file, the exceeded limit, and the option that sets the limit, or Error(cancelled) if
/// LoadLimits::progress returns false.
class LoadBudget {
public:
    LoadBudget(const LoadLimits& limits = {});  // implicit, so that readers can be called with limits

    /// Returns the source of the load's files. Readers open files only through it.
    [[nodiscard]] const FileSource& files() const;

    /// Takes the size of a file before the file is read. The messages of step() and take_memory() name the
    /// last file.
    void take_file(const std::filesystem::path& file) const;
    /// Takes memory for decoded or inflated data before the memory is allocated.
    void take_memory(std::uint64_t bytes) const;
    /// Takes a texture, 16 bytes per pixel, before it is made from an image.
    void take_pixels(const std::filesystem::path& file, std::uint64_t pixels) const;
    /// Takes a mesh before it is made. Instances are counted separately.
    void take_mesh(const std::filesystem::path& file, std::uint64_t vertices, std::uint64_t triangles) const;
    /// Takes an instance of a mesh before it becomes a part of the content of `file`.
    void take_instance(const std::filesystem::path& file, std::uint64_t vertices,
                       std::uint64_t triangles) const;

    /// Counts steps of work. Every loop over the content of a file must call step(). One step is some
    /// nanoseconds of work: a number or a byte. The clock is read once per kStepsBetweenChecks steps.
    void step(std::uint64_t steps = 1) const {
        if ((*steps_ += steps) >= kStepsBetweenChecks) check();
    }
    /// Reads the clock at once and calls LoadLimits::progress.
    void check() const;
    void check_time(const std::filesystem::path& file) const;
    /// Reads the clock at once without calling LoadLimits::progress. For threads other than the loading
    /// thread.
    void check_deadline() const;

private:
    static constexpr std::uint64_t kStepsBetweenChecks = 1 << 16;
    struct Account;
    std::shared_ptr<Account> account_;
    std::uint64_t* steps_;  // counter of the account
};

}  // namespace nicol
