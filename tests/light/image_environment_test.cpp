// SPDX-License-Identifier: MIT
// Tests of images as light: directions, files, refusals.
#include "image/observer.hpp"
#include "light/images.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

EquirectImage grey_image(int width, int height) {
    EquirectImage image(width, height, 1);
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1;
    return image;
}

}  // namespace

TEST_CASE("a bright pixel lies in its direction") {
    // With 6 columns, column 1 is at u = 1/4 (+x) and column 4 at u = 3/4 (-x). With 8 columns, none is on an
    // axis.
    EquirectImage image(6, 5, 1);
    image.at(0, 2, 1)[0] = 7;
    image.at(0, 2, 4)[0] = 3;
    image.at(0, 0, 0)[0] = 5;
    const auto light = image_environment(image);
    CHECK(light->radiance(0, {1, 0, 0})[0] == doctest::Approx(7));
    CHECK(light->radiance(0, {-1, 0, 0})[0] == doctest::Approx(3));
    CHECK(light->radiance(0, {0, 0, 1})[0] == doctest::Approx(0));
    CHECK(light->radiance(0, {0, -1, 0})[0] == doctest::Approx(0));
    // These directions are half a row up from +x and half a column towards +z.
    CHECK(light->radiance(0, towards(0.25, 0.375))[0] == doctest::Approx(3.5));
    CHECK(light->radiance(0, towards(0.25 + 1.0 / 12, 0.5))[0] == doctest::Approx(3.5));

    // The seam -z shows half of the last column and half of the first.
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
    const EquirectImage image = random_image(8, 5, 2, 11);
    const auto light = image_environment(image);
    for (int y = 1; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            const double u = (x + 0.5) / 8;
            const double v = y / 4.0;
            const glm::dvec3 w = towards(u, v);
            const Stokes in_image =
                rotated(light->radiance(1, w), angle_between(theta_phi_frame(-w), pixel_frame(u, v)));
            CHECK(glm::length(in_image - image.stokes(1, y, x)) < 1e-7);
        }
}

TEST_CASE("image() gives the pixels back, times the scale") {
    const EquirectImage image = random_image(6, 4, 3, 12);
    const EquirectImage twice = image_environment(image, 2)->image();
    REQUIRE(twice.data.size() == image.data.size());
    for (std::size_t i = 0; i < image.data.size(); ++i) CHECK(twice.data[i] == 2 * image.data[i]);
    const EquirectImage plain = random_image(6, 4, 3, 12, false);
    CHECK(image_environment(plain)->image().data == plain.data);
}

