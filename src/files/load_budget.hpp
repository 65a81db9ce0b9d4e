// SPDX-License-Identifier: MIT
// What loading may take, whatever files claim or multiply.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace nicol {

/// Of one mesh, light or material from a file, or of one scene with all that it names.
struct LoadLimits {
    std::uint64_t bytes = std::uint64_t{8} << 30;      ///< of all files and pixels of textures together
    std::uint64_t vertices = std::uint64_t{1} << 26;   ///< of all instances together, also of one mesh
    std::uint64_t triangles = std::uint64_t{1} << 27;  ///< likewise
    double seconds = 600;
};

/// One load, held to its limits: to be told what it is about to do. All throw Error(unsupported) that names
/// the file, what exceeds the limit, and the option that sets it.
class LoadBudget {
public:
    explicit LoadBudget(const LoadLimits& limits) : limits_(limits) {}

    /// Before the file is read.
    void take_file(const std::filesystem::path& file);
    /// Of an image that `file` holds, 16 bytes each, before a texture is made of it.
    void take_pixels(const std::filesystem::path& file, std::uint64_t pixels);
    /// Before an instance of a mesh becomes a part of what `file` describes.
    void take_instance(const std::filesystem::path& file, std::uint64_t vertices, std::uint64_t triangles);
    /// Within what takes long; the others do so too.
    void check_time(const std::filesystem::path& file) const;

private:
    void take_bytes(const std::filesystem::path& file, std::uint64_t bytes);

    LoadLimits limits_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::uint64_t bytes_ = 0;
    std::uint64_t vertices_ = 0;
    std::uint64_t triangles_ = 0;
};

}  // namespace nicol
