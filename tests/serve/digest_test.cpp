// SPDX-License-Identifier: MIT
#include "digest.hpp"

#include <doctest/doctest.h>

TEST_CASE("digests are those of the standards' examples") {
    CHECK(hex(sha256("abc")) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(hex(sha256("")) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(hex(hmac_sha256("Jefe", "what do ya want for nothing?")) ==
          "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

TEST_CASE("an entity tag is strong and follows from the text") {
    const std::string tag = entity_tag("a");
    CHECK(tag.size() == 34);
    CHECK(tag.front() == '"');
    CHECK(tag.back() == '"');
    CHECK(tag == entity_tag("a"));
    CHECK(tag != entity_tag("b"));
}

TEST_CASE("If-None-Match is a list of tags, or all of them") {
    const std::string tag = entity_tag("a");
    CHECK(matches(tag, tag));
    CHECK(matches("\"x\", " + tag + ",\"y\"", tag));
    CHECK(matches("W/" + tag, tag));
    CHECK(matches(" * ", tag));
    CHECK(!matches("", tag));
    CHECK(!matches("  ", tag));
    CHECK(!matches(entity_tag("b"), tag));
    CHECK(!matches(tag.substr(1, 32), tag));
    CHECK(!matches("\"*\"", tag));
}
