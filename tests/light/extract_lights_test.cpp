// SPDX-License-Identifier: MIT
// Tests of extracted lights of an environment and of the remaining light.
#include "light/extract_lights.hpp"

#include "light/images.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr int kAll = 64;

// Returns a room of uniform light.
EquirectImage room(int width, int height, int channels, const Stokes& light = {1, 0, 0, 0}) {
    EquirectImage image(width, height, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(light[i % 4]);
    return image;
}

// Adds a lamp over pixels of rows and columns (which wrap), with a different brightness in each pixel.
void add_lamp(EquirectImage& image, int row, int rows, int column, int columns, const Stokes& light) {
    for (int c = 0; c < image.channels; ++c)
        for (int y = row; y < row + rows; ++y)
            for (int x = column; x < column + columns; ++x)
                for (int p = 0; p < 4; ++p)
                    image.at(c, y, (x + image.width) % image.width)[static_cast<std::size_t>(p)] +=
                        static_cast<float>(light[p] * (1 + 0.3 * c + 0.1 * (y - row) + 0.05 * (x - column)));
}

// Calls visit(direction, irradiance, frame of propagation) for count x count samples of a channel.
template <class Visit>
void for_samples(const ExtractedLight& extracted_light, int channel, int count, const Visit& visit) {
    LaneLight light;
    Lanes u, v;
    for (int row = 0; row < count; ++row) {
        for (int first = 0; first < count; first += static_cast<int>(kLanes)) {
            for (std::size_t i = 0; i < kLanes; ++i) {
                u[i] = (static_cast<float>(first) + static_cast<float>(i) + 0.5F) / static_cast<float>(count);
                v[i] = (static_cast<float>(row) + 0.5F) / static_cast<float>(count);
            }
            extracted_light.sample(u, v, light);
            REQUIRE(light.irradiance.size() == static_cast<std::size_t>(extracted_light.channels()));
            const auto& s = light.irradiance[static_cast<std::size_t>(channel)];
            for (std::size_t i = 0; i < kLanes; ++i) {
                const glm::dvec3 towards(light.towards.x[i], light.towards.y[i], light.towards.z[i]);
                const glm::dvec3 x(light.x.x[i], light.x.y[i], light.x.z[i]);
                visit(towards, Stokes(s[0][i], s[1][i], s[2][i], s[3][i]),
                      Frame(x, glm::cross(-towards, x), -towards));
            }
        }
    }
}

// Returns the coefficients of the extracted lights, estimated from samples.
PshVector coefficients(const SplitLight& split, int order, int channels, int count) {
    PshVector sum(order, channels);
    std::vector<double> scalar(psh_count(order));
    std::vector<std::complex<double>> spin2(scalar.size());
    for (const auto& extracted_light : split.extracted_lights) {
        for (int c = 0; c < channels; ++c) {
            for_samples(*extracted_light, c, count,
                        [&](const glm::dvec3& towards, const Stokes& light, const Frame& frame) {
                            const glm::dvec3 along = glm::normalize(-towards);
                            harmonics_at(order, along, scalar, spin2);
                            const Stokes s = rotated(light, angle_between(frame, theta_phi_frame(along))) /
                                             (static_cast<double>(count) * count);
                            for (std::size_t k = 0; k < scalar.size(); ++k) {
                                const auto spin = std::conj(spin2[k]) * std::complex<double>(s[1], s[2]);
                                sum.channel(c)[4 * k] += scalar[k] * s[0];
                                sum.channel(c)[4 * k + 1] += spin.real();
                                sum.channel(c)[4 * k + 2] += spin.imag();
                                sum.channel(c)[4 * k + 3] += scalar[k] * s[3];
                            }
                        });
        }
    }
    return sum;
}

struct Case {
    std::string name;
    std::size_t extracted_lights;
    EquirectImage image;
};

std::vector<Case> cases() {
    const Stokes polarized{3000, 1000, -1500, 800};
    std::vector<Case> out;
    const auto add = [&](const char* name, std::size_t extracted_lights, const EquirectImage& image) {
        out.push_back({name, extracted_lights, image});
    };
    EquirectImage image = room(64, 33, 3);
    add_lamp(image, 9, 1, 20, 1, {3000, 0, 0, 0});
    add("a pixel", 1, image);
    image = room(64, 33, 2, {1, 0.2, 0.3, -0.1});
    add_lamp(image, 14, 3, 61, 6, polarized);
    add("across u = 0", 1, image);
    image = room(64, 33, 1);
    add_lamp(image, 0, 2, 0, 64, {900, 0, 0, 0});
    add("the zenith", 1, image);
    image = room(64, 33, 1);
    add_lamp(image, 31, 2, 0, 64, polarized);
    add("the nadir", 1, image);
    image = room(32, 17, 1);
    add_lamp(image, 16, 1, 0, 32, {30000, 0, 0, 0});
    add("the last row", 1, image);
    image = room(128, 65, 1, {1, 0, 0, 0});
    add_lamp(image, 20, 2, 90, 2, {3000, 3000, 0, 0});
    add_lamp(image, 40, 2, 10, 2, {2000, 0, 0, -2000});
    add("two that are fully polarized", 2, image);
    image = room(256, 129, 1);
    add_lamp(image, 50, 1, 100, 1, {3000, 0, 0, 0});
    add_lamp(image, 50, 1, 102, 1, {2000, 0, 0, 0});
    add("two that are close", 1, image);
    image = room(256, 129, 1);
    add_lamp(image, 40, 60, 40, 100, {4, 0, 0, 0});
    add_lamp(image, 60, 3, 60, 3, {20000, 0, 0, 0});
    add("a lamp in a window", 1, image);
    image = random_image(64, 33, 2, 5);
    add_lamp(image, 9, 1, 20, 1, {3000, 2000, 0, 0});
    add("noise around", 1, image);
    return out;
}

}  // namespace

