// SPDX-License-Identifier: MIT
#include "signature.hpp"

#include <doctest/doctest.h>

#include "common/failure.hpp"
#include "refused.hpp"
#include "temporary_folder.hpp"

namespace {

const std::string first(16, 'a'), second(32, 'b');
const std::vector<std::string> keys = {first, second};

Problem refusal(const std::string& target, std::int64_t now = 0) {
    return refused([&] { check_signature(target, keys, now); });
}

}  // namespace

TEST_CASE("what any of the keys signed is taken") {
    for (const std::string& key : keys)
        for (const char* target :
             {"/scenes/a/image.png", "/scenes/a/image.png?size=4x4&azimuth=1", "/?x=%41"})
            CHECK_NOTHROW(check_signature(signed_target(target, key), keys, 0));
}

TEST_CASE("anything else is refused") {
    const std::string good = signed_target("/scenes/a/image.png?size=4x4", first);
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string changed = good;
        changed[i] = changed[i] == 'x' ? 'y' : 'x';
        CHECK_MESSAGE(refusal(changed).status == 403, changed);
    }
    CHECK(refusal("").parameter == "sig");
    CHECK(refusal("/scenes/a/image.png?size=4x4").parameter == "sig");
    CHECK(refusal(good + "&size=9x9").parameter == "sig");
    CHECK(refusal(good.substr(0, good.size() - 1)).parameter == "sig");
    CHECK(refusal(signed_target("/a", std::string(16, 'c'))).parameter == "sig");
}

TEST_CASE("a signed URL holds until it expires") {
    const std::string target = signed_target("/a?expires=1000", first);
    CHECK_NOTHROW(check_signature(target, keys, 1000));
    CHECK(refusal(target, 1001).parameter == "expires");
    CHECK(refusal(signed_target("/a?expires=soon", first)).parameter == "expires");
    CHECK(refusal(signed_target("/a?expires=", first)).parameter == "expires");
}

TEST_CASE("keys come from a file") {
    const TemporaryFolder folder;
    const auto read = [&](const std::string& content) { return read_keys(folder.write("keys", content)); };
    CHECK(read("# one\n\n61616161616161616161616161616161\r\n" + std::string(64, '6') + "\n") ==
          std::vector<std::string>{first, std::string(32, 'f')});
    for (const char* bad : {"", "# none\n", "6161\n", "6161616161616161616161616161616\n",
                            "zz616161616161616161616161616161\n", "6 616161616161616161616161616161616161\n"})
        CHECK_THROWS_AS(read(bad), Failure);
    CHECK_THROWS_AS(read_keys(folder / "none"), Failure);
}
