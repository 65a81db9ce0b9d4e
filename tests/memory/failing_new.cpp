// SPDX-License-Identifier: MIT
#include "memory/failing_new.hpp"

#include <dlfcn.h>
#include <link.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "nicol.h"

namespace {

std::atomic<bool> counting = false;
std::atomic<bool> lasting_shortage = false;
std::atomic<std::int64_t> allocations = 0;
std::atomic<std::int64_t> failing_position = -1;

struct Range {
    std::uintptr_t begin = 0, end = 0;
};

/// Where libnicol's code lies. Mesa's compiler, which shares the process, does not survive a failing new.
Range find_library() {
    Range range;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* out) {
            const auto inside = reinterpret_cast<std::uintptr_t>(&nicol_render);
            for (int i = 0; i < info->dlpi_phnum; ++i) {
                const auto& segment = info->dlpi_phdr[i];
                const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
                if (segment.p_type != PT_LOAD || inside < begin || inside >= begin + segment.p_memsz)
                    continue;
                *static_cast<Range*>(out) = {begin, begin + segment.p_memsz};
                return 1;
            }
            return 0;
        },
        &range);
    return range;
}

bool must_fail(const void* caller) {
    if (!counting.load(std::memory_order_relaxed)) return false;
    static const Range library = find_library();
    const auto address = reinterpret_cast<std::uintptr_t>(caller);
    if (address < library.begin || address >= library.end) return false;
    const std::int64_t position = allocations++;
    return failing_position >= 0 &&
           (position == failing_position || (lasting_shortage && position > failing_position));
}

void* allocate(std::size_t size, std::size_t alignment, const void* caller) noexcept {
    if (must_fail(caller)) return nullptr;
    if (alignment <= alignof(std::max_align_t)) return std::malloc(size == 0 ? 1 : size);
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void* allocate_or_throw(std::size_t size, std::size_t alignment, const void* caller) {
    if (void* memory = allocate(size, alignment, caller)) return memory;
    throw std::bad_alloc();
}

}  // namespace

namespace memory_test {

Shortage::Shortage() : Shortage(-1, false) {}

Shortage::Shortage(std::int64_t position, bool lasting) {
    allocations = 0;
    failing_position = position;
    lasting_shortage = lasting;
    counting = true;
}

Shortage::~Shortage() {
    counting = false;
}

std::int64_t Shortage::count() const {
    return allocations;
}

}  // namespace memory_test

#define CALLER __builtin_return_address(0)

void* operator new(std::size_t size) {
    return allocate_or_throw(size, 1, CALLER);
}
void* operator new[](std::size_t size) {
    return allocate_or_throw(size, 1, CALLER);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocate_or_throw(size, static_cast<std::size_t>(alignment), CALLER);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return allocate_or_throw(size, static_cast<std::size_t>(alignment), CALLER);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size, 1, CALLER);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size, 1, CALLER);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
