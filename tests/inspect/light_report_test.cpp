// SPDX-License-Identifier: MIT
// Tests of light reports against closed forms.
#include "inspect/light_report.hpp"

#include "light/images.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("the report of a Rayleigh sky has its closed form") {
    const EnvironmentPtr sky = rayleigh_sky({.sun_direction = {1, 2, 3}, .dop_max = 0.8, .radiance = {2, 1}});
    const LightReport report = describe(*sky, sky->project(4));
    CHECK(report.polarized);
    CHECK_FALSE(report.circular);
    CHECK(report.wavelengths.empty());
    REQUIRE(report.channels.size() == 2);
    const LightChannelReport& c = report.channels[0];
    CHECK(c.mean == doctest::Approx(2).epsilon(1e-4));
    CHECK(c.largest == doctest::Approx(3).epsilon(1e-3));
    CHECK(c.smallest == doctest::Approx(1.5).epsilon(1e-3));
    CHECK(c.largest_dolp == doctest::Approx(0.8).epsilon(1e-4));
    // The mean of s0 DoLP divided by the mean of s0 is dop_max 3/4 times the mean of sin^2.
    CHECK(c.mean_dolp == doctest::Approx(0.8 * 0.75 * 2 / 3).epsilon(1e-4));
    CHECK(c.circular == 0);
    CHECK(c.negative == 0);
    CHECK(c.unphysical == 0);
    CHECK(c.largest_excess == 0);
    REQUIRE(c.energy.size() == 5);
    CHECK(c.energy[0][0] == doctest::Approx(4 * 4 * pi));
    CHECK(c.energy[1][0] < 1e-20);
    // Parseval: all light is in orders 0 and 2. The mean of s0^2 is 4 * 9/16 (1 + 2/3 + 1/5).
    CHECK(c.energy[0][0] + c.energy[2][0] == doctest::Approx(4 * pi * 4 * 9 / 16 * (1 + 2.0 / 3 + 0.2)));
    CHECK(c.energy[2][1] + c.energy[2][2] == doctest::Approx(4 * pi * 4 * std::pow(0.75 * 0.8, 2) * 8 / 15));
    CHECK(c.energy[4][1] < 1e-20);
}

TEST_CASE("light beyond Eq. 70 is counted by solid angle") {
    // s0 = 1 + 2 cos theta in propagation directions is negative for cos theta < -1/2, a quarter of the
    // sphere.
    PshVector field(1, 1);
    field.at(0, 0, 0, 0) = std::sqrt(4 * pi);
    field.at(0, 1, 0, 0) = 2 * std::sqrt(4 * pi / 3);
    LightReport report = describe(*psh_environment(field), {});
    CHECK(report.channels[0].negative == doctest::Approx(0.25).epsilon(0.01));
    CHECK(report.channels[0].unphysical == report.channels[0].negative);
    CHECK(report.channels[0].smallest == doctest::Approx(-1).epsilon(1e-3));
    CHECK(report.channels[0].largest_excess == doctest::Approx(1).epsilon(1e-2));
    CHECK(report.channels[0].mean == doctest::Approx(1).epsilon(1e-4));
    // Circular light of degree 1.25 |cos theta| is not physically realizable beyond cos = 0.8.
    PshVector circular(1, 1);
    circular.at(0, 0, 0, 0) = std::sqrt(4 * pi);
    circular.at(0, 1, 0, 3) = 1.25 * std::sqrt(4 * pi / 3);
    report = describe(*psh_environment(circular), {});
    CHECK(report.circular);
    CHECK(report.channels[0].negative == 0);
    CHECK(report.channels[0].unphysical == doctest::Approx(0.2).epsilon(0.02));
    CHECK(report.channels[0].circular == doctest::Approx(1.25).epsilon(1e-3));
    CHECK(report.channels[0].largest_dolp == 0);
    CHECK(report.channels[0].largest_excess == doctest::Approx(0.25).epsilon(1e-2));
}

TEST_CASE("images are written in the layout that is read") {
    const TemporaryFolder folder;
    EquirectImage image = random_image(9, 6, 4, 3);
    image.wavelengths = {450, 500, 550, 600};
    const auto light = image_environment(image);
    write_environment(folder / "a.exr", *light);
    const auto back = load_environment(folder / "a.exr");
    CHECK(back->wavelengths() == image.wavelengths);
    CHECK(back->image().data == light->image().data);
    CHECK(describe(*back, {}).wavelengths == image.wavelengths);
    const std::vector<double> two = {600, 460};
    CHECK(load_environment(folder / "a.exr", 1, two)->image().at(0, 2, 3)[1] == image.at(3, 2, 3)[1]);
    // Unpolarized light is written without polarization channels.
    write_environment(folder / "b.exr", *constant_environment({1, 2, 3}));
    CHECK_FALSE(load_environment(folder / "b.exr")->polarized());
}
