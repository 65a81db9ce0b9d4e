// SPDX-License-Identifier: MIT
#include "specular/high_order_cache.hpp"

#include "files/cache_checks.hpp"
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

TEST_CASE("fitted factors come back from the cache as they were, and files that cannot be used are notices") {
    test::check_cache(
        [](const std::filesystem::path& folder) {
            const Counting material;
            std::vector<std::string> notices;
            HighOrderFactors factors = load_or_fit(material, SplitBasis(2, 5), 1, nullptr, folder,
                                                   [&](const std::string& text) { notices.push_back(text); });
            return test::CacheUse<HighOrderFactors>{std::move(factors), material.calls > 0, notices};
        },
        same);
    const TemporaryFolder scratch;
    const Counting material;
    const HighOrderFactors fitted = load_or_fit(material, SplitBasis(4, 9), 3, nullptr, scratch.path());
    CHECK(fitted.has_base());
    CHECK(fitted.spread() > 0);
    CHECK(same(HighOrderFactors(material, SplitBasis(4, 9), 3), fitted));
    // Other orders and other materials have separate files.
    static_cast<void>(load_or_fit(material, SplitBasis(4, 10), 3, nullptr, scratch.path()));
    static_cast<void>(load_or_fit(material, SplitBasis(3, 9), 3, nullptr, scratch.path()));
    static_cast<void>(load_or_fit(Counting("another"), SplitBasis(4, 9), 3, nullptr, scratch.path()));
    CHECK(files_in(scratch.path()).size() == 4);
    static_cast<void>(load_or_fit(Counting(""), SplitBasis(4, 9), 3, nullptr, scratch.path()));
    static_cast<void>(load_or_fit(material, SplitBasis(4, 9), 3));
    CHECK(files_in(scratch.path()).size() == 4);
}

TEST_CASE("factors that cannot be are not taken") {
    std::vector<float> data(std::size_t{HighOrderFactors::kAngles} * HighOrderFactors::kElements);
    CHECK(HighOrderFactors::stored(1, 1, 0, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(2, 1, 0, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(1, 2, 0, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(1, 0, 0, 1, true, {}));
    CHECK_FALSE(HighOrderFactors::stored(1, 1, 2, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(1, 1, -1, 1, true, data));
    CHECK_FALSE(HighOrderFactors::stored(1, 1, 0, 4, true, data));
    data[7] = HUGE_VALF;
    CHECK_FALSE(HighOrderFactors::stored(1, 1, 0, 1, true, data));
}
