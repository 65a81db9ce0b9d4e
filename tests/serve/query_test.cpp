// SPDX-License-Identifier: MIT
#include "query.hpp"

#include <doctest/doctest.h>

#include "json.hpp"
#include "refused.hpp"

TEST_CASE("a target is a path and named values") {
    const Target target = parse_target("/a%20b/c?x=1&y=&z=%C3%A9%3d");
    CHECK(target.segments == std::vector<std::string>{"a b", "c"});
    REQUIRE(target.query.size() == 3);
    CHECK(*target.find("x") == "1");
    CHECK(target.find("y")->empty());
    CHECK(*target.find("z") == "\xc3\xa9=");
    CHECK(target.find("w") == nullptr);
    CHECK(parse_target("/?").query.empty());
    CHECK(parse_target("/?a=1&").query.size() == 1);
}

TEST_CASE("an encoded slash does not part a path") {
    using Segments = std::vector<std::string>;
    const std::pair<const char*, Segments> cases[] = {
        {"/", {""}},        {"/a", {"a"}},           {"/a/", {"a", ""}},
        {"//a", {"", "a"}}, {"/a%2fb", {"a/b"}},     {"/a%2Fb/c", {"a/b", "c"}},
        {"/%2f", {"/"}},    {"/a%252fb", {"a%2fb"}}, {"/a/../b", {"a", "..", "b"}},
    };
    for (const auto& [target, segments] : cases)
        CHECK_MESSAGE(parse_target(target).segments == segments, target);
}

TEST_CASE("an absolute target names its host") {
    const std::pair<const char*, const char*> cases[] = {
        {"/a", ""},        {"http://h/a", "h"},   {"HTTPS://h:1?b", "h:1"}, {"http://h", "h"},
        {"ftp://h/a", ""}, {"/a?b=http://h", ""}, {"http:///a", ""},
    };
    for (const auto& [target, host] : cases) CHECK(authority_of(target) == host);
}

TEST_CASE("an absolute target is what stands behind its host") {
    const std::pair<const char*, const char*> cases[] = {
        {"/a?b=1", "/a?b=1"},       {"http://h/a?b=1", "/a?b=1"}, {"HTTPS://h:1/a", "/a"},
        {"http://h", "/"},          {"http://h?b=1", "/?b=1"},    {"/a?b=http://h/c", "/a?b=http://h/c"},
        {"http:///a", "http:///a"}, {"ftp://h/a", "ftp://h/a"},   {"*", "*"},
    };
    for (const auto& [target, origin] : cases) CHECK(origin_form(target) == origin);
}

TEST_CASE("a target that means nothing is refused") {
    for (const char* bad : {"", "x", "http://a/", "*", "/%", "/%4", "/%zz", "/a%00", "/a\n", "/%7f", "/?a",
                            "/?=1", "/?a=%1", "/?&a=1"})
        CHECK_MESSAGE(refused([&] { parse_target(bad); }).status == 400, bad);
    const Problem twice = refused([] { parse_target("/?a=1&b=2&%61=3"); });
    CHECK(twice.parameter == "a");
    std::string many = "/?";
    for (int i = 0; i < 33; ++i) many += "p" + std::to_string(i) + "=1&";
    CHECK(refused([&] { parse_target(many); }).detail.find("32") != std::string::npos);
}

TEST_CASE("JSON is JSON, whatever bytes come") {
    CHECK(json_string("a\"b\\c\n\x01\x7f") == "\"a\\\"b\\\\c\\u000a\\u0001\\u007f\"");
    CHECK(json_string("\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80") == "\"\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\"");
    const std::string mark = "\xef\xbf\xbd";
    CHECK(json_string("\xff") == '"' + mark + '"');
    CHECK(json_string("a\xc3") == "\"a" + mark + '"');
    CHECK(json_string("\xed\xa0\x80") == '"' + mark + mark + mark + '"');  // a surrogate
    CHECK(json_string("\xc0\xaf") == '"' + mark + mark + '"');             // overlong
    CHECK(json_string("\xf4\x90\x80\x80") == '"' + mark + mark + mark + mark + '"');
    CHECK(json_number(0.1) == "0.1");
    CHECK(json_number(-0.0) == "0");
    CHECK(json_number(1e300) == "1e+300");
}

TEST_CASE("a problem names the parameter and its range") {
    CHECK(problem_json({.status = 400, .detail = "d", .parameter = "p", .range = "1 to 2"}) ==
          "{\"type\":\"about:blank\",\"title\":\"Bad "
          "Request\",\"status\":400,\"detail\":\"d\",\"parameter\":\"p\","
          "\"range\":\"1 to 2\"}\n");
    CHECK(problem_json({.status = 404, .detail = "d"}) ==
          "{\"type\":\"about:blank\",\"title\":\"Not Found\",\"status\":404,\"detail\":\"d\"}\n");
}
