// SPDX-License-Identifier: MIT
#include "specular/high_order_cache.hpp"

#include "material/counting_material.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using test::Counting;

namespace {

bool same(const HighOrderFactors& a, const HighOrderFactors& b) {
    return a.channels() == b.channels() && a.central_lobe() == b.central_lobe() &&
           a.outer_lobe() == b.outer_lobe() && a.spread() == b.spread() && a.has_base() == b.has_base() &&
           std::ranges::equal(a.data(), b.data());
}

}  // namespace

TEST_CASE("fitted factors come back from the cache as they were") {
    const TemporaryFolder scratch;
    const Counting material;
    const HighOrderFactors fitted = load_or_fit(material, 4, 9, 3, scratch.path());
    const int calls = material.calls;
    CHECK(calls > 0);
    CHECK(fitted.has_base());
    CHECK(fitted.spread() > 0);
    CHECK(same(load_or_fit(material, 4, 9, 3, scratch.path()), fitted));
    CHECK(material.calls == calls);
    CHECK(same(HighOrderFactors(material, 4, 9, 3), fitted));

    // Other orders and other materials have files of their own.
    static_cast<void>(load_or_fit(material, 4, 10, 3, scratch.path()));
    static_cast<void>(load_or_fit(material, 3, 9, 3, scratch.path()));
    static_cast<void>(load_or_fit(Counting("another"), 4, 9, 3, scratch.path()));
    CHECK(files_in(scratch.path()).size() == 4);
    static_cast<void>(load_or_fit(Counting(""), 4, 9, 3, scratch.path()));
    static_cast<void>(load_or_fit(material, 4, 9, 3));
    CHECK(files_in(scratch.path()).size() == 4);
}

TEST_CASE("factors that are stale, damaged, truncated or foreign are fitted anew with a notice") {
    const TemporaryFolder scratch;
    const Counting material;
    const HighOrderFactors fitted = load_or_fit(material, 2, 5, 1, scratch.path());
    const auto file = files_in(scratch.path()).front();
    const std::string good = file_bytes(file);
    std::string stale = good;
    stale[8] ^= 1;
    for (const std::string& bytes : {stale, good.substr(0, good.size() - 1), std::string("foreign")}) {
        write_bytes(file, bytes);
        material.calls = 0;
        int notices = 0;
        const HighOrderFactors factors =
            load_or_fit(material, 2, 5, 1, scratch.path(), [&](const std::string& text) {
                ++notices;
                CHECK(text.find(file.filename().string()) != std::string::npos);
            });
        CHECK(notices == 1);
        CHECK(material.calls > 0);
        CHECK(same(factors, fitted));
        CHECK(file_bytes(file) == good);
    }
}

TEST_CASE("factors that cannot be are not taken") {
    std::vector<float> data(std::size_t{HighOrderFactors::kAngles} * HighOrderFactors::kElements);
    CHECK(HighOrderFactors::stored(1, 0, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(2, 0, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(1, 2, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(1, -1, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(1, 0, 4, true, data));
    data[7] = HUGE_VALF;
    CHECK_FALSE(HighOrderFactors::stored(1, 0, 1, true, data));
}