TEST_CASE("what is zero is not counted as polarization") {
    EquirectImage image = grey_image(4, 3);
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

TEST_CASE("images that are no light are refused") {
    const auto bad = ErrorCode::invalid_argument;
    // Slight excess from rounding or lossy compression is accepted.
    EquirectImage rounded = grey_image(4, 3);
    rounded.at(0, 1, 1)[1] = -1.005f;
    CHECK_NOTHROW((void)image_environment(rounded));

    check_error(bad, CALL(image_environment(grey_image(1, 4))), "1 x 4", "2 x 2");
    check_error(bad, CALL(image_environment(grey_image(4, 1))), "4 x 1", "2 x 2");
    check_error(bad, CALL(image_environment(EquirectImage())), "image");
    EquirectImage ragged = grey_image(4, 3);
    ragged.data.pop_back();
    check_error(bad, CALL(image_environment(ragged)), "47", "48");
    for (const double scale : {-1.0, double{not_a_number}, double{infinity}})
        check_error(bad, CALL(image_environment(grey_image(4, 3), scale)), "scale");
    check_error(bad, CALL(image_environment(grey_image(4, 3), 1e300)), "pixel (0, 0)", "finite");
}

TEST_CASE("negative unpolarized pixels become 0 unless they are much of the light") {
    // The middle row of 5 has weight 1, the rows beside it sin(pi/4), and the poles 0. An image of ones
    // weighs 4 (1 + sqrt(2)) columns.
    EquirectImage image = grey_image(4, 5);
    const auto positive = static_cast<float>(4 * (1 + std::sqrt(2.0)) - 1);
    for (const float share : {0.01f, 0.24f}) {
        image.at(0, 2, 1)[0] = -share * positive;
        const auto light = image_environment(image);
        CHECK(light->image().at(0, 2, 1)[0] == 0);
        CHECK(light->image().at(0, 2, 2)[0] == 1);
        CHECK(light->radiance(0, towards(0.375, 0.5))[0] == 0);
        CHECK(light->negative_share() == doctest::Approx(share).epsilon(1e-5));
        CHECK(notice_of_negative(*light, "a.exr")
                  .starts_with(share < 0.1 ? "a.exr: has negative radiance, up to 1 %"
                                           : "a.exr: has negative radiance, up to 24 %"));
    }
    CHECK(notice_of_negative(*image_environment(grey_image(4, 5)), "a.exr").empty());
    for (const float share : {0.26f, 1.0f, 100.0f}) {
        image.at(0, 2, 1)[0] = -share * positive;
        check_error(ErrorCode::invalid_argument, CALL(image_environment(image)), "channel 0", "pixel (1, 2)",
                    "s0 < 0");
    }
    // A pole pixel has no solid angle.
    EquirectImage pole = grey_image(4, 5);
    pole.at(0, 0, 1)[0] = -100;
    CHECK(image_environment(pole)->image().at(0, 0, 1)[0] == 0);
    // Negative light is refused even in small amounts if it is polarized or if there is no other light.
    EquirectImage polarized = grey_image(4, 5);
    polarized.at(0, 2, 1)[0] = -1e-4f;
    polarized.at(0, 2, 1)[2] = 1e-5f;
    check_error(ErrorCode::invalid_argument, CALL(image_environment(polarized)), "pixel (1, 2)", "s0 < 0");
    EquirectImage dark(4, 5, 1);
    dark.at(0, 2, 3)[0] = -1e-6f;
    check_error(ErrorCode::invalid_argument, CALL(image_environment(dark)), "pixel (3, 2)", "s0 < 0");
}

TEST_CASE("every column of an image is checked, and what is no light named by channel and pixel") {
    for (const int width : {2, 3, 4, 5, 8, 11}) {
        const EquirectImage good = random_image(width, 3, 2, 8);
        CHECK_NOTHROW((void)image_environment(good));
        for (int x = 0; x < width; ++x)
            for (std::size_t p = 0; p < 4; ++p)
                for (const float wrong : {not_a_number, infinity, -infinity, p == 0 ? -1e3f : 1e3f}) {
                    EquirectImage image = good;
                    image.at(1, 1, x)[p] = wrong;
                    const char* what = !std::isfinite(wrong) ? "finite"
                                       : p == 0              ? "s0 < 0"
                                                             : "more than fully";
                    check_error(ErrorCode::invalid_argument, CALL(image_environment(image)), "channel 1",
                                "pixel (" + std::to_string(x) + ", 1)", what);
                }
        // The check works even if squares are out of the range of float.
        for (const float size : {1e-30f, 1e25f}) {
            EquirectImage extreme(width, 3, 1);
            for (std::size_t i = 0; i < extreme.data.size(); i += 4) extreme.data[i] = size;
            CHECK_NOTHROW((void)image_environment(extreme));
            extreme.at(0, 2, width - 1)[3] = 2 * size;
            check_error(ErrorCode::invalid_argument, CALL(image_environment(extreme)), "more than fully");
        }
    }
}

TEST_CASE("a view gives the light of the image it shows, whatever its layout") {
    for (const int components : {1, 4}) {
        const EquirectImage image = random_image(12, 7, 3, 13, components == 4);
        const auto light = image_environment(image, 2);
        // The channels of a pixel are adjacent, and rows have a gap.
        const auto n = static_cast<std::size_t>(components);
        const std::size_t row_stride = 12 * 3 * n + 5;
        std::vector<float> values(7 * row_stride, not_a_number);
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < 7; ++y)
                for (int x = 0; x < 12; ++x)
                    for (std::size_t p = 0; p < n; ++p)
                        values[static_cast<std::size_t>(y) * row_stride +
                               (static_cast<std::size_t>(x) * 3 + static_cast<std::size_t>(c)) * n + p] =
                            image.at(c, y, x)[p];
        EquirectView view{12, 7, 3, components, values.data(), n, row_stride, 3 * n};
        CHECK(image_environment(view, 2)->image().data == light->image().data);
        CHECK(image_environment(view)->polarized() == (components == 4));
        for (const int order : {4, 40}) {
            const PshVector have = project_image(view, order);
            const PshVector want = image_environment(image)->project(order);
            for (std::size_t i = 0; i < want.data().size(); ++i)
                CHECK(have.data()[i] == doctest::Approx(want.data()[i]).epsilon(1e-12));
        }
        const auto refused = [&](const char* what) {
            check_error(ErrorCode::invalid_argument, CALL(image_environment(view)), what);
            check_error(ErrorCode::invalid_argument, CALL(project_image(view, 2)), what);
        };
        check_error(ErrorCode::invalid_argument, CALL(project_image(view, -1)), "order");
        view.components = 3;
        refused("components is 3");
        view.components = components;
        view.width = 1;
        refused("1 x 7");
        view.width = 40000;
        refused("40000");
        view.width = 12;
        view.channels = 0;
        refused("0 channels");
        view.channels = 3;
        view.values = nullptr;
        refused("null");
    }
}

