// SPDX-License-Identifier: MIT
// Disk cache of linked programs, in the driver's own format.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "gl/context.hpp"

namespace nicol::gl {

/// Sets the folder of a context's program cache; empty: no cache. Does nothing if the driver has no binary
/// format. `notice`, which may be empty, receives messages about files that are damaged or refused by the
/// driver, on the thread that called run(), after run(). Inside run().
void keep_programs(Context& context, std::filesystem::path folder,
                   std::function<void(const std::string&)> notice = {});

/// Identity of a program: stages and source texts.
class ProgramKey {
public:
    void add(unsigned stage, const std::string& text);
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

/// Cache of program binaries. All members must be called inside run(). A file is valid for one driver,
/// identified by its names, version, UUID and backend. Files that are outdated, damaged or refused by the
/// driver cause notices; failures to write are ignored.
class ProgramCache {
public:
    explicit ProgramCache(Context& context);

    [[nodiscard]] bool enabled() const noexcept { return !folder_.empty(); }
    /// Loads the cached binary into the program of this name. Returns false if there is none; the program is
    /// then unchanged.
    [[nodiscard]] bool load(const ProgramKey& key, unsigned program) const;
    /// Saves a linked program.
    void store(const ProgramKey& key, unsigned program) const;

private:
    Context& context_;
    std::filesystem::path folder_;
};

}  // namespace nicol::gl
