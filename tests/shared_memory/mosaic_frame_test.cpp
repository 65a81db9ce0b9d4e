// SPDX-License-Identifier: MIT
#include "mosaic_frame.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace {

// Memory of its own at an address that is a multiple of 8.
std::vector<std::uint64_t> memory_for(std::size_t width, std::size_t height) {
    return std::vector<std::uint64_t>(MosaicFrame::bytes(width, height) / sizeof(std::uint64_t));
}

}  // namespace

TEST_CASE("a frame is read as it was written, and none before the first") {
    auto memory = memory_for(5, 3);
    MosaicFrame frame(std::as_writable_bytes(std::span(memory)));
    CHECK(frame.words() == 4);  // 15 numbers of 2 bytes
    std::vector<std::uint64_t> read(frame.words());
    CHECK_FALSE(frame.read(read).has_value());
    const std::vector<std::uint64_t> written = {1, 2, 3, 4};
    frame.write({.frame = 7, .time = 9}, written);
    const auto stamp = frame.read(read);
    REQUIRE(stamp.has_value());
    CHECK(stamp->frame == 7);
    CHECK(stamp->time == 9);
    CHECK(read == written);
}

TEST_CASE("no reader takes a frame that the writer has changed meanwhile") {
    constexpr std::uint64_t frames = 20000;
    auto memory = memory_for(64, 32);
    MosaicFrame frame(std::as_writable_bytes(std::span(memory)));
    std::jthread writer([&] {
        std::vector<std::uint64_t> words(frame.words());
        for (std::uint64_t f = 0; f < frames; ++f) {
            std::ranges::fill(words, f);
            frame.write({.frame = f, .time = f}, words);
        }
    });
    std::vector<std::uint64_t> read(frame.words());
    std::uint64_t last = 0;
    bool whole = true;
    bool in_order = true;
    while (last + 1 < frames) {
        const auto stamp = frame.read(read);
        if (!stamp) continue;
        in_order = in_order && stamp->frame >= last;
        last = stamp->frame;
        whole = whole && stamp->time == last && std::ranges::count(read, last) == std::ssize(read);
    }
    CHECK(whole);
    CHECK(in_order);
}
