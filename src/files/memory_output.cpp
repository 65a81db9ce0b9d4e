// SPDX-License-Identifier: MIT
#include "files/memory_output.hpp"

#include <cstdlib>
#include <new>

namespace nicol {

MemoryOutput::MemoryOutput() : file_(::open_memstream(&bytes_, &size_)) {
    if (file_ == nullptr) throw std::bad_alloc();
}

MemoryOutput::~MemoryOutput() {
    static_cast<void>(std::fclose(file_));
    std::free(bytes_);
}

std::string_view MemoryOutput::bytes() {
    // The size after a flush is the file's position.
    if (std::fseek(file_, 0, SEEK_END) != 0 || std::fflush(file_) != 0 || std::ferror(file_) != 0)
        throw std::bad_alloc();
    return {bytes_, size_};
}

}  // namespace nicol
