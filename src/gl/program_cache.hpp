// SPDX-License-Identifier: MIT
// Linked programs kept on disk, in the driver's own form.
#pragma once

#include <filesystem>
#include <string>

#include "gl/context.hpp"

namespace nicol::gl {

/// From now on keeps a context's programs in a folder; an empty one: nowhere. Where the driver offers no
/// form to keep them in nothing is kept. Inside run().
void keep_programs(Context& context, std::filesystem::path folder);

/// What a program is made of.
class ProgramKey {
public:
    void add(unsigned stage, const std::string& text);
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

/// All members inside run(). A file serves one driver, by its names and version; what is stale, damaged or
/// refused by the driver is as good as missing, and what cannot be written is not kept.
class ProgramCache {
public:
    explicit ProgramCache(Context& context);

    [[nodiscard]] bool enabled() const noexcept { return !folder_.empty(); }
    /// Makes the program of this name the one that was kept. False where there is none; then the program is
    /// as good as new.
    [[nodiscard]] bool load(const ProgramKey& key, unsigned program) const;
    /// Keeps a linked program.
    void store(const ProgramKey& key, unsigned program) const;

private:
    Context& context_;
    std::filesystem::path folder_;
};

}  // namespace nicol::gl
