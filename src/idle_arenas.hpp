// SPDX-License-Identifier: MIT
// Arenas of oneTBB between two uses.
#pragma once

#include <tbb/task_arena.h>

#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace nicol {

/// Number of an arena's threads, and how many of its places are kept for threads that call execute().
struct ArenaSize {
    int threads = 1;
    unsigned reserved = 1;
    // NOLINTNEXTLINE(modernize-use-nullptr): the zero is the comparison's own
    auto operator<=>(const ArenaSize&) const = default;
};

/// Arenas that nobody uses, of the whole process. oneTBB (2021.8) never frees an arena that was destroyed
/// after it had asked for threads, 7 kB each, so that arenas are used again instead.
class IdleArenas {
public:
    /// Returns the arenas of the process, which outlive all others that use them.
    [[nodiscard]] static IdleArenas& of_process() {
        static IdleArenas& arenas = *new IdleArenas;
        return arenas;
    }

    /// Returns an initialised arena of this size. Throws std::bad_alloc.
    [[nodiscard]] std::unique_ptr<tbb::task_arena> take(ArenaSize size) {
        {
            const std::lock_guard lock(mutex_);
            if (auto idle = arenas_.extract(size); !idle.empty()) return std::move(idle.mapped());
        }
        auto made = std::make_unique<tbb::task_arena>(size.threads, size.reserved);
        made->initialize();
        return made;
    }

    /// Keeps an arena of take() for the next one, or destroys it where memory is short.
    void give_back(ArenaSize size, std::unique_ptr<tbb::task_arena> arena) noexcept {
        try {
            const std::lock_guard lock(mutex_);
            arenas_.emplace(size, std::move(arena));
        } catch (const std::exception&) {  // the arena is destroyed
        }
    }

private:
    std::mutex mutex_;
    std::multimap<ArenaSize, std::unique_ptr<tbb::task_arena>> arenas_;
};

}  // namespace nicol
