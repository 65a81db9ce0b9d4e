// SPDX-License-Identifier: MIT
#include "dispatcher.hpp"

#include <doctest/doctest.h>

namespace {

/// A dispatcher whose workers are simulated by the test.
struct Fixture {
    std::vector<std::pair<int, std::uint64_t>> started, cancelled;
    std::vector<std::pair<std::string, int>> answers;  ///< client and status of each answer
    Dispatcher dispatcher;

    explicit Fixture(std::size_t queue = 2)
        : dispatcher(queue, {.start = [this](int worker, std::uint64_t job,
                                             const ImageRequest&) { started.emplace_back(worker, job); },
                             .cancel = [this](int worker,
                                              std::uint64_t job) { cancelled.emplace_back(worker, job); }}) {}

    std::optional<Dispatcher::Ticket> ask(const std::string& key, const std::string& who,
                                          double azimuth = 0) {
        ImageRequest request;
        request.view.orbit.azimuth = azimuth;
        return dispatcher.submit(key, request, [this, who](const AnswerPtr& answer) {
            answers.emplace_back(who, answer->head.status);
        });
    }
    void done(std::size_t start) {
        const auto answer = std::make_shared<Answer>();
        answer->head.status = 200;
        dispatcher.worker_done(started[start].first, started[start].second, answer);
    }
};

using Answers = std::vector<std::pair<std::string, int>>;

}  // namespace

TEST_CASE("a worker takes the oldest request") {
    Fixture f;
    f.ask("a", "a");
    f.ask("b", "b");
    CHECK(f.started.empty());
    CHECK(f.dispatcher.queued() == 2);
    f.dispatcher.worker_idle(0);
    REQUIRE(f.started.size() == 1);
    CHECK(f.dispatcher.running() == 1);
    f.done(0);
    CHECK(f.answers == Answers{{"a", 200}});
    CHECK(f.started.size() == 1);  // a worker starts a request only once it is idle
    f.dispatcher.worker_idle(0);
    f.done(1);
    CHECK(f.answers == Answers{{"a", 200}, {"b", 200}});
}

TEST_CASE("the queue is bounded, and an idle worker is no queue") {
    Fixture f(1);
    f.dispatcher.worker_idle(0);
    CHECK(f.ask("a", "a"));
    CHECK(f.ask("b", "b"));
    CHECK(!f.ask("c", "c"));
    CHECK(f.ask("b", "b2"));  // joins the queued request
    CHECK(f.dispatcher.queued() == 1);
    Fixture none(0);
    CHECK(!none.ask("a", "a"));
    none.dispatcher.worker_idle(0);
    CHECK(none.ask("a", "a"));
}

TEST_CASE("equal requests in flight are rendered once") {
    Fixture f;
    f.dispatcher.worker_idle(0);
    CHECK(!f.ask("a", "1")->joined);
    CHECK(f.ask("a", "2")->joined);
    f.done(0);
    CHECK(f.started.size() == 1);
    CHECK(f.answers == Answers{{"1", 200}, {"2", 200}});
    f.dispatcher.worker_idle(0);
    CHECK(!f.ask("a", "3")->joined);
    CHECK(f.started.size() == 2);
}

TEST_CASE("who leaves is told nothing") {
    Fixture f;
    f.dispatcher.worker_idle(0);
    const auto one = f.ask("a", "1");
    const auto two = f.ask("a", "2");
    f.dispatcher.leave(*one);
    CHECK(f.cancelled.empty());
    f.done(0);
    CHECK(f.answers == Answers{{"2", 200}});
    f.dispatcher.leave(*two);  // has no effect after the answer
}

TEST_CASE("where nobody waits any more nothing is rendered") {
    Fixture f;
    const auto queued = f.ask("a", "1");
    f.dispatcher.leave(*queued);
    CHECK(f.dispatcher.queued() == 0);
    f.dispatcher.worker_idle(0);
    CHECK(f.started.empty());

    const auto running = f.ask("b", "2");
    f.dispatcher.leave(*running);
    REQUIRE(f.cancelled.size() == 1);
    CHECK(f.cancelled[0] == f.started[0]);
    // An equal new request does not join the abandoned one.
    CHECK(!f.ask("b", "3")->joined);
    f.done(0);
    CHECK(f.answers.empty());
    f.dispatcher.worker_idle(0);
    CHECK(f.started.size() == 2);
    f.done(1);
    CHECK(f.answers == Answers{{"3", 200}});
}

TEST_CASE("what a lost worker did is tried once more, before all others") {
    Fixture f;
    f.dispatcher.worker_idle(0);
    f.ask("a", "a");
    f.ask("b", "b");
    f.dispatcher.worker_lost(0);
    CHECK(f.answers.empty());
    f.dispatcher.worker_idle(1);
    REQUIRE(f.started.size() == 2);
    CHECK(f.started[1].second == f.started[0].second);
    f.dispatcher.worker_lost(1);
    CHECK(f.answers == Answers{{"a", 503}});
    f.dispatcher.worker_idle(2);
    f.done(2);
    CHECK(f.answers == Answers{{"a", 503}, {"b", 200}});
}

