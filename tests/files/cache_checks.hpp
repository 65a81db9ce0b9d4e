// SPDX-License-Identifier: MIT
// Checks that hold for every cache of results.
#pragma once

#include "temporary_folder.hpp"
#include "test.hpp"

namespace nicol::test {

template <class Value>
struct CacheUse {
    Value value;
    bool computed;  ///< whether the value was computed and not read
    std::vector<std::string> notices;
};

/// Checks a cache. use(folder) returns the CacheUse of one value in a folder, and same(a, b) whether two
/// values are equal. Values must come back unchanged. An unusable file or folder must cost a notice and a
/// computation, nothing else.
template <class Use, class Same>
void check_cache(const Use& use, const Same& same) {
    const TemporaryFolder scratch;
    const auto folder = scratch / "made/on/demand";
    const auto first = use(folder);
    CHECK(first.computed);
    CHECK(first.notices.empty());
    const auto again = use(folder);
    CHECK_FALSE(again.computed);
    CHECK(again.notices.empty());
    CHECK(same(first.value, again.value));
    REQUIRE(files_in(folder).size() == 1);

    const auto file = files_in(folder).front();
    const std::string good = file_bytes(file);
    std::string stale = good;
    stale[8] ^= 1;
    for (const std::string& bytes : {stale, good.substr(0, good.size() - 1), std::string("foreign")}) {
        write_bytes(file, bytes);
        const auto anew = use(folder);
        CHECK(anew.computed);
        REQUIRE(anew.notices.size() == 1);
        CHECK(anew.notices[0].find(file.string()) == 0);
        CHECK(same(first.value, anew.value));
        CHECK(file_bytes(file) == good);
    }
    std::filesystem::remove(file);
    std::filesystem::create_directory(file);
    CHECK(use(folder).notices.size() == 2);  // one for reading, one for writing

    const auto in_the_way = use(scratch.write("file", "in the way"));
    CHECK(in_the_way.computed);
    CHECK(in_the_way.notices.size() == 1);
}

}  // namespace nicol::test
