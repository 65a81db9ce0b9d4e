// SPDX-License-Identifier: MIT
// A call of every function that takes a context or an object of one.
#pragma once

#include <filesystem>
#include <functional>

#include "common/handles.hpp"

/// Small scene, framebuffer and assets of a context, with which every function can be called.
class EntryPoints {
public:
    /// Gets the name of a function and its call, which throws nicol::Error on failure, and runs the call.
    using Watch = std::function<void(const char* name, const std::function<void()>& call)>;

    /// context: must outlive the object. folder: gets the files that functions write.
    EntryPoints(nicol_context context, std::filesystem::path folder);
    ~EntryPoints();
    EntryPoints(const EntryPoints&) = delete;
    EntryPoints& operator=(const EntryPoints&) = delete;

    /// Calls all functions but reads(). texture: of host(); 0: the context is not a host's.
    void all(const Watch& watch, std::uint32_t texture);
    /// Calls the functions that make textures, meshes, environments and materials, and those on their
    /// objects.
    void assets(const Watch& watch);
    /// Calls the functions on scenes, and those that render and read an image.
    void images(const Watch& watch);
    /// Calls the functions that submit and wait for a job.
    void jobs(const Watch& watch);
    /// Calls the functions that draw into `texture`, an RGBA32F texture of size() x size() pixels of the host
    /// whose context this is.
    void host(const Watch& watch, std::uint32_t texture);
    /// Calls the functions that read a framebuffer of three channels of another scene.
    void reads(const Watch& watch, nicol_framebuffer framebuffer);

    /// Returns the width and height of the image, in pixels.
    static constexpr std::uint32_t size() { return 32; }

private:
    struct Objects;
    std::unique_ptr<Objects> objects_;
};
