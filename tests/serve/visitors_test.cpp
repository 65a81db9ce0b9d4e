// SPDX-License-Identifier: MIT
#include "visitors.hpp"

#include <doctest/doctest.h>

TEST_CASE("the service answers for loopback names, its address and the names that are allowed") {
    const std::vector<std::string> allowed = {"images.example"};
    const std::pair<const char*, bool> cases[] = {
        {"localhost", true},
        {"LocalHost:80", true},
        {"localhost.", true},
        {"127.0.0.1:8080", true},
        {"[::1]", true},
        {"[::1]:80", true},
        {"192.0.2.7:1", true},
        {"images.example", true},
        {"IMAGES.example.", true},
        {"a.images.example", false},
        {"192.0.2.8", false},
        {"evil.example", false},
        {"localhost.evil", false},
        {"evil.localhost", false},
        {"[::1", false},
        {"[::1]x:80", false},
        {"localhost:80@e", false},
        {"localhost:", true},
        {"*", false},
        {":80", false},
    };
    for (const auto& [host, answered] : cases)
        CHECK_MESSAGE(answers_for(host, "192.0.2.7", allowed) == answered, host);
    CHECK(answers_for("evil.example", "192.0.2.7", {"*"}));
    CHECK(answers_for("[2001:db8::1]:80", "2001:db8::1", {}));
}
