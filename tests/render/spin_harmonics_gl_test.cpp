// SPDX-License-Identifier: MIT
// glsl/spin_harmonics.glsl against the same mathematics in double precision.
#include "harmonics/spin_harmonics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "gl/buffer.hpp"
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "harmonics/evaluate.hpp"

namespace nicol::gl {
[[nodiscard]] std::span<const ShaderSource> render_test_shaders();
}

using namespace nicol;
using namespace nicol::gl;

namespace {

constexpr int largest_order = 64;
constexpr double tolerance = 2e-6;  // of a field's maximum
// One harmonic alone, where no rounding errors average out; drivers differ in how they round sqrt and
// division.
constexpr double harmonic_tolerance = 4e-6;
constexpr int fields = 4;

ShaderSource test_shader(std::string_view file) {
    const auto shaders = render_test_shaders();
    const auto found = std::ranges::find(shaders, file, &ShaderSource::file);
    REQUIRE(found != shaders.end());
    return *found;
}

/// Both poles, their neighbourhoods, the equator, azimuths next to the cut, axes, no unit length, random
/// ones.
std::vector<glm::vec4> test_directions() {
    std::vector<glm::vec4> result;
    const auto add = [&](double theta, double phi, double length = 1) {
        const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        result.emplace_back(glm::vec3(length * d), 0.0f);
    };
    for (const float z : {1.0f, -1.0f}) {
        result.emplace_back(0.0f, 0.0f, z, 0.0f);
        result.emplace_back(1e-30f, -1e-30f, z, 0.0f);
    }
    for (const double theta : {1e-7, 1e-4, 1e-2, 0.03, 0.1, 0.3, std::numbers::pi / 2})
        for (const double phi : {0.0, 0.7, std::numbers::pi, -std::numbers::pi, -2.0}) {
            add(theta, phi);
            add(std::numbers::pi - theta, phi);
        }
    for (const float cut : {0.0f, 1e-7f, -1e-7f}) result.emplace_back(-0.6f, cut, 0.8f, 0.0f);
    for (const glm::vec3 axis :
         {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, -1, 0)})
        result.emplace_back(axis, 0.0f);
    for (const double length : {1e-30, 1e-3, 3.0, 1e30}) {
        add(1.0, 2.5, length);
        add(3.0, -1.0, length);
    }
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 120; ++i) add(std::acos(uniform(random)), std::numbers::pi * uniform(random));
    return result;
}

glm::dvec3 position(const glm::vec4& direction) {
    return glm::dvec3(direction.x, direction.y, direction.z);
}

/// Coefficients [index][field] of a flat spectrum, a decaying one, one that is flat in its upper half, and
/// one mostly of |m| = l, whose errors of azimuth do not average out; a lower order is their beginning.
std::vector<glm::vec4> test_coefficients() {
    std::mt19937 random(11);
    std::normal_distribution<float> normal;
    std::vector<glm::vec4> result;
    for (int l = 0; l <= largest_order; ++l)
        for (int m = -l; m <= l; ++m) {
            const float amplitudes[fields] = {1.0f, 1.0f / static_cast<float>((l + 1) * (l + 1)),
                                              l >= largest_order / 2 ? 1.0f : 0.01f,
                                              std::abs(m) == l ? static_cast<float>(l + 1) : 1e-3f};
            for (const float amplitude : amplitudes) {
                glm::vec4 f(normal(random), normal(random), normal(random), normal(random));
                if (l < 2) f.y = f.z = 0.0f;
                result.push_back(amplitude * f);
            }
        }
    return result;
}

PshVector as_psh(std::span<const glm::vec4> coefficients, int order) {
    PshVector result(order, fields);
    for (std::size_t i = 0; i < psh_count(order); ++i)
        for (int c = 0; c < fields; ++c)
            for (int p = 0; p < 4; ++p)
                result.channel(c)[4 * i + static_cast<std::size_t>(p)] =
                    coefficients[fields * i + static_cast<std::size_t>(c)][p];
    return result;
}

/// One field at all directions, and its largest component there.
struct Reference {
    std::vector<Stokes> values;
    double largest = 0;
};

Reference reference(const PshVector& field, int channel, std::span<const glm::vec4> directions) {
    std::vector<glm::dvec3> positions;
    for (const glm::vec4& direction : directions) positions.push_back(position(direction));
    Reference result;
    result.values.resize(directions.size());
    evaluate(field, channel, positions, result.values);
    for (const Stokes& s : result.values)
        for (int p = 0; p < 4; ++p) result.largest = std::max(result.largest, std::abs(s[p]));
    return result;
}

/// The largest error over all components, as a part of the field's maximum; infinite for NaN and Inf.
double error(const Reference& expected, std::size_t direction, const glm::vec4& found) {
    double worst = 0;
    for (int p = 0; p < 4; ++p) {
        if (!std::isfinite(found[p])) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, std::abs(found[p] - expected.values[direction][p]));
    }
    return worst / expected.largest;
}

template <class T>
Buffer storage(const std::shared_ptr<Context>& context, const std::vector<T>& data) {
    return Buffer(context, BufferUse::storage, std::as_bytes(std::span(data)));
}

}  // namespace

