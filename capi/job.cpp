// SPDX-License-Identifier: MIT
// Jobs, the queue that runs them, and the functions of jobs.
#include "job.hpp"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "forked.hpp"
#include "geometry/embree.hpp"
#include "gl/worker.hpp"
#include "handles.hpp"
#include "initialiser.hpp"

namespace nicol::capi {

nicol_job_status Job::status() const {
    const std::lock_guard lock(mutex_);
    nicol_job_status out = NICOL_JOB_STATUS_INIT;
    out.state = state_;
    out.result = result_;
    out.fraction = fraction_;
    out.verb = verb_;
    return out;
}

bool Job::waiting() const {
    const std::lock_guard lock(mutex_);
    return state_ == NICOL_JOB_WAITING;
}

std::optional<nicol_result> Job::wait(std::optional<std::chrono::milliseconds> at_most) const {
    std::unique_lock lock(mutex_);
    const auto done = [this] { return state_ == NICOL_JOB_DONE; };
    if (!at_most) {
        changed_.wait(lock, done);
    } else if (!changed_.wait_for(lock, *at_most, done)) {
        return std::nullopt;
    }
    if (result_ == NICOL_OK) return NICOL_OK;
    return fail(static_cast<ErrorCode>(result_), message_.data());
}

void Job::cancel() {
    Work dropped;  // destroyed after the lock, because it may own large objects
    std::function<void()> ended;
    {
        const std::lock_guard lock(mutex_);
        cancelled_ = true;
        if (state_ != NICOL_JOB_WAITING) return;
        dropped = std::move(work_);
        work_ = nullptr;
        ended = finish(NICOL_ERROR_CANCELLED, "the job was cancelled before it ran");
    }
    ended();
}

void Job::require_wanted() const {
    if (cancelled_) throw Error(ErrorCode::cancelled, "the job was cancelled");
}

void Job::check() const {
    const std::lock_guard lock(mutex_);
    require_wanted();
}

void Job::report(const char* verb, double fraction) {
    const std::lock_guard lock(mutex_);
    verb_ = verb;
    fraction_ = fraction;
    require_wanted();
}

void Job::begin() {
    const std::lock_guard lock(mutex_);
    require_wanted();
    state_ = NICOL_JOB_RUNNING;
}

void Job::run() {
    Work work;
    {
        const std::lock_guard lock(mutex_);
        if (state_ == NICOL_JOB_DONE) return;
        work = std::move(work_);
        work_ = nullptr;
    }
    const nicol_result result = guarded([&] { work(*this); }, "nicol_render_async");
    work = nullptr;  // releases its objects before any waiting thread continues
    std::function<void()> ended;
    {
        const std::lock_guard lock(mutex_);
        if (state_ == NICOL_JOB_DONE) return;  // cancelled before begin()
        ended = finish(result, nicol_last_error());
    }
    ended();
}

std::function<void()> Job::finish(nicol_result result, const char* message) {
    state_ = NICOL_JOB_DONE;
    result_ = result;
    verb_ = "";
    if (result == NICOL_OK) {
        fraction_ = 1;
    } else {
        const std::size_t length = std::min(std::strlen(message), message_.size() - 1);
        std::copy_n(message, length, message_.begin());
    }
    changed_.notify_all();
    return std::exchange(ended_, nullptr);
}

struct JobQueue::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::shared_ptr<Job>> jobs;
    std::shared_ptr<Job> running;
    bool stopped = false;
    std::thread::id thread;

    void work() {
        {
            const std::lock_guard lock(mutex);
            thread = std::this_thread::get_id();
        }
        while (true) {
            std::shared_ptr<Job> job;
            {
                std::unique_lock lock(mutex);
                running.reset();
                changed.notify_all();
                changed.wait(lock, [this] { return stopped || !jobs.empty(); });
                if (jobs.empty()) return;
                job = std::move(jobs.front());
                jobs.pop_front();
                running = job;
            }
            job->run();
        }
    }

