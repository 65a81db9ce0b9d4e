// SPDX-License-Identifier: MIT
// POSIX shared memory of a name, made by the writer.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>

#include "common/failure.hpp"

/// Zeroed memory that other processes map by its name until the object ends.
class SharedMemory {
public:
    /// Throws Failure if the name is taken, because two writers would break the sequence lock.
    SharedMemory(std::string name, std::size_t size) : name_(std::move(name)), size_(size) {
        const int file = ::shm_open(name_.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0644);
        if (file < 0)
            throw Failure(name_ + ": " + std::strerror(errno) + "; it must be a free name such as /camera");
        const bool sized = ::ftruncate(file, static_cast<off_t>(size)) == 0;
        memory_ = sized ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0) : MAP_FAILED;
        const int error = errno;
        ::close(file);
        if (memory_ == MAP_FAILED) {
            ::shm_unlink(name_.c_str());
            throw Failure(name_ + ": " + std::strerror(error));
        }
    }
    ~SharedMemory() {
        ::munmap(memory_, size_);
        ::shm_unlink(name_.c_str());
    }
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;

    [[nodiscard]] std::span<std::byte> bytes() const { return {static_cast<std::byte*>(memory_), size_}; }

private:
    std::string name_;
    std::size_t size_;
    void* memory_ = MAP_FAILED;
};
