// SPDX-License-Identifier: MIT
// Pictures as light: directions, files, refusals.
#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>

#include "image/temporary_folder.hpp"
#include "light/directions.hpp"

using namespace nicol;
using std::numbers::pi;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

EquirectImage grey_picture(int width, int height) {
    EquirectImage image(width, height, 1);
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1;
    return image;
}

}  // namespace

TEST_CASE("a bright pixel lies in its direction") {
    // Of 6 columns, column 1 is at u = 1/4 (+x) and 4 at u = 3/4 (-x); of 8 columns, none is on an axis.
    EquirectImage image(6, 5, 1);
    image.at(0, 2, 1)[0] = 7;
    image.at(0, 2, 4)[0] = 3;
    image.at(0, 0, 0)[0] = 5;
    const auto light = image_environment(image);
    CHECK(light->radiance(0, {1, 0, 0})[0] == doctest::Approx(7));
    CHECK(light->radiance(0, {-1, 0, 0})[0] == doctest::Approx(3));
    CHECK(light->radiance(0, {0, 0, 1})[0] == doctest::Approx(0));
    CHECK(light->radiance(0, {0, -1, 0})[0] == doctest::Approx(0));
    // Half a row up from +x, half a column towards +z.
    CHECK(light->radiance(0, towards(0.25, 0.375))[0] == doctest::Approx(3.5));
    CHECK(light->radiance(0, towards(0.25 + 1.0 / 12, 0.5))[0] == doctest::Approx(3.5));

    // -z is the seam: half of the last column, half of the first.
    EquirectImage seam(6, 5, 1);
    seam.at(0, 2, 0)[0] = 2;
    seam.at(0, 2, 5)[0] = 4;
    const auto front = image_environment(seam);
    CHECK(front->radiance(0, {0, 0, -1})[0] == doctest::Approx(3));
    CHECK(front->radiance(0, towards(0.02, 0.5))[0] < 3);
    CHECK(front->radiance(0, towards(0.98, 0.5))[0] > 3);

    EquirectImage above(6, 5, 1);
    for (int x = 0; x < 6; ++x) above.at(0, 0, x)[0] = 9;
    CHECK(image_environment(above)->radiance(0, {0, 1, 0})[0] == doctest::Approx(9));
    CHECK(image_environment(above)->radiance(0, {0, -1, 0})[0] == doctest::Approx(0));
}

TEST_CASE("Stokes components come back in the theta-phi frame about z") {
    const EquirectImage image = random_picture(8, 5, 2, 11);
    const auto light = image_environment(image);
    for (int y = 1; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            const double u = (x + 0.5) / 8;
            const double v = y / 4.0;
            const glm::dvec3 w = towards(u, v);
            const Stokes in_picture =
                turned(light->radiance(1, w), angle_between(theta_phi_frame(-w), pixel_frame(u, v)));
            CHECK(glm::length(in_picture - image.stokes(1, y, x)) < 1e-7);
        }
}

TEST_CASE("picture() gives the pixels back, times the scale") {
    const EquirectImage image = random_picture(6, 4, 3, 12);
    const EquirectImage twice = image_environment(image, 2)->picture();
    REQUIRE(twice.data.size() == image.data.size());
    for (std::size_t i = 0; i < image.data.size(); ++i) CHECK(twice.data[i] == 2 * image.data[i]);
    const EquirectImage plain = random_picture(6, 4, 3, 12, false);
    CHECK(image_environment(plain)->picture().data == plain.data);
}

TEST_CASE("what is zero is not counted as polarization") {
    EquirectImage image = grey_picture(4, 3);
    CHECK_FALSE(image_environment(image)->polarized());
    image.at(0, 1, 2)[3] = 0.5f;
    CHECK(image_environment(image)->polarized());
    CHECK(image_environment(image)->circular());
    image.at(0, 1, 2)[3] = 0;
    image.at(0, 1, 2)[2] = -0.5f;
    CHECK(image_environment(image)->polarized());
    CHECK_FALSE(image_environment(image)->circular());
    CHECK_FALSE(image_environment(image, 0)->polarized());
}

