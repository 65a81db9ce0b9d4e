// SPDX-License-Identifier: MIT
#include "memory/failing_new.hpp"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "nicol.h"

namespace {

std::atomic<bool> counting = false;
std::atomic<bool> lasting_shortage = false;
std::atomic<std::int64_t> allocations = 0;
std::atomic<std::int64_t> failing_position = -1;

std::atomic<memory_test::Reach> reach = memory_test::Reach::library;
constinit thread_local bool on_thread = false;

struct Range {
    std::uintptr_t begin = 0, end = 0;
    const std::uintptr_t inside = 0;

    explicit Range(const void* address) : inside(reinterpret_cast<std::uintptr_t>(address)) {}
    [[nodiscard]] bool contains(const void* address) const {
        const auto at = reinterpret_cast<std::uintptr_t>(address);
        return at >= begin && at < end;
    }
};

/// Returns the address range of the program or library that contains the address.
Range object_of(const void* address) {
    Range range(address);
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* out) {
            auto& found = *static_cast<Range*>(out);
            std::uintptr_t first = UINTPTR_MAX, last = 0;
            for (int i = 0; i < info->dlpi_phnum; ++i) {
                const auto& segment = info->dlpi_phdr[i];
                if (segment.p_type != PT_LOAD) continue;
                first = std::min(first, info->dlpi_addr + segment.p_vaddr);
                last = std::max(last, info->dlpi_addr + segment.p_vaddr + segment.p_memsz);
            }
            if (found.inside < first || found.inside >= last) return 0;
            found.begin = first;
            found.end = last;
            return 1;
        },
        &range);
    return range;
}

struct Places {
    /// Range of libnicol alone, because Mesa's compiler in this process does not survive a failing new.
    Range library = object_of(reinterpret_cast<const void*>(&nicol_render));
    Range program = object_of(&counting);
    Range libc = object_of(dlsym(RTLD_DEFAULT, "gnu_get_libc_version"));
    Range loader = object_of(dlsym(RTLD_DEFAULT, "_r_debug"));
};

const Places& places() {
    static const Places found;
    return found;
}

bool must_fail(const void* caller, bool by_new) {
    if (!counting.load(std::memory_order_relaxed)) return false;
    if (reach == memory_test::Reach::library) {
        if (!by_new || !places().library.contains(caller)) return false;
    } else if (!on_thread || places().program.contains(caller) || places().libc.contains(caller) ||
               places().loader.contains(caller)) {
        return false;
    }
    const std::int64_t position = allocations++;
    return failing_position >= 0 &&
           (position == failing_position || (lasting_shortage && position > failing_position));
}

void* allocate(std::size_t size, std::size_t alignment, const void* caller) noexcept {
    if (must_fail(caller, true)) return nullptr;
    if (alignment <= alignof(std::max_align_t)) return std::malloc(size == 0 ? 1 : size);
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void* allocate_or_throw(std::size_t size, std::size_t alignment, const void* caller) {
    if (void* memory = allocate(size, alignment, caller)) return memory;
    throw std::bad_alloc();
}

}  // namespace

namespace memory_test {

Shortage::Shortage(Reach reach) : Shortage(-1, false, reach) {}

Shortage::Shortage(std::int64_t position, bool lasting, Reach wanted) {
    static_cast<void>(places());
    reach = wanted;
    on_thread = true;
    allocations = 0;
    failing_position = position;
    lasting_shortage = lasting;
    counting = true;
}

Shortage::~Shortage() {
    counting = false;
    on_thread = false;
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

// Sanitizers bring their own malloc.
#ifndef NICOL_SANITIZED

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name): libc's declarations have no names
void* malloc(std::size_t size) noexcept {
    if (!must_fail(CALLER, false)) return __libc_malloc(size);
    errno = ENOMEM;
    return nullptr;
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    if (!must_fail(CALLER, false)) return __libc_calloc(count, size);
    errno = ENOMEM;
    return nullptr;
}
void* realloc(void* memory, std::size_t size) noexcept {
    if (!must_fail(CALLER, false)) return __libc_realloc(memory, size);
    errno = ENOMEM;
    return nullptr;
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    if (!must_fail(CALLER, false)) return __libc_memalign(alignment, size);
    errno = ENOMEM;
    return nullptr;
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
    void* const block = must_fail(CALLER, false) ? nullptr : __libc_memalign(alignment, size);
    if (block == nullptr) return ENOMEM;
    *memory = block;
    return 0;
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)
}

#endif
