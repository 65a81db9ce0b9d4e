// SPDX-License-Identifier: MIT
// Shared helpers of the reader fuzzers: a file in memory, and the check of errors.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "error.hpp"
#include "files/load_budget.hpp"
#include "files/memory_files.hpp"

namespace nicol::fuzz {

/// Returns limits of a load that reads one file, which has this name, from memory, and no other file.
inline LoadLimits in_memory(const std::filesystem::path& name, std::string_view bytes) {
    return {.files = std::make_shared<const MemoryFiles>(name, bytes, nullptr)};
}

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