TEST_CASE("a lost worker that was idle or had a cancelled job changes nothing") {
    Fixture f;
    f.dispatcher.worker_idle(0);
    f.dispatcher.worker_lost(0);
    const auto ticket = f.ask("a", "a");
    CHECK(f.started.empty());
    f.dispatcher.worker_idle(1);
    f.dispatcher.leave(*ticket);
    f.dispatcher.worker_lost(1);
    CHECK(f.dispatcher.queued() == 0);
    CHECK(f.dispatcher.running() == 0);
    CHECK(f.answers.empty());
}

TEST_CASE("a worker that has a view gets what looks at it") {
    Fixture f;
    f.dispatcher.worker_idle(0);
    f.dispatcher.worker_idle(1);
    f.ask("a", "a", 1);
    f.ask("b", "b", 2);
    const int second = f.started[1].first;
    f.done(0);
    f.done(1);
    f.dispatcher.worker_idle(0);
    f.dispatcher.worker_idle(1);
    f.ask("c", "c", 2);
    CHECK(f.started[2].first == second);
}

TEST_CASE("a new generation answers what waits and does not repeat what ran") {
    Fixture f;
    f.dispatcher.worker_idle(0);
    f.ask("a", "a");
    f.ask("b", "b");
    f.dispatcher.begin_generation();
    CHECK(f.answers == Answers{{"b", 503}});
    CHECK(!f.ask("a", "new")->joined);
    f.dispatcher.worker_lost(0);
    CHECK(f.answers == Answers{{"b", 503}, {"a", 503}});
    f.dispatcher.worker_idle(1);
    f.done(1);
    CHECK(f.answers.back() == std::pair<std::string, int>{"new", 200});
}

TEST_CASE("who is told may ask again at once") {
    Dispatcher dispatcher(
        4, {.start = [](int, std::uint64_t, const ImageRequest&) {}, .cancel = [](int, std::uint64_t) {}});
    dispatcher.worker_idle(0);
    bool again = false;
    const auto first = dispatcher.submit("a", {}, [&](const AnswerPtr&) {
        again = !dispatcher.submit("a", {}, [](const AnswerPtr&) {})->joined;
    });
    dispatcher.worker_done(0, first->job, std::make_shared<Answer>());
    CHECK(again);
    CHECK(dispatcher.queued() == 1);
}

TEST_CASE("a request waits for a worker that has its scene, and others pass it") {
    std::vector<std::pair<int, std::uint32_t>> started;
    std::vector<int> statuses;
    Dispatcher dispatcher(
        1, {.start = [&](int worker, std::uint64_t,
                         const ImageRequest& request) { started.emplace_back(worker, request.view.scene); },
            .cancel = [](int, std::uint64_t) {},
            .can =
                [](int worker, const ImageRequest& request) {
                    return static_cast<std::uint32_t>(worker) == request.view.scene;
                }});
    const auto ask = [&](const std::string& key, std::uint32_t scene) {
        ImageRequest request;
        request.view.scene = scene;
        return dispatcher.submit(key, request,
                                 [&](const AnswerPtr& answer) { statuses.push_back(answer->head.status); });
    };
    dispatcher.worker_idle(0);
    CHECK(ask("a", 1));
    CHECK(started.empty());
    CHECK(!ask("b", 1));  // the queue is full
    CHECK(ask("c", 0));
    CHECK(started == std::vector<std::pair<int, std::uint32_t>>{{0, 0}});
    dispatcher.refuse_scene(1);
    CHECK(statuses == std::vector<int>{503});
    CHECK(dispatcher.queued() == 0);
    dispatcher.worker_idle(1);
    dispatcher.worker_away(1);
    CHECK(ask("d", 1));
    CHECK(dispatcher.queued() == 1);
}

TEST_CASE("all who wait for a render are told how far it is, until they leave") {
    Fixture f;
    std::vector<std::string> told;
    const auto ask = [&](const std::string& who) {
        return f.dispatcher.submit(
            "a", {}, [](const AnswerPtr&) {},
            [&told, who](const RenderProgress& progress) {
                told.push_back(who + std::to_string(static_cast<int>(100 * progress.fraction)));
            });
    };
    const auto first = ask("first"), second = ask("second");
    f.ask("a", "silent");
    f.dispatcher.worker_idle(0);
    const auto [worker, job] = f.started.at(0);
    f.dispatcher.worker_progress(worker, job, {.fraction = 0.25});
    CHECK(told == std::vector<std::string>{"first25", "second25"});
    f.dispatcher.leave(*first);
    f.dispatcher.worker_progress(worker, job, {.fraction = 0.5});
    f.dispatcher.worker_progress(worker, job + 1, {.fraction = 0.75});
    f.done(0);
    f.dispatcher.worker_progress(worker, job, {.fraction = 1});
    CHECK(told == std::vector<std::string>{"first25", "second25", "second50"});
    CHECK(f.answers == Answers{{"silent", 200}});
    CHECK(second->joined);
}

TEST_CASE("requests for a retired scene are not tried again") {
    Fixture f;
    f.ask("a", "a");
    f.ask("b", "b");
    f.dispatcher.worker_idle(0);
    f.dispatcher.retire_scene(1);
    CHECK(f.answers.empty());
    f.dispatcher.retire_scene(0);
    CHECK(f.answers == Answers{{"b", 503}});
    f.dispatcher.worker_lost(0);
    CHECK(f.answers == Answers{{"b", 503}, {"a", 503}});
}