TEST_CASE("coefficients of a view with negative pixels are those of its light") {
    EquirectImage image = random_image(12, 7, 1, 14, false);
    image.at(0, 3, 4)[0] = -0.5f;
    EquirectImage repaired = image;
    repaired.at(0, 3, 4)[0] = 0;
    const EquirectView view{12, 7, 1, 4, image.data.data(), image.data.size(), 48, 4};
    const PshVector have = project_image(view, 6);
    const PshVector want = image_environment(repaired)->project(6);
    CHECK(std::ranges::equal(have.data(), want.data()));
}

TEST_CASE("an image of the largest size that is sold has its mean") {
    constexpr int width = 16384, height = 8192;
    std::vector<float> values(std::size_t{width} * height, 1.0F);
    for (std::size_t i = 0; i < values.size(); i += 2) values[i] = 3;
    const EquirectView view{.width = width,
                            .height = height,
                            .channels = 1,
                            .components = 1,
                            .values = values.data(),
                            .channel_stride = values.size(),
                            .row_stride = width,
                            .pixel_stride = 1};
    CHECK(image_environment(view)->project(1).data()[0] ==
          doctest::Approx(2 * 2 * std::sqrt(std::numbers::pi)));
}

TEST_CASE("files: polarized by their channels, errors by their name") {
    const TemporaryFolder folder;
    const EquirectImage image = random_image(8, 5, 3, 5);
    write_exr(folder / "polarized.exr", image);
    const auto polarized = load_environment(folder / "polarized.exr", 0.5);
    CHECK(polarized->polarized());
    CHECK(polarized->channels() == 3);
    CHECK(polarized->image().at(2, 3, 4)[1] == 0.5f * image.at(2, 3, 4)[1]);

    write_exr(folder / "plain.exr", image, {.components = 0});
    const auto plain = load_environment(folder / "plain.exr");
    CHECK_FALSE(plain->polarized());
    CHECK(plain->image().at(2, 3, 4)[0] == image.at(2, 3, 4)[0]);

    EquirectImage negative = image;
    negative.at(1, 2, 3)[0] = -100;
    write_exr(folder / "negative.exr", negative);
    check_error(ErrorCode::invalid_file, CALL(load_environment(folder / "negative.exr")), "negative.exr",
                "channel 1", "pixel (3, 2)");
    check_error(ErrorCode::file_not_found, CALL(load_environment(folder / "none.exr")), "none.exr");
    // The name is longer than the system allows.
    check_error(ErrorCode::file_not_found, CALL(load_environment(folder / std::string(300, 'a'))), "aaaa");
    check_error(ErrorCode::invalid_argument, CALL(load_environment(folder / "plain.exr", -1)), "scale");
}

TEST_CASE("environments of third parties load") {
    for (const char* name : {"mitsuba/env.exr", "mitsuba/venice.exr"}) {
        const auto file = test_data(name);
        if (file.empty()) continue;
        const auto light = load_environment(file);
        CHECK(light->channels() == 3);
        CHECK_FALSE(light->polarized());
    }
}

TEST_CASE("photographs in Radiance HDR and in eight bits are light") {
    const TemporaryFolder folder;
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n";
    for (int i = 0; i < 4; ++i) hdr += std::string("\x80\x40\x20", 3) + static_cast<char>(128 + i);
    const EnvironmentPtr radiance = load_environment(folder.write("a.hdr", hdr), 2);
    CHECK(radiance->channels() == 3);
    CHECK_FALSE(radiance->polarized());
    for (int i = 0; i < 4; ++i)
        for (const int c : {0, 1, 2})
            CHECK(radiance->image().at(c, i / 2, i % 2)[0] == 2 * std::ldexp(0.5F, i - c));
    Observation colours{.width = 2, .height = 2, .rgb = {}};
    for (int i = 0; i < 4; ++i) colours.rgb.insert(colours.rgb.end(), {255, 128, 0});
    write_png(folder.path() / "a.png", png_of(colours));
    const EnvironmentPtr photo = load_environment(folder.path() / "a.png");
    CHECK(photo->image().at(0, 0, 0)[0] == 1);
    CHECK(photo->image().at(1, 0, 0)[0] == doctest::Approx(0.215861));
    check_error(ErrorCode::invalid_argument,
                CALL(load_environment(folder.path() / "a.png", 1, std::array{500.0})), "a.png",
                "wavelengths");
    check_error(ErrorCode::invalid_file, CALL(load_environment(folder.write("b.hdr", hdr.substr(0, 50)))),
                "b.hdr");
}
