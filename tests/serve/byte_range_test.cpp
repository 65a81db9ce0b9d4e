// SPDX-License-Identifier: MIT
#include "byte_range.hpp"

#include <doctest/doctest.h>

TEST_CASE("a Range header of one range is a part of the answer, and others are ignored") {
    constexpr std::string_view everything = "everything", nothing = "nothing";
    struct Case {
        std::string_view range, if_range, wanted;
    };
    // The content has 1000 bytes.
    const Case cases[] = {{"bytes=0-0", "", "bytes 0-0/1000"},
                          {"bytes=10-19", "", "bytes 10-19/1000"},
                          {"bytes=10-19", "\"tag\"", "bytes 10-19/1000"},
                          {"bytes=10-19", "\"former\"", everything},
                          {"bytes=990-", "", "bytes 990-999/1000"},
                          {"bytes=990-5000", "", "bytes 990-999/1000"},
                          {"bytes=-10", "", "bytes 990-999/1000"},
                          {"bytes=-5000", "", "bytes 0-999/1000"},
                          {"bytes=1000-", "", nothing},
                          {"bytes=-0", "", nothing},
                          {"", "", everything},
                          {"bytes=", "", everything},
                          {"bytes=-", "", everything},
                          {"bytes=5", "", everything},
                          {"bytes=9-5", "", everything},
                          {"bytes=0-1,5-6", "", everything},
                          {"bytes=a-b", "", everything},
                          {"bytes=+1-2", "", everything},
                          {"bytes=1-99999999999999999999", "", everything},
                          {"pixels=0-9", "", everything}};
    for (const Case& c : cases) {
        CAPTURE(c.range);
        CAPTURE(c.if_range);
        const WantedBytes wanted = wanted_bytes(c.range, c.if_range, "\"tag\"", 1000);
        const auto* const part = std::get_if<ByteRange>(&wanted);
        const std::string text = part != nullptr                              ? content_range(*part, 1000)
                                 : std::holds_alternative<Everything>(wanted) ? std::string(everything)
                                                                              : std::string(nothing);
        CHECK(text == c.wanted);
    }
    CHECK(std::holds_alternative<NothingThere>(wanted_bytes("bytes=0-", "", "", 0)));
}
