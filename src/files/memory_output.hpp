// SPDX-License-Identifier: MIT
// Output file in memory.
#pragma once

#include <cstdio>
#include <string_view>

namespace nicol {

/// Output file whose bytes stay in memory, for writers that position their file. For use by one thread.
class MemoryOutput {
public:
    MemoryOutput();
    ~MemoryOutput();
    MemoryOutput(const MemoryOutput&) = delete;
    MemoryOutput& operator=(const MemoryOutput&) = delete;

    /// Returns the file, which can be written and positioned.
    [[nodiscard]] std::FILE* handle() const noexcept { return file_; }
    /// Returns all written bytes, which live until the next write. Throws std::bad_alloc if any byte is lost.
    [[nodiscard]] std::string_view bytes();

private:
    char* bytes_ = nullptr;
    std::size_t size_ = 0;
    std::FILE* file_ = nullptr;
};

}  // namespace nicol