TEST_CASE("fields of every order are evaluated to single precision") {
    const auto directions = test_directions();
    const auto coefficients = test_coefficients();
    std::vector<std::array<Reference, fields>> expected(largest_order + 1);
    for (int order = 0; order <= largest_order; ++order) {
        const PshVector field = as_psh(coefficients, order);
        for (int c = 0; c < fields; ++c)
            expected[static_cast<std::size_t>(order)][static_cast<std::size_t>(c)] =
                reference(field, c, directions);
    }
    on_every_backend([&](const std::shared_ptr<Context>& context) {
        context->run([&] {
            const Buffer input = storage(context, coefficients);
            const Buffer points = storage(context, directions);
            std::vector<glm::vec4> result(fields * directions.size());
            const Buffer output(context, BufferUse::storage, std::as_bytes(std::span(result)).size(),
                                BufferUpdate::fixed);
            const Define channels{"CHANNELS", std::to_string(fields)};
            Program program = Program::compute(context, test_shader("psh_evaluate.comp"), {&channels, 1});
            input.bind_storage(0);
            points.bind_storage(1);
            output.bind_storage(2);
            for (int order = 0; order <= largest_order; ++order) {
                program.set("order", order);
                dispatch(program, static_cast<unsigned>(directions.size() + 31) / 32);
                output.read(0, std::as_writable_bytes(std::span(result)));
                std::array<double, fields> worst{};
                for (std::size_t c = 0; c < fields; ++c)
                    for (std::size_t i = 0; i < directions.size(); ++i)
                        worst[c] = std::max(worst[c], error(expected[static_cast<std::size_t>(order)][c], i,
                                                            result[fields * i + c]));
                INFO("order " << order << ": flat " << worst[0] << ", decaying " << worst[1] << ", high "
                              << worst[2] << ", sectoral " << worst[3]);
                CHECK(*std::ranges::max_element(worst) <= tolerance);
            }
        });
    });
}

TEST_CASE("a fragment shader finds the same") {
    const auto directions = test_directions();
    const auto coefficients = test_coefficients();
    constexpr int order = 16;
    const PshVector field = as_psh(coefficients, order);
    on_every_backend([&](const std::shared_ptr<Context>& context) {
        context->run([&] {
            const Buffer input = storage(context, coefficients);
            const Buffer points = storage(context, directions);
            const Define channels{"CHANNELS", std::to_string(fields)};
            Program program = Program::graphics(context, embedded_shader("fullscreen.vert"),
                                                test_shader("psh_evaluate.frag"), {&channels, 1});
            program.set("order", order);
            RenderTarget target(context, {static_cast<int>(directions.size()), 1, fields, false});
            input.bind_storage(0);
            points.bind_storage(1);
            draw_fullscreen(target, program);
            for (int c = 0; c < fields; ++c) {
                std::vector<float> pixels(4 * directions.size());
                target.read(c, pixels);
                const Reference expected = reference(field, c, directions);
                double worst = 0;
                for (std::size_t i = 0; i < directions.size(); ++i)
                    worst = std::max(worst, error(expected, i,
                                                  glm::vec4(pixels[4 * i], pixels[4 * i + 1],
                                                            pixels[4 * i + 2], pixels[4 * i + 3])));
                CHECK(worst <= tolerance);
            }
        });
    });
}

TEST_CASE("every single harmonic is accurate") {
    const auto directions = test_directions();
    constexpr std::size_t count = psh_count(largest_order);
    const std::size_t points_count = directions.size();
    // [spin 0, spin 2][direction][index]
    std::vector<double> expected[2];
    for (std::vector<double>& values : expected) values.resize(count * points_count);
    for (std::size_t i = 0; i < points_count; ++i) {
        const glm::dvec3 d = glm::normalize(position(directions[i]));
        const double rho = std::hypot(d.x, d.y);
        const double large = std::sqrt((1 + std::abs(d.z)) / 2);
        const double small = rho / (2 * large);
        for (int s = 0; s < 2; ++s)
            spin_harmonics(2 * s, largest_order, d.z < 0 ? large : small, d.z < 0 ? small : large,
                           std::span(expected[s]).subspan(i * count, count));
    }
    on_every_backend([&](const std::shared_ptr<Context>& context) {
        context->run([&] {
            const Buffer points = storage(context, directions);
            std::vector<glm::vec2> result(count * points_count);
            const Buffer output(context, BufferUse::storage, std::as_bytes(std::span(result)).size(),
                                BufferUpdate::fixed);
            Program program = Program::compute(context, test_shader("psh_harmonics.comp"));
            program.set("order", largest_order);
            points.bind_storage(1);
            output.bind_storage(2);
            dispatch(program, static_cast<unsigned>(points_count + 31) / 32);
            output.read(0, std::as_writable_bytes(std::span(result)));
            for (int s = 0; s < 2; ++s)
                for (std::size_t j = 0; j < count; ++j) {
                    double largest = 0;
                    double worst = 0;
                    for (std::size_t i = 0; i < points_count; ++i) {
                        const double value = expected[s][i * count + j];
                        const float found = result[i * count + j][s];
                        REQUIRE(std::isfinite(found));
                        largest = std::max(largest, std::abs(value));
                        worst = std::max(worst, std::abs(found - value));
                    }
                    INFO("spin " << 2 * s << ", index " << j << ": " << worst / largest);
                    CHECK(worst <= harmonic_tolerance * largest);
                }
        });
    });
}