TEST_CASE("pictures that are no light are refused by pixel") {
    const auto bad = ErrorCode::invalid_argument;
    const auto refuse = [&](int component, float value, const char* what) {
        EquirectImage image = random_picture(5, 4, 2, 1, false);
        image.at(1, 2, 3)[static_cast<std::size_t>(component)] = value;
        check_error(
            bad, [&] { (void)image_environment(image); }, "channel 1", "pixel (3, 2)", what);
    };
    refuse(0, -0.2f, "s0 < 0");
    refuse(0, not_a_number, "finite");
    refuse(1, not_a_number, "finite");
    refuse(3, -infinity, "finite");
    refuse(2, 1.7f, "more than fully");
    // Rounding and lossy compression are forgiven.
    EquirectImage rounded = grey_picture(4, 3);
    rounded.at(0, 1, 1)[1] = -1.005f;
    CHECK_NOTHROW((void)image_environment(rounded));

    check_error(
        bad, [] { (void)image_environment(grey_picture(1, 4)); }, "1 x 4", "2 x 2");
    check_error(
        bad, [] { (void)image_environment(grey_picture(4, 1)); }, "4 x 1", "2 x 2");
    check_error(
        bad, [] { (void)image_environment(EquirectImage()); }, "image");
    EquirectImage ragged = grey_picture(4, 3);
    ragged.data.pop_back();
    check_error(
        bad, [&] { (void)image_environment(ragged); }, "47", "48");
    for (const double scale : {-1.0, double{not_a_number}, double{infinity}})
        check_error(
            bad, [&] { (void)image_environment(grey_picture(4, 3), scale); }, "scale");
    check_error(
        bad, [] { (void)image_environment(grey_picture(4, 3), 1e300); }, "pixel (0, 0)", "finite");
}

TEST_CASE("files: polarized by their channels, errors by their name") {
    const TemporaryFolder folder;
    const EquirectImage image = random_picture(8, 5, 3, 5);
    write_exr(folder / "polarized.exr", image);
    const auto polarized = load_environment(folder / "polarized.exr", 0.5);
    CHECK(polarized->polarized());
    CHECK(polarized->channels() == 3);
    CHECK(polarized->picture().at(2, 3, 4)[1] == 0.5f * image.at(2, 3, 4)[1]);

    write_exr(folder / "plain.exr", image, {.components = 0});
    const auto plain = load_environment(folder / "plain.exr");
    CHECK_FALSE(plain->polarized());
    CHECK(plain->picture().at(2, 3, 4)[0] == image.at(2, 3, 4)[0]);

    EquirectImage negative = image;
    negative.at(1, 2, 3)[0] = -1;
    write_exr(folder / "negative.exr", negative);
    check_error(
        ErrorCode::invalid_file, [&] { (void)load_environment(folder / "negative.exr"); }, "negative.exr",
        "channel 1", "pixel (3, 2)");
    check_error(
        ErrorCode::file_not_found, [&] { (void)load_environment(folder / "none.exr"); }, "none.exr");
    check_error(
        ErrorCode::invalid_argument, [&] { (void)load_environment(folder / "plain.exr", -1); }, "scale");
}

TEST_CASE("environments of third parties load, and their mean is that of their pixels") {
    const char* data = std::getenv("NICOL_TEST_DATA");
    const std::filesystem::path folder = std::filesystem::path(data != nullptr ? data : "") / "mitsuba";
    for (const char* name : {"env.exr", "venice.exr"}) {
        if (!std::filesystem::exists(folder / name)) {
            MESSAGE("skipped: no ", name);
            continue;
        }
        const auto light = load_environment(folder / name);
        CHECK(light->channels() == 3);
        CHECK_FALSE(light->polarized());
        const PshVector f = light->project(3);
        const EquirectImage picture = light->picture();
        for (int c = 0; c < 3; ++c) {
            double sum = 0;
            double area = 0;
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x) {
                    const double weight = std::sin(pi * y / (picture.height - 1.0));
                    sum += weight * picture.at(c, y, x)[0];
                    area += weight;
                }
            CHECK(f.at(c, 0, 0, 0) == doctest::Approx(std::sqrt(4 * pi) * sum / area).epsilon(1e-4));
        }
    }
}
