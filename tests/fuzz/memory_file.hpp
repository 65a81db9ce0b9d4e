// SPDX-License-Identifier: MIT
// Shared helpers of the reader fuzzers: a file in memory, and the check of errors.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "error.hpp"

namespace nicol::fuzz {

/// A file in memory with a path, for readers that take a path. One object serves all inputs.
class MemoryFile {
public:
    MemoryFile()
        : file_(memfd_create("input", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(file_)) {}
    ~MemoryFile() { ::close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::filesystem::path& hold(std::string_view bytes) {
        if (::ftruncate(file_, 0) != 0 ||
            ::pwrite(file_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
            std::abort();
        return path_;
    }

private:
    int file_;
    std::filesystem::path path_;
};

inline void require(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "finding: %s\n", what);
    std::abort();
}

/// Calls read(). The reader may refuse the file with an Error that names it. Any other exception is a
/// finding.
template <class Read>
void may_refuse(const std::filesystem::path& file, Read read) {
    try {
        read();
    } catch (const Error& error) {
        const std::string_view message = error.what();
        const bool names_file = message.find(file.string()) != std::string_view::npos;
        require(names_file && error.code() != ErrorCode::internal, error.what());
    }
}

inline std::string_view text_of(const std::uint8_t* bytes, std::size_t size) {
    return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace nicol::fuzz

/// Runs one input. libFuzzer calls this function.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