    /// Cancels all jobs and waits for the one that runs.
    void drain() {
        std::unique_lock lock(mutex);
        stopped = true;
        changed.notify_all();
        if (thread == std::this_thread::get_id()) return;
        std::vector<std::shared_ptr<Job>> left(jobs.begin(), jobs.end());
        if (running) left.push_back(running);
        lock.unlock();
        for (const auto& job : left) job->cancel();
        left.clear();
        lock.lock();
        changed.wait(lock, [this] { return !running && jobs.empty(); });
    }
};

namespace {

/// Queues of the process. Jobs must end before the process destroys objects that they use.
template <class Queue>
class LiveQueues {
public:
    void drain() {
        std::unique_lock lock(mutex_);
        const std::vector<std::weak_ptr<Queue>> queues = std::move(queues_);
        lock.unlock();
        for (const auto& weak : queues) {
            if (const auto queue = weak.lock()) queue->drain();
        }
        gl::join_left_threads();  // threads of queues that their last jobs destroyed
    }
    void add(const std::shared_ptr<Queue>& queue) {
        const std::lock_guard lock(mutex_);
        std::erase_if(queues_, [](const auto& weak) { return weak.expired(); });
        queues_.push_back(queue);
    }

private:
    std::mutex mutex_;
    std::vector<std::weak_ptr<Queue>> queues_;
};

}  // namespace

JobQueue::JobQueue() : shared_(std::make_shared<Shared>()) {
    // At the process's end, jobs must end before Embree's static objects are destroyed. Opening Embree here
    // makes this handler run first, because objects made later are destroyed earlier.
    embree::open_if_there();
    static auto& live = *new LiveQueues<Shared>;
    static const AtProcessEnd drain([] { live.drain(); });
    live.add(shared_);
    thread_ = gl::start_quiet_thread([shared = shared_] { shared->work(); });
}

JobQueue::~JobQueue() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->stopped = true;
        shared_->changed.notify_all();
    }
    gl::join_or_leave(std::move(thread_));
}

void JobQueue::add(std::shared_ptr<Job> job) {
    const std::lock_guard lock(shared_->mutex);
    auto& jobs = shared_->jobs;
    std::erase_if(jobs, [](const auto& one) { return !one->waiting(); });  // cancelled ones
    if (jobs.size() >= NICOL_MAX_JOBS) {
        throw Error(ErrorCode::busy, std::to_string(jobs.size()) +
                                         " jobs of the context wait already; wait for one, or cancel it");
    }
    jobs.push_back(std::move(job));
    shared_->changed.notify_all();
}

}  // namespace nicol::capi

using namespace nicol;
using namespace nicol::capi;

nicol_result nicol_job_poll(nicol_job job, nicol_job_status* status) {
    return guarded([&] {
        const nicol_job_impl& self = resolve(job);
        self.session->gl->lend();
        write_struct(status, self.content->status(), "status");
    });
}

nicol_result nicol_job_wait(nicol_job job, uint32_t timeout_ms) {
    nicol_result result = NICOL_OK;
    const nicol_result called = guarded([&] {
        const nicol_job_impl& self = resolve(job);
        refuse_in_callback(*self.session);
        auto at_most = timeout_ms == NICOL_WAIT_FOREVER
                           ? std::nullopt
                           : std::optional(std::chrono::milliseconds(timeout_ms));
        if (self.session->in_host()) {
            std::optional<std::chrono::steady_clock::time_point> until;
            if (at_most) until = std::chrono::steady_clock::now() + *at_most;
            static_cast<void>(self.session->gl->lend_until(
                [&] { return self.content->status().state == NICOL_JOB_DONE; }, until));
            at_most = std::chrono::milliseconds(0);
        }
        const std::optional<nicol_result> done = self.content->wait(at_most);
        if (!done) {
            throw Error(ErrorCode::timeout,
                        "the job is not done after " + std::to_string(timeout_ms) + " milliseconds");
        }
        result = *done;
    });
    return called == NICOL_OK ? result : called;
}

nicol_result nicol_job_cancel(nicol_job job) {
    return guarded([&] { resolve(job).content->cancel(); });
}

nicol_result nicol_job_retain(nicol_job job) {
    return retain(job);
}
nicol_result nicol_job_release(nicol_job job) {
    return release(job);
}

NICOL_INITIALISER(nicol_job_status, NICOL_JOB_STATUS_INIT)
