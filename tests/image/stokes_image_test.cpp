// SPDX-License-Identifier: MIT
// Tests of the sizes and layout of Stokes images.
#include "image/stokes_image.hpp"

#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("pixels lie channel by channel, row by row, four floats each") {
    StokesImage image(5, 3, 2);
    REQUIRE(image.data.size() == 5 * 3 * 2 * 4);
    image.at(1, 2, 4)[3] = 8;
    CHECK(image.data.back() == 8);
    image.at(0, 1, 0)[0] = 2;
    CHECK(image.data[5 * 4] == 2);
    image.at(1, 0, 0)[2] = 3;
    CHECK(image.data[5 * 3 * 4 + 2] == 3);
    CHECK(image.stokes(1, 0, 0) == Stokes(0, 0, 3, 0));
}

TEST_CASE("access outside is refused") {
    const auto bad = ErrorCode::invalid_argument;
    StokesImage image(5, 3, 2);
    check_error(bad, CALL(image.at(2, 0, 0)), "channel 2", "2 channels");
    check_error(bad, CALL(image.at(-1, 0, 0)), "channel -1");
    check_error(bad, CALL(image.at(0, 3, 0)), "y 3");
    check_error(bad, CALL(image.at(0, 0, 5)), "x 5");
    check_error(bad, CALL(image.stokes(0, -1, 0)), "y -1");
    check_error(bad, CALL(StokesImage().at(0, 0, 0)), "outside");
    image.data.resize(7);
    check_error(bad, CALL(image.at(1, 2, 4)), "shorter");
}

TEST_CASE("sizes out of range are refused before anything is allocated") {
    const auto bad = ErrorCode::invalid_argument;
    constexpr int huge = std::numeric_limits<int>::max();
    check_error(bad, CALL(StokesImage(0, 3, 1)), "0 x 3");
    check_error(bad, CALL(StokesImage(3, -1, 1)), "3 x -1");
    check_error(bad, CALL(StokesImage(3, 3, 0)), "0 channels");
    check_error(bad, CALL(StokesImage(huge, huge, 3)), "2147483647");
    check_error(bad, CALL(StokesImage(kMaxImageSide, kMaxImageSide, 1)), "pixels at most");
    check_error(bad, CALL(StokesImage(2, 2, huge)), "channels 1 to");
}

TEST_CASE("check() names the image and the size it should have") {
    StokesImage image(2, 2, 1);
    CHECK_NOTHROW(image.check("this"));
    image.data.pop_back();
    check_error(ErrorCode::invalid_argument, CALL(image.check("this")), "this", "15", "16");
    check_error(ErrorCode::invalid_argument, CALL(StokesImage().check("that")), "that");
}
