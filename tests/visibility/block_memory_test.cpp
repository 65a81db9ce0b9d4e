// SPDX-License-Identifier: MIT
#include "visibility/block_memory.hpp"

#include <numeric>

#include "test.hpp"

using namespace nicol;

namespace {

using Sixteen = std::array<int, kLanes>;

constexpr std::size_t kSize = 3;  // values of a vertex

// Returns blocks in which vertex v has the values 10 v, 10 v + 1 and 10 v + 2.
BlockMemory<Sixteen> blocks_of(std::size_t vertices) {
    BlockMemory<Sixteen> out;
    out.resize((vertices + kLanes - 1) / kLanes);
    for (std::size_t v = 0; v < vertices; ++v) {
        if (v % kLanes == 0) out.allocate(v / kLanes, kSize);
        for (std::size_t k = 0; k < kSize; ++k)
            out.at(v / kLanes)[k][v % kLanes] = static_cast<int>(10 * v + k);
    }
    return out;
}

void copy_lane(Sixteen* to, std::size_t lane, const Sixteen* from, std::size_t lane_before) {
    for (std::size_t k = 0; k < kSize; ++k) to[k][lane] = from[k][lane_before];
}

std::vector<std::uint32_t> consecutive(std::uint32_t first, std::size_t count) {
    std::vector<std::uint32_t> out(count);
    std::iota(out.begin(), out.end(), first);
    return out;
}

const auto all = [](std::size_t) { return true; };

}  // namespace

TEST_CASE("values follow their vertices, and whole blocks are not copied") {
    BlockMemory<Sixteen> memory = blocks_of(70);
    const Sixteen* const second = memory.at(1);
    const Sixteen* const fourth = memory.at(3);
    // The first and the last block have mixed vertices, the second stays, and a former block comes twice.
    std::vector<std::uint32_t> former = consecutive(64, 6);
    former.resize(16, 69);
    for (const std::uint32_t first : {16U, 48U, 48U, 5U}) {
        const std::vector<std::uint32_t> block = consecutive(first, 16);
        former.insert(former.end(), block.begin(), block.end());
    }
    CHECK(memory.renumber(former, kSize, all, copy_lane).empty());
    REQUIRE(memory.blocks() == 5);
    CHECK(memory.at(1) == second);
    CHECK(memory.at(2) == fourth);
    CHECK(memory.at(3) != fourth);
    for (std::size_t v = 0; v < former.size(); ++v) {
        CAPTURE(v);
        for (std::size_t k = 0; k < kSize; ++k)
            CHECK(memory.at(v / kLanes)[k][v % kLanes] == static_cast<int>(10 * former[v] + k));
    }
}

TEST_CASE("vertices of wanted blocks without former values are returned") {
    BlockMemory<Sixteen> memory = blocks_of(48);
    std::vector<std::uint32_t> former = consecutive(0, 64);
    former[20] = kNoVertex;
    std::vector<std::uint32_t> expected{20};
    const std::vector<std::uint32_t> last = consecutive(48, 16);  // beyond the former vertices
    expected.insert(expected.end(), last.begin(), last.end());
    const auto wanted = [](std::size_t block) { return block != 2; };
    const Sixteen* const second = memory.at(1);
    CHECK(memory.renumber(former, kSize, wanted, copy_lane) == expected);
    CHECK(memory.at(1) == second);  // all of its other vertices stay in place
    CHECK(memory.at(2) == nullptr);
    CHECK(memory.count() == 3);
    for (std::size_t v = 0; v < 32; ++v) {
        CAPTURE(v);
        if (v != 20) CHECK(memory.at(v / kLanes)[1][v % kLanes] == static_cast<int>(10 * v + 1));
    }
}
