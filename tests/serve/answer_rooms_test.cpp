// SPDX-License-Identifier: MIT
#include "answer_rooms.hpp"

#include <doctest/doctest.h>

namespace {

AnswerPtr answer_of(std::size_t bytes) {
    auto answer = std::make_shared<Answer>();
    answer->content.assign(bytes, 'x');
    return answer;
}

}  // namespace

TEST_CASE("an answer counts from its request to its last byte") {
    AnswerRooms rooms(100);
    auto first = rooms.reserve("a", 60);
    REQUIRE(first);
    CHECK(rooms.bytes() == 60);
    CHECK(!rooms.reserve("b", 41));
    CHECK(rooms.reserve("b", 40));
    first->settle(answer_of(10));
    CHECK(rooms.bytes() == 10);
    const auto second = rooms.reserve("b", 90);
    CHECK(second);
    first.reset();
    CHECK(rooms.bytes() == 90);
}

TEST_CASE("equal requests share a room") {
    AnswerRooms rooms(100);
    auto first = rooms.reserve("a", 60);
    auto second = rooms.reserve("a", 60);
    CHECK(first == second);
    CHECK(rooms.bytes() == 60);
    first->settle(answer_of(50));
    CHECK(second->answer()->content.size() == 50);
    first.reset();
    CHECK(rooms.bytes() == 50);
    second.reset();
    CHECK(rooms.bytes() == 0);
    CHECK(!rooms.reserve("a", 60)->answer());
}

TEST_CASE("an answer beyond the limit has a room where there is no other") {
    AnswerRooms rooms(100);
    {
        const auto large = rooms.reserve("a", 1000);
        CHECK(large);
        CHECK(!rooms.reserve("b", 1));
    }
    const auto small = rooms.reserve("b", 1);
    CHECK(!rooms.reserve("a", 1000));
}