TEST_CASE("the rest and samples of the extracted lights have the coefficients of the light together") {
    for (const auto& [name, extracted_lights, image] : cases()) {
        CAPTURE(name);
        const auto light = image_environment(image);
        const SplitLight split = extract_lights(light, kAll);
        REQUIRE(split.extracted_lights.size() == extracted_lights);
        const PshVector whole = light->project(4);
        PshVector sum = split.rest->project(4);
        CHECK(largest_difference(sum, whole) > 0.05 * largest(whole));
        const PshVector part = coefficients(split, 4, image.channels, 128);
        for (std::size_t i = 0; i < sum.data().size(); ++i) sum.data()[i] += part.data()[i];
        CHECK(largest_difference(sum, whole) < 2e-4 * largest(whole));
    }
}

TEST_CASE("the rest is physical, smooth where extracted lights were, and else what it was") {
    for (const auto& [name, extracted_lights, image] : cases()) {
        CAPTURE(name);
        const auto light = image_environment(image);
        const EquirectImage rest = extract_lights(light, kAll).rest->image();
        double most = 0;
        for (std::size_t i = 0; i < image.data.size(); i += 4) {
            const float* s = rest.data.data() + i;
            const bool same = std::equal(s, s + 4, image.data.data() + i);
            CHECK((same || (s[1] == 0 && s[2] == 0 && s[3] == 0)));
            CHECK(s[0] >= 0);
            CHECK(s[0] <= image.data[i]);
            most = std::max(most, double{s[0]});
        }
        CHECK(most < 55);  // radiance of the window case
    }
    EquirectImage image = room(64, 33, 1, {2, 0, 0, 0});
    add_lamp(image, 9, 2, 20, 3, {3000, 1000, 0, 0});
    const EquirectImage rest = extract_lights(image_environment(image), kAll).rest->image();
    for (std::size_t i = 0; i < rest.data.size(); i += 4) CHECK(rest.data[i] == 2);
}

