// SPDX-License-Identifier: MIT
#include "result_cache.hpp"

#include <doctest/doctest.h>

namespace {

AnswerPtr answer(std::size_t bytes) {
    auto result = std::make_shared<Answer>();
    result->content.assign(bytes, 'x');
    return result;
}

}  // namespace

TEST_CASE("the least recently used goes first") {
    ResultCache cache(10);
    cache.keep("a", answer(4));
    cache.keep("b", answer(4));
    CHECK(cache.find("a") != nullptr);
    cache.keep("c", answer(4));
    CHECK(cache.find("a") != nullptr);
    CHECK(cache.find("b") == nullptr);
    CHECK(cache.find("c") != nullptr);
    CHECK(cache.bytes() == 8);
    cache.keep("c", answer(9));  // the key is known, so the answer is not replaced
    CHECK(cache.bytes() == 8);
    cache.clear();
    CHECK(cache.bytes() == 0);
    CHECK(cache.find("a") == nullptr);
}

TEST_CASE("what does not fit is not kept") {
    ResultCache cache(10);
    cache.keep("a", answer(4));
    cache.keep("big", answer(11));
    CHECK(cache.find("big") == nullptr);
    CHECK(cache.find("a") != nullptr);
    ResultCache none(0);
    none.keep("a", answer(1));
    CHECK(none.find("a") == nullptr);
}
