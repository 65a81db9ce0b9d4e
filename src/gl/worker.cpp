// SPDX-License-Identifier: MIT
// The job queues of a context's thread.
#include "gl/worker.hpp"

#include <algorithm>
#include <csignal>
#include <exception>
#include <system_error>
#include <utility>
#include <vector>

#include "error.hpp"
#include "floating_environment.hpp"
#include "forked.hpp"

namespace nicol::gl {
namespace {

thread_local bool is_quiet_thread = false;

/// Threads whose context was dropped on a context's thread. They are not joined there, because such a thread
/// may be the caller itself or wait for it. The object is never destroyed, because threads may be added while
/// the process ends.
class LeftThreads {
public:
    void add(std::thread thread) {
        const std::lock_guard lock(mutex_);
        threads_.push_back(std::move(thread));
    }
    void join() {
        // Joining a thread may add other threads.
        for (std::vector<std::thread> ending = take(); !ending.empty(); ending = take()) {
            for (std::thread& thread : ending) {
                if (thread.get_id() == std::this_thread::get_id())
                    thread.detach();  // ends the process itself
                else
                    thread.join();
            }
        }
    }

private:
    std::vector<std::thread> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(threads_, {});
    }

    std::mutex mutex_;
    std::vector<std::thread> threads_;
};

LeftThreads& left_threads() {
    static auto& instance = *new LeftThreads;
    // The threads are joined before Mesa's exit handlers run, which would break a context that is still being
    // destroyed.
    static const AtProcessEnd join([] { instance.join(); });
    return instance;
}

}  // namespace

void Worker::work() {
    id_ = std::this_thread::get_id();
    std::unique_lock lock(mutex_);
    while (Jobs* const jobs = next(lock)) {
        std::function<void()> job = std::move(jobs->front());
        jobs->pop_front();
        lock.unlock();
        job();
        job = nullptr;
        lock.lock();
    }
}

Worker::Jobs* Worker::next(std::unique_lock<std::mutex>& lock) {
    given_.wait(lock, [this] { return stopped_ || !jobs_.empty() || !patient_.empty(); });
    if (!patient_.empty()) {
        const auto awaited = [this] { return stopped_ || !jobs_.empty(); };
        given_.wait_until(lock, std::min(quiet_, latest_), awaited);
        if (jobs_.empty() || Clock::now() >= latest_) return &patient_;
    }
    return jobs_.empty() ? nullptr : &jobs_;
}

void Worker::execute(void (*call)(void*), void* argument) {
    if (on_thread()) {
        call(argument);
        return;
    }
    struct Done {
        std::mutex mutex;
        std::condition_variable changed;
        bool done = false;
        std::exception_ptr error;
    } done;
    const bool patient = giving_way_.load() == std::this_thread::get_id();
    give(patient ? patient_ : jobs_, [this, patient, call, argument, &done] {
        std::exception_ptr error;
        try {
            call(argument);
        } catch (...) {
            error = std::current_exception();
        }
        if (!patient) {
            const std::lock_guard lock(mutex_);
            quiet_ = Clock::now() + patience_.pause;
        }
        // The notification happens under the lock, because the waiting thread may return and destroy `done`
        // once the lock is released.
        const std::lock_guard lock(done.mutex);
        done.error = std::move(error);
        done.done = true;
        done.changed.notify_one();
    });
    std::unique_lock lock(done.mutex);
    done.changed.wait(lock, [&done] { return done.done; });
    if (done.error) std::rethrow_exception(std::move(done.error));
}

void Worker::post(std::function<void()> job) {
    give(jobs_, std::move(job));
}

void Worker::give(Jobs& jobs, std::function<void()> job) {
    {
        const std::lock_guard lock(mutex_);
        jobs.push_back(std::move(job));
        if (&jobs == &patient_) latest_ = Clock::now() + patience_.longest;
    }
    given_.notify_one();
}

void Worker::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
    }
    given_.notify_one();
}

bool Worker::on_thread() const noexcept {
    return id_.load() == std::this_thread::get_id();
}

std::thread start_quiet_thread(std::function<void()> body) {
    sigset_t quiet, before;
    sigfillset(&quiet);
    // Faults of the thread itself must still reach the host's handlers.
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS})
        sigdelset(&quiet, fault);
    pthread_sigmask(SIG_BLOCK, &quiet, &before);  // inherited by the new thread
    try {
        std::thread thread([body = std::move(body)] {
            const FloatingEnvironment environment;
            is_quiet_thread = true;
            body();
        });
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
        return thread;
    } catch (const std::system_error& error) {
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
        throw Error(ErrorCode::out_of_memory,
                    std::string("a thread cannot be started (") + error.what() + ")");
    } catch (...) {
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
        throw;
    }
}

void join_or_leave(std::thread thread) {
    if (is_quiet_thread) {
        left_threads().add(std::move(thread));
        return;
    }
    thread.join();
    join_left_threads();
}

void join_left_threads() {
    left_threads().join();
}

}  // namespace nicol::gl