TEST_CASE("light without extracted lights is left as it is") {
    RayleighSky hazy;
    hazy.turbidity = 4;
    hazy.sun_direction = {1, 1, 0};
    // The ring is too wide, and the window too large, to be extracted.
    EquirectImage ring = room(512, 257, 1);
    for (int x = 0; x < 512; ++x) ring.at(0, 128, x)[0] = 30;
    EquirectImage window = room(64, 33, 3);
    for (int k = 0; k < 64; ++k) window.at(1, 8 + k / 8, 10 + k % 8)[0] = 100;
    for (const EnvironmentPtr& light :
         {image_environment(room(16, 9, 3)), image_environment(room(16, 9, 1, {0, 0, 0, 0})),
          image_environment(random_image(64, 33, 3, 2)), rayleigh_sky(hazy), rayleigh_sky({}),
          image_environment(ring), image_environment(window), constant_environment({1}),
          psh_environment(random_field(4, 1)), EnvironmentPtr()}) {
        const SplitLight split = extract_lights(light, kAll);
        CHECK(split.extracted_lights.empty());
        CHECK(split.rest == light);
    }
}

TEST_CASE("no more extracted lights than wanted are taken, the brightest") {
    EquirectImage image = room(128, 65, 1);
    const std::array<std::pair<double, int>, 3> places{{{2000, 10}, {8000, 60}, {4000, 100}}};
    for (const auto& [brightness, column] : places) add_lamp(image, 30, 2, column, 2, {brightness, 0, 0, 0});
    const auto light = image_environment(image);
    for (const int most : {0, 1, 2, 3, kAll}) {
        CAPTURE(most);
        const SplitLight split = extract_lights(light, most);
        REQUIRE(split.extracted_lights.size() == static_cast<std::size_t>(std::min(most, 3)));
        CHECK((split.rest == light) == (most == 0));
        const std::array<int, 3> order{60, 100, 10};
        for (std::size_t k = 0; k < split.extracted_lights.size(); ++k)
            CHECK(glm::dot(split.extracted_lights[k]->centre(), towards((order[k] + 1) / 128.0, 30.5 / 64)) >
                  std::cos(0.01));
        for (const auto& [brightness, column] : places) {
            const bool left = split.rest->image().at(0, 30, column)[0] > 1;
            CHECK(left == std::none_of(order.begin(), order.begin() + split.extracted_lights.size(),
                                       [&, at = column](int taken) { return taken == at; }));
        }
    }
}

TEST_CASE("samples lie in the extracted light's cone, in the frame of the image, with its polarization") {
    for (const auto& [name, extracted_lights, image] : cases()) {
        CAPTURE(name);
        for (const auto& extracted_light : extract_lights(image_environment(image), kAll).extracted_lights) {
            CHECK(glm::length(extracted_light->centre()) == doctest::Approx(1));
            double farthest = 0;
            for_samples(
                *extracted_light, 0, 64, [&](const glm::dvec3& w, const Stokes& light, const Frame& frame) {
                    farthest =
                        std::max(farthest, std::acos(std::min(glm::dot(extracted_light->centre(), w), 1.0)));
                    CHECK(glm::length(w) == doctest::Approx(1));
                    CHECK(std::abs(glm::dot(w, frame[0])) < 1e-6);
                    CHECK(glm::length(frame[0]) == doctest::Approx(1));
                    CHECK(frame[0].y == 0);
                    CHECK(glm::dot(frame[1], glm::dvec3(0, 1, 0)) > -1e-6);
                    CHECK(light[0] >= 0);
                });
            CHECK(farthest <= extracted_light->angular_radius() + 1e-6);
            CHECK(farthest > extracted_light->angular_radius() / 3);
        }
    }
    // All samples have the lamp's polarization if all of its pixels have it.
    EquirectImage image = room(64, 33, 2);
    add_lamp(image, 14, 3, 62, 4, {3000, 600, -1200, 900});
    const SplitLight split = extract_lights(image_environment(image), kAll);
    CHECK(split.extracted_lights[0]->circular());
    CHECK_FALSE(split.rest->polarized());
    for (const int c : {0, 1}) {
        for_samples(*split.extracted_lights[0], c, 32,
                    [&](const glm::dvec3&, const Stokes& light, const Frame&) {
                        const Stokes expected = light[0] * Stokes(1, 0.2, -0.4, 0.3);
                        CHECK(glm::length(light - expected) < 1e-5 * light[0]);
                    });
    }
}

