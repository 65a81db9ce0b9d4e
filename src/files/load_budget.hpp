// SPDX-License-Identifier: MIT
// Limits of loading: bytes, vertices, triangles and time, whatever files claim or multiply.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "progress.hpp"

namespace nicol {

/// Limits of one mesh, light or material from a file, or of one scene with all that it names.
struct LoadLimits {
    /// Files, and what is made of images and of compressed data.
    std::uint64_t bytes = std::uint64_t{8} << 30;
    std::uint64_t vertices = std::uint64_t{1} << 26;   ///< of all instances together, and of all meshes
    std::uint64_t triangles = std::uint64_t{1} << 27;  ///< of all instances together, and of all meshes
    double seconds = 600;
    /// Called about ten times a second on the thread that loads, with "load" and 0; false ends the load.
    Progress::Callback progress{};
};

/// One load, held to its limits. It is handed down to every reader, which tells it what it is about to take
/// and asks it while it works. Copies share one account. All functions throw Error(unsupported) that names
/// the file, what exceeds the limit, and the option that sets it, or Error(cancelled) where
/// LoadLimits::progress says so.
class LoadBudget {
public:
    LoadBudget(const LoadLimits& limits = {});  // implicit, so that readers can be called with limits

    /// Takes the size of a file that is about to be read. The messages of step() and take_memory() name the
    /// last file.
    void take_file(const std::filesystem::path& file) const;
    /// Takes memory for what is decoded or inflated, before it is allocated.
    void take_memory(std::uint64_t bytes) const;
    /// Takes a texture, 16 bytes a pixel, before it is made of an image.
    void take_pixels(const std::filesystem::path& file, std::uint64_t pixels) const;
    /// Takes a mesh before it is made. Instances count apart.
    void take_mesh(const std::filesystem::path& file, std::uint64_t vertices, std::uint64_t triangles) const;
    /// Takes an instance of a mesh before it becomes a part of what `file` describes.
    void take_instance(const std::filesystem::path& file, std::uint64_t vertices,
                       std::uint64_t triangles) const;

    /// To be called in every loop over what a file has. One step is some nanoseconds of work: a number or a
    /// byte. The clock is read once in so many steps.
    void step(std::uint64_t steps = 1) const {
        if ((*steps_ += steps) >= kStepsBetweenChecks) check();
    }
    /// Reads the clock at once.
    void check() const;
    void check_time(const std::filesystem::path& file) const;
    /// The same without asking LoadLimits::progress, for other threads than the one that loads.
    void check_deadline() const;

private:
    static constexpr std::uint64_t kStepsBetweenChecks = 1 << 16;
    struct Account;
    std::shared_ptr<Account> account_;
    std::uint64_t* steps_;  // of the account
};

}  // namespace nicol
