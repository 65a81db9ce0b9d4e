// SPDX-License-Identifier: MIT
// What every cache of results does with its files.
#pragma once

#include "temporary_folder.hpp"
#include "test.hpp"

namespace nicol::test {

template <class Value>
struct CacheUse {
    Value value;
    bool computed;  ///< rather than read
    std::vector<std::string> notices;
};

/// use(folder): a CacheUse of one value in a folder; same(a, b): whether two values are equal. Values come
/// back as they were; a file or folder that cannot be used costs a notice and a computation, nothing else.
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
    CHECK(use(folder).notices.size() == 2);  // neither read nor written

    const auto in_the_way = use(scratch.write("file", "in the way"));
    CHECK(in_the_way.computed);
    CHECK(in_the_way.notices.size() == 1);
}

}  // namespace nicol::test