TEST_CASE("an extracted light tells which Stokes components it has") {
    LaneLight out;  // keeps values of the previous extracted light
    for (const auto& [light, components] :
         {std::pair{Stokes(3000, 0, 0, 5), 4U}, {Stokes(3000, 0, 500, 0), 3U}, {Stokes(3000, 0, 0, 0), 1U}}) {
        EquirectImage image = room(64, 33, 1);
        add_lamp(image, 14, 3, 20, 2, light);
        const SplitLight split = extract_lights(image_environment(image), kAll);
        REQUIRE(split.extracted_lights.size() == 1);
        split.extracted_lights[0]->sample(Lanes{}, Lanes{}, out);  // includes the corner u = v = 0
        CHECK(out.components == components);
        CHECK(split.extracted_lights[0]->polarized() == (components > 1));
        CHECK(split.extracted_lights[0]->circular() == (components > 3));
        CHECK(out.points == 0xFFFF);
        for (std::size_t i = 0; i < kLanes; ++i) {
            CHECK(out.distance[i] == std::numeric_limits<float>::infinity());
            CHECK(out.irradiance[0][0][i] > 0);
            CHECK(std::isfinite(out.irradiance[0][0][i]));
            CHECK((out.irradiance[0][2][i] != 0) == (components == 3));
            CHECK((out.irradiance[0][3][i] != 0) == (components == 4));
        }
    }
}

TEST_CASE(
    "the ends of the range of numbers, and extreme light, give finite light within the extracted_light") {
    for (const double size : {1e-30, 1.0, 1e25}) {
        for (const auto& [name, extracted_lights, image] : cases()) {
            CAPTURE(name);
            const SplitLight split = extract_lights(image_environment(image, size), kAll);
            REQUIRE(split.extracted_lights.size() == extracted_lights);
            for_all({0.0F, 0.99999994F}, {0.0F, 0.99999994F}, [&](float u, float v) {
                Lanes us, vs;
                us.value.fill(u);
                vs.value.fill(v);
                LaneLight out;
                split.extracted_lights[0]->sample(us, vs, out);
                CHECK(out.irradiance[0][0][0] > 0);
                CHECK(std::isfinite(out.irradiance[0][0][0]));
                const glm::dvec3 w(out.towards.x[0], out.towards.y[0], out.towards.z[0]);
                CHECK(glm::dot(w, split.extracted_lights[0]->centre()) >=
                      std::cos(split.extracted_lights[0]->angular_radius()) - 1e-6);
            });
        }
    }
}

TEST_CASE("places grow with the numbers that choose them") {
    EquirectImage image = room(64, 33, 1);
    add_lamp(image, 14, 3, 20, 4, {3000, 0, 0, 0});
    const SplitLight split = extract_lights(image_environment(image), kAll);
    REQUIRE(split.extracted_lights.size() == 1);
    Lanes rising, fixed;
    for (std::size_t i = 0; i < kLanes; ++i) {
        rising[i] = (static_cast<float>(i) + 0.5F) / static_cast<float>(kLanes);
        fixed[i] = 0.3F;
    }
    LaneLight across, down;
    split.extracted_lights[0]->sample(rising, fixed, across);
    split.extracted_lights[0]->sample(fixed, rising, down);
    for (std::size_t i = 1; i < kLanes; ++i) {
        CHECK(std::atan2(across.towards.x[i], -across.towards.z[i]) >
              std::atan2(across.towards.x[i - 1], -across.towards.z[i - 1]));
        CHECK(across.towards.y[i] == doctest::Approx(across.towards.y[0]).epsilon(0.01));
        CHECK(down.towards.y[i] < down.towards.y[i - 1]);
    }
}
