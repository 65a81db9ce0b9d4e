// SPDX-License-Identifier: MIT
// Tests of visibility that stays where it changes little.
#include "render/shown_visibility.hpp"

#include "test.hpp"

using namespace nicol;

namespace {

constexpr std::size_t kDirections = 256;

// Returns visibility whose vertices see all directions but the first ones, so many of each vertex.
std::shared_ptr<const Visibility> hiding(const std::vector<std::size_t>& hidden) {
    auto out = std::make_shared<Visibility>(kDirections, hidden.size());
    for (std::size_t v = 0; v < hidden.size(); ++v) {
        for (std::size_t d = hidden[v]; d < kDirections; ++d)
            out->at(v)[d / 64] |= std::uint64_t{1} << (d % 64);
        out->set_unoccluded(v, hidden[v] == 0);
    }
    return out;
}

std::size_t hidden(const Visibility& visibility, std::size_t vertex) {
    std::size_t count = 0;
    for (std::size_t d = 0; d < kDirections; ++d) count += visibility.seen(vertex, d) ? 0 : 1;
    return count;
}

}  // namespace

TEST_CASE("small changes are not shown until they add up to a large one") {
    ShownVisibility shown;
    shown.show(hiding({0, 10, 10, 10}));
    CHECK(shown.lagging().empty());
    // The last vertex is new, and the others have other numbers.
    std::vector<std::uint32_t> former{1, 0, 2, kNoVertex};
    shown.follow(hiding({12, 2, 13, 5}), former, 2);
    CHECK(former == std::vector<std::uint32_t>{1, 0, kNoVertex, kNoVertex});
    CHECK(std::ranges::equal(shown.lagging(), std::array<std::uint8_t, 4>{1, 1, 0, 0}));
    const std::array<std::size_t, 4> expected{10, 0, 13, 5};
    for (std::size_t v = 0; v < 4; ++v) CHECK(hidden(*shown.get(), v) == expected[v]);
    CHECK(shown.get()->unoccluded(1));

    former = {0, 1, 2, 3};
    shown.follow(hiding({13, 1, 13, 5}), former, 2);
    CHECK(former == std::vector<std::uint32_t>{kNoVertex, 1, 2, 3});
    CHECK(hidden(*shown.get(), 0) == 13);
    CHECK(hidden(*shown.get(), 1) == 0);

    former = {0, 1, 2, 3};
    const auto exact = hiding({13, 1, 13, 5});
    shown.follow(exact, former, 0);
    CHECK(former == std::vector<std::uint32_t>{0, kNoVertex, 2, 3});
    CHECK(shown.get() == exact.get());
}
