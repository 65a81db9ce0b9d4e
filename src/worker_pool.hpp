// SPDX-License-Identifier: MIT
// Threads that run the library's parallel loops: oneTBB's, or those of a host.
#pragma once

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include "idle_arenas.hpp"
#include "worker_count.hpp"

namespace nicol {

/// A host's task system. Both functions are empty if there is none.
struct TaskSystem {
    /// Begins `count` calls of task(), on any threads, and returns what finish() takes.
    std::function<void*(int count, const std::function<void()>& task)> start;
    /// Returns when the calls that start() began have returned.
    std::function<void(void* started)> finish;
};

/// Choice of threads. An empty task system: oneTBB's threads.
struct WorkerOptions {
    int threads = 0;  ///< number of threads; 0: one per core, which is also the maximum
    TaskSystem tasks{};
};

/// Runs functions whose parallel loops of oneTBB use the chosen threads.
class WorkerPool {
public:
    explicit WorkerPool(WorkerOptions options)
        : count_(worker_count(options.threads)), tasks_(std::move(options.tasks)) {}
    ~WorkerPool() {
        if (arena_) IdleArenas::of_process().give_back(size(), std::move(arena_));
    }
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    [[nodiscard]] int count() const { return count_; }

    /// Calls function() and returns when it has returned. Throws what it throws.
    template <class Function>
    void run(Function&& function) {
        if (!tasks_.start || count_ == 1 || inside_ == this)
            arena().execute(function);
        else
            lend(std::ref(function));
    }

private:
    /// Marks the thread as one of a pool, so that run() inside run() asks the host for nothing.
    class Inside {
    public:
        explicit Inside(const WorkerPool* pool) : outer_(std::exchange(inside_, pool)) {}
        ~Inside() { inside_ = outer_; }
        Inside(const Inside&) = delete;
        Inside& operator=(const Inside&) = delete;

    private:
        const WorkerPool* outer_;
    };

    /// Runs work() on the calling thread, while threads of the host take parts of its loops.
    void lend(const std::function<void()>& work) {
        const std::thread::id caller = std::this_thread::get_id();
        tbb::task_group group;
        // The host's threads wait for this task, which never runs but goes when the work is done. oneTBB
        // gives threads that wait parts of loops.
        tbb::task_handle done = group.defer([] {});
        arena();  // made by this thread alone
        const std::function<void()> help = [&] {
            // A host without threads to spare may call tasks on the caller's, which has nothing to wait for.
            if (std::this_thread::get_id() == caller) return;
            const Inside inside(this);
            arena().execute([&] { group.wait(); });
        };
        void* const started = tasks_.start(count_ - 1, help);
        std::exception_ptr failure;
        try {
            const Inside inside(this);
            arena().execute(work);
        } catch (...) {
            failure = std::current_exception();
        }
        done = tbb::task_handle();
        tasks_.finish(started);
        if (failure) std::rethrow_exception(failure);
    }

    /// Returns the size of the arena. With a host's task system, every place in it is kept for threads of the
    /// host.
    [[nodiscard]] ArenaSize size() const {
        return {count_, tasks_.start ? static_cast<unsigned>(count_) : 1U};
    }

    /// Returns the arena, initialised by take() because an arena that execute() initialises waits forever in
    /// the next execute() if memory ran out in the first.
    tbb::task_arena& arena() {
        if (!arena_) arena_ = IdleArenas::of_process().take(size());
        return *arena_;
    }

    static inline thread_local const WorkerPool* inside_ = nullptr;

    int count_;
    TaskSystem tasks_;
    std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace nicol
