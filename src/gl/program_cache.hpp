// SPDX-License-Identifier: MIT
// Linked programs kept on disk, in the driver's own form.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "gl/context.hpp"

namespace nicol::gl {

/// Sets the folder of a context's program cache; empty: no cache. Does nothing if the driver has no binary
/// format. `notice`, which may be empty, is told about files that are damaged or refused by the driver, on
/// the thread that called run(), after it. Inside run().
void keep_programs(Context& context, std::filesystem::path folder,
                   std::function<void(const std::string&)> notice = {});

/// What identifies a program.
class ProgramKey {
public:
    void add(unsigned stage, const std::string& text);
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

/// All members inside run(). A file is for one driver, by its names and version; files that are outdated,
/// damaged or refused by the driver are notices, and failures to write are ignored.
class ProgramCache {
public:
    explicit ProgramCache(Context& context);

    [[nodiscard]] bool enabled() const noexcept { return !folder_.empty(); }
    /// Loads the cached binary into the program of this name. False if there is none; the program is then
    /// unchanged.
    [[nodiscard]] bool load(const ProgramKey& key, unsigned program) const;
    /// Saves a linked program.
    void store(const ProgramKey& key, unsigned program) const;

private:
    Context& context_;
    std::filesystem::path folder_;
};

}  // namespace nicol::gl
