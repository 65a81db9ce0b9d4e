// SPDX-License-Identifier: MIT
// Tests of textures against direct formulas.
#include "texture/texture.hpp"

#include "test.hpp"
#include "texture/image_levels.hpp"

using namespace nicol;
using Filter = TextureSampling::Filter;
using Wrap = TextureSampling::Wrap;

namespace {

TextureImage random_image(int width, int height, int channels, unsigned seed = 1) {
    TextureImage image{.width = width, .height = height, .channels = channels};
    std::mt19937 random(seed);
    for (int i = 0; i < width * height * channels; ++i)
        image.values.push_back(static_cast<float>(random() % 1000) / 500 - 0.5F);
    return image;
}

int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::repeat ? size : 2 * size;
    const int within = (i % period + period) % period;
    return within < size ? within : 2 * size - 1 - within;
}

double texel(const TextureImage& image, int x, int y, int channel, Wrap wrap) {
    if (channel == 3 && image.channels < 4) return 1;
    const int at = wrapped(y, image.height, wrap) * image.width + wrapped(x, image.width, wrap);
    return static_cast<double>(
        image.values[static_cast<std::size_t>(at * image.channels + std::min(channel, image.channels - 1))]);
}

/// Interpolates by definition: tents of one texel about texel centres.
double bilinear(const TextureImage& image, double u, double v, int channel, Wrap wrap) {
    const double x = u * image.width - 0.5, y = v * image.height - 0.5;
    double sum = 0;
    for (int j = static_cast<int>(std::floor(y)); j <= std::floor(y) + 1; ++j)
        for (int i = static_cast<int>(std::floor(x)); i <= std::floor(x) + 1; ++i)
            sum += (1 - std::abs(x - i)) * (1 - std::abs(y - j)) * texel(image, i, j, channel, wrap);
    return sum;
}

double nearest(const TextureImage& image, double u, double v, int channel, Wrap wrap) {
    return texel(image, static_cast<int>(std::floor(u * image.width)),
                 static_cast<int>(std::floor(v * image.height)), channel, wrap);
}

std::vector<glm::vec2> random_points(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-2.3F, 3.3F);
    std::vector<glm::vec2> points;
    for (int i = 0; i < count; ++i) {
        const float u = place(random), v = place(random);
        points.emplace_back(u, v);
    }
    return points;
}

TexturePoint at(const glm::vec2& uv) {
    return {.uv = uv};
}
/// Returns a pixel that covers this many texels of an image in each direction.
TexturePoint covering(const glm::vec2& uv, float texels, const TextureImage& image) {
    return {.uv = uv,
            .du = {texels / static_cast<float>(image.width), 0},
            .dv = {0, texels / static_cast<float>(image.height)}};
}

const std::vector<Wrap> wraps{Wrap::repeat, Wrap::mirror, Wrap::clamp};

}  // namespace

TEST_CASE("images are looked up as their filter and wrap say, at any coordinates") {
    for (const int channels : {1, 3, 4})
        for (const auto& [width, height] : {std::pair{7, 5}, {1, 3}, {4, 1}, {2, 2}}) {
            const TextureImage image = random_image(width, height, channels);
            for (const Wrap wrap : wraps) {
                CAPTURES(channels, width, height, static_cast<int>(wrap));
                const TexturePtr smooth = image_texture(image, {.wrap = wrap});
                const TexturePtr blocks = image_texture(image, {.filter = Filter::nearest, .wrap = wrap});
                CHECK(smooth->channels() == channels);
                double error = 0, block_error = 0;
                for (const glm::vec2& uv : random_points(300))
                    for (int c = 0; c < 4; ++c) {
                        const double u = static_cast<double>(uv.x), v = static_cast<double>(uv.y);
                        error = std::max(error, std::abs(static_cast<double>(smooth->at(at(uv))[c]) -
                                                         bilinear(image, u, v, c, wrap)));
                        block_error =
                            std::max(block_error, std::abs(static_cast<double>(blocks->at(at(uv))[c]) -
                                                           nearest(image, u, v, c, wrap)));
                    }
                CHECK(error < 2e-5);
                CHECK(block_error == 0);
            }
        }
}

TEST_CASE("far away, infinite and missing coordinates give a texel, and no crash") {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const TextureImage image = random_image(5, 5, 3);
    for (const Wrap wrap : wraps)
        for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::mipmap})
            for (const float far : {1e9F, -1e9F, 1e30F, -3e38F, infinite, -infinite, std::nanf("")}) {
                const TexturePtr texture = image_texture(image, {.filter = filter, .wrap = wrap});
                const TexturePoint point{.uv = {far, -far}, .du = {far, 1}, .dv = {0, far}};
                CHECK(std::abs(texture->at(point).x) <= 1.5F);
                CHECK(std::isfinite(texture->gradient(point).x));
            }
}

TEST_CASE("sixteen points are looked up as each of them is") {
    std::vector<TexturePtr> textures{mesh_color_texture(ColorsOf::vertices),
                                     checkerboard_texture({1, 2, 3}, {4, 5, 6}, 3)};
    const glm::dmat3 to_uv(2, 0.5, 0, -0.25, 3, 0, 0.1, 0.7, 1);
    for (const int channels : {1, 3, 4})
        for (const auto& [width, height] : {std::pair{7, 5}, {1, 3}, {64, 2}})
            for (const Wrap wrap : wraps)
                for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::mipmap})
                    textures.push_back(image_texture(random_image(width, height, channels),
                                                     {.filter = filter, .wrap = wrap, .to_uv = to_uv}));
    textures.push_back(product_texture(textures[0], textures[1]));
    std::vector<TexturePoint> given;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(0, 1);
    for (const glm::vec2& uv : random_points(70)) {
        const float footprint = 0.5F * number(random) * number(random);
        given.push_back({.uv = uv,
                         .du = {footprint, 0.1F * number(random)},
                         .dv = {0, number(random) * footprint},
                         .color = {number(random), number(random), number(random)}});
    }
    constexpr float infinite = std::numeric_limits<float>::infinity();
    for (const float far : {1e9F, -1e9F, -3e38F, infinite, -infinite, std::nanf("")})
        for (const float du : {0.0F, far}) given.push_back({.uv = {far, -far}, .du = {du, 1}, .dv = {0, du}});
    given.resize(given.size() / kLanes * kLanes);
    for (std::size_t t = 0; t < textures.size(); ++t) {
        CAPTURE(t);
        float error = 0;
        for (std::size_t begin = 0; begin < given.size(); begin += kLanes) {
            TexturePoints points;
            for (std::size_t i = 0; i < kLanes; ++i) {
                const TexturePoint& from = given[begin + i];
                for (glm::length_t k = 0; k < 3; ++k) {
                    const auto to = static_cast<std::size_t>(k);
                    points.color[to][i] = from.color[k];
                    if (k == 2) continue;
                    points.uv[to][i] = from.uv[k];
                    points.du[to][i] = from.du[k];
                    points.dv[to][i] = from.dv[k];
                }
            }
            std::array<Lanes, 4> found;
            textures[t]->at_lanes(points, found);
            for (std::size_t i = 0; i < kLanes; ++i)
                for (glm::length_t c = 0; c < 4; ++c)
                    error = std::max(error, std::abs(found[static_cast<std::size_t>(c)][i] -
                                                     textures[t]->at(given[begin + i])[c]));
        }
        CHECK(error < 2e-5F);
    }
}

TEST_CASE("a transform of the coordinates is applied before the look-up") {
    const glm::dmat3 to_uv(2, 0.5, 0, -0.25, 3, 0, 0.1, 0.7, 1);  // by columns
    const TextureImage image = random_image(6, 4, 1);
    const TexturePtr plain = image_texture(image), moved = image_texture(image, {.to_uv = to_uv});
    const TexturePtr board = checkerboard_texture(glm::vec3(0), glm::vec3(1), 1),
                     moved_board = checkerboard_texture(glm::vec3(0), glm::vec3(1), 1, to_uv);
    for (const glm::vec2& uv : random_points(50)) {
        const glm::vec2 there(2 * uv.x - 0.25F * uv.y + 0.1F, 0.5F * uv.x + 3 * uv.y + 0.7F);
        CHECK(moved->at(at(uv)).x == doctest::Approx(plain->at(at(there)).x).epsilon(1e-4));
        CHECK(moved_board->at(at(uv)).x == board->at(at(there)).x);
    }
}

TEST_CASE("the gradient is the slope of the interpolated image") {
    const glm::dmat3 to_uv(2, 0.5, 0, -0.25, 1, 0, 0.1, 0.7, 1);
    for (const int channels : {1, 3})
        for (const Wrap wrap : wraps) {
            CAPTURES(channels, static_cast<int>(wrap));
            const TextureImage image = random_image(9, 5, channels);
            const TexturePtr texture = image_texture(image, {.wrap = wrap, .to_uv = to_uv});
            const TexturePtr blocks =
                image_texture(image, {.filter = Filter::nearest, .wrap = wrap, .to_uv = to_uv});
            const float step = 1e-3F;
            int corners = 0;
            for (const glm::vec2& uv : random_points(200)) {
                const glm::vec2 slope = texture->gradient(at(uv));
                const auto difference = [&](const glm::vec2& by) {
                    return (texture->at(at(uv + by)).x - texture->at(at(uv - by)).x) / (2 * step);
                };
                const glm::vec2 differences(difference({step, 0}), difference({0, step}));
                // The slope jumps where a difference reaches into the next cell.
                if (!(glm::distance(slope, differences) < 0.02F)) ++corners;
                CHECK(blocks->gradient(at(uv)) == slope);
            }
            CHECK(corners < 20);
        }
}

TEST_CASE("levels halve an image, and every one has its mean") {
    for (const auto& [width, height] : {std::pair{8, 8}, {13, 5}, {1, 7}, {64, 3}}) {
        const TextureImage image = random_image(width, height, 3);
        const std::vector<TextureImage> levels = image_levels(image);
        CHECK(levels.back().values.size() == 3);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            CAPTURES(width, height, i);
            CHECK(levels[i].width == std::max(1, width >> i));
            CHECK(levels[i].height == std::max(1, height >> i));
            double sum = 0;
            for (std::size_t k = 1; k < levels[i].values.size(); k += 3)
                sum += static_cast<double>(levels[i].values[k]);
            CHECK(sum / (levels[i].width * levels[i].height) ==
                  doctest::Approx(static_cast<double>(image_texture(image)->mean().y)).epsilon(1e-5));
        }
    }
    for (const int channels : {1, 3, 4}) {
        const TextureImage image = random_image(6, 4, channels);
        const TextureImage half = image_levels(image)[1];
        const auto at = [](const TextureImage& of, int x, int y, int c) {
            return of.values[static_cast<std::size_t>((y * of.width + x) * of.channels + c)];
        };
        REQUIRE(half.values.size() == static_cast<std::size_t>(3 * 2 * channels));
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x)
                for (int c = 0; c < channels; ++c) {
                    const float four = at(image, 2 * x, 2 * y, c) + at(image, 2 * x + 1, 2 * y, c) +
                                       at(image, 2 * x, 2 * y + 1, c) + at(image, 2 * x + 1, 2 * y + 1, c);
                    CHECK(at(half, x, y, c) == doctest::Approx(four / 4).epsilon(1e-6));
                }
    }
    // Each of two texels covers half of the five texels 0 1 2 3 4.
    const TextureImage five{.width = 5, .height = 1, .channels = 1, .values = {0, 1, 2, 3, 4}};
    const std::vector<float> halves = image_levels(five)[1].values;
    CHECK(halves[0] == doctest::Approx((0 + 1 + 0.5 * 2) / 2.5));
    CHECK(halves[1] == doctest::Approx((0.5 * 2 + 3 + 4) / 2.5));
}

TEST_CASE("a mipmap shows what a pixel covers") {
    // Squares of one texel look grey from afar. Without levels the pixel's centre would decide.
    TextureImage squares{.width = 64, .height = 64, .channels = 1};
    for (int i = 0; i < 64 * 64; ++i) squares.values.push_back(static_cast<float>((i + i / 64) % 2));
    const TexturePtr far = image_texture(squares, {.filter = Filter::mipmap});
    for (const glm::vec2& uv : random_points(20)) {
        // The mean varies by a thirtieth from place to place.
        CHECK(far->at(covering(uv, 2.5F, squares)).x == doctest::Approx(0.5).epsilon(0.05));
        CHECK(far->at(covering(uv, 5.0F, squares)).x == doctest::Approx(0.5));
    }

    const TextureImage image = random_image(16, 8, 4);
    const std::vector<TextureImage> levels = image_levels(image);
    const TexturePtr texture = image_texture(image, {.filter = Filter::mipmap, .wrap = Wrap::mirror});
    const TexturePtr flat = image_texture(image, {.wrap = Wrap::mirror});
    for (const glm::vec2& uv : random_points(30)) {
        CHECK(texture->at(at(uv)) == flat->at(at(uv)));
        CHECK(texture->at(covering(uv, 0.3F, image)) == flat->at(at(uv)));
        CHECK(texture->gradient(covering(uv, 0.3F, image)) == flat->gradient(at(uv)));
        // The footprint takes four places, a quarter of the way from level 1 to level 2.
        const float covered = 2 * std::sqrt(2 * (4 * 10.0F / 7 - 0.875F));
        const glm::vec4 between = texture->at(covering(uv, covered, image));
        for (int c = 0; c < 4; ++c) {
            double expected = 0;
            for (const double x : {-0.25, 0.25})
                for (const double y : {-0.25, 0.25}) {
                    const glm::dvec2 place = glm::dvec2(uv) + static_cast<double>(covered) *
                                                                  glm::dvec2(x, y) /
                                                                  glm::dvec2(image.width, image.height);
                    for (const std::size_t level : {1, 2})
                        expected += (level == 1 ? 0.75 : 0.25) / 4 *
                                    bilinear(levels[level], place.x, place.y, c, Wrap::mirror);
                }
            CHECK(static_cast<double>(between[c]) == doctest::Approx(expected).epsilon(1e-3));
        }
        for (int c = 0; c < 4; ++c)
            CHECK(texture->at(covering(uv, 1e6F, image))[c] == doctest::Approx(texture->mean()[c]));
    }
}

TEST_CASE("what is said of a whole image is true of its values") {
    const TextureImage image{
        .width = 2, .height = 2, .channels = 3, .values = {4, 1, 0, 2, 1, 0, 2, 5, 0, 8, 1, 4}};
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::mipmap}) {
        const TexturePtr texture = image_texture(image, {.filter = filter});
        CHECK(texture->mean() == glm::vec4(4, 2, 1, 1));
        CHECK(texture->range() == glm::vec2(2, 8));
        CHECK(texture->values() ==
              (filter == Filter::nearest ? std::vector<float>{2, 4, 8} : std::vector<float>{}));
        CHECK_FALSE(texture->constant());
        CHECK(texture->needs_texcoords());
        CHECK_FALSE(texture->needs_colors(ColorsOf::vertices));
    }
    CHECK(image_texture(random_image(9, 9, 1), {.filter = Filter::nearest})->values().empty());
    // The first channel has one value, but the other channels vary.
    const TextureImage red{.width = 2, .height = 1, .channels = 3, .values = {3, 1, 0, 3, 2, 0}};
    CHECK(image_texture(red)->values() == std::vector<float>{3});
    CHECK_FALSE(image_texture(red)->constant());
}

TEST_CASE("textures of one value are known as such") {
    const TextureImage grey{.width = 3, .height = 2, .channels = 1, .values = std::vector<float>(6, 0.25F)};
    const TextureImage rgba{.width = 2, .height = 1, .channels = 4, .values = {1, 2, 3, 4, 1, 2, 3, 4}};
    const struct {
        TexturePtr texture;
        int channels;
        glm::vec4 value;
    } rows[] = {{image_texture(grey), 1, {0.25F, 0.25F, 0.25F, 1}},
                {image_texture(rgba), 4, {1, 2, 3, 4}},
                {checkerboard_texture({1, 2, 3}, {1, 2, 3}, 3), 3, {1, 2, 3, 1}},
                {checkerboard_texture({1, 2, 3}, {1, 5, 5}, 1), 1, {1, 1, 1, 1}},
                {constant_texture({1, 2, 3, 4}, 1), 1, {1, 1, 1, 1}},
                {constant_texture({1, 2, 3, 4}, 3), 3, {1, 2, 3, 1}},
                {constant_texture({1, 2, 3, 4}, 4), 4, {1, 2, 3, 4}}};
    for (const auto& row : rows) {
        CAPTURES(row.channels, row.value.x);
        CHECK(row.texture->constant());
        CHECK(row.texture->channels() == row.channels);
        CHECK(row.texture->at(at({0.3F, 7})) == row.value);
        CHECK(row.texture->mean() == row.value);
        CHECK(row.texture->range() == glm::vec2(row.value.x));
        CHECK(row.texture->values() == std::vector<float>{row.value.x});
        CHECK(row.texture->gradient(at({0.3F, 7})) == glm::vec2(0));
        CHECK_FALSE(row.texture->needs_texcoords());
        CHECK_FALSE(row.texture->needs_colors(ColorsOf::vertices));
    }
}

TEST_CASE("a checkerboard has four squares a unit, the first of color0") {
    const glm::vec3 first(0.8F, 0.2F, 0.1F), second(0.1F, 0.3F, 0.9F);
    const TexturePtr board = checkerboard_texture(first, second, 3);
    for (const glm::vec2& uv : random_points(100)) {
        const bool even = (static_cast<int>(std::floor(2 * (uv.x - std::floor(uv.x)))) +
                           static_cast<int>(std::floor(2 * (uv.y - std::floor(uv.y))))) %
                              2 ==
                          0;
        CHECK(board->at(at(uv)) == glm::vec4(even ? first : second, 1));
    }
    CHECK(board->mean() == glm::vec4(0.5F * (first + second), 1));
    CHECK(board->values() == std::vector<float>{0.1F, 0.8F});
    CHECK(board->range() == glm::vec2(0.1F, 0.8F));
    CHECK(board->needs_texcoords());
    // Both colours have equal first channels.
    CHECK(checkerboard_texture({1, 0, 0}, {1, 1, 0}, 3)->values() == std::vector<float>{1});
}

TEST_CASE("a checkerboard is the mean over a pixel's footprint") {
    const glm::dmat3 to_uv(2, 0.5, 0, -0.25, 3, 0, 0.1, 0.7, 1);
    const TexturePtr board = checkerboard_texture(glm::vec3(0), glm::vec3(1), 1, to_uv);
    const struct {
        glm::vec2 du, dv;
        float tolerance;
    } rows[] = {{{0.02F, 0}, {0, 0.03F}, 0.02F},
                {{0.2F, 0.02F}, {0, 0.01F}, 0.06F},
                {{0.1F, 0.1F}, {-0.02F, 0.03F}, 0.1F},  // across the squares' diagonals
                {{0.3F, 0.2F}, {0.1F, -0.4F}, 0.03F},
                {{30, 0}, {0.1F, 20}, 0.01F}};
    for (const auto& row : rows)
        for (const glm::vec2& uv : random_points(30)) {
            CAPTURES(row.du.x, uv.x, uv.y);
            constexpr int side = 100;
            float sum = 0;
            for (int i = 0; i < side; ++i)
                for (int k = 0; k < side; ++k)
                    sum += board
                               ->at(at(uv + ((static_cast<float>(i) + 0.5F) / side - 0.5F) * row.du +
                                       ((static_cast<float>(k) + 0.5F) / side - 0.5F) * row.dv))
                               .x;
            const float mean = board->at({.uv = uv, .du = row.du, .dv = row.dv}).x;
            CHECK(std::abs(mean - sum / (side * side)) < row.tolerance);
        }
}

TEST_CASE("colours of a mesh are those of the point") {
    for (const ColorsOf of : {ColorsOf::vertices, ColorsOf::faces}) {
        const TexturePtr texture = mesh_color_texture(of);
        CHECK(texture->at({.color = {0.1F, 0.2F, 0.3F}}) == glm::vec4(0.1F, 0.2F, 0.3F, 1));
        CHECK(texture->needs_colors(ColorsOf::vertices) == (of == ColorsOf::vertices));
        CHECK(texture->needs_colors(ColorsOf::faces) == (of == ColorsOf::faces));
        CHECK_FALSE(texture->needs_texcoords());
        CHECK(texture->channels() == 3);
    }
}

TEST_CASE("textures that cannot be are refused by name") {
    constexpr auto invalid = ErrorCode::invalid_argument;
    constexpr float missing = std::numeric_limits<float>::quiet_NaN();
    const auto image = [](int width, int height, int channels, std::vector<float> values) {
        return TextureImage{
            .width = width, .height = height, .channels = channels, .values = std::move(values)};
    };
    const struct {
        TextureImage image;
        const char* part;
    } rows[] = {{image(1, 1, 2, {1, 1}), "has 2 channels; it must have 1, 3 or 4"},
                {image(0, 1, 1, {}), "0 x 1 pixels; each side must lie in 1 to 32768"},
                {image(1, -1, 1, {}), "1 x -1 pixels"},
                {image(32769, 1, 1, std::vector<float>(32769)), "32769 x 1 pixels"},
                {image(32768, 32768, 1, {}), "at most 201326592 are possible"},
                {image(2, 2, 1, {1, 2, 3}), "holds 3 values, expected 4"},
                {image(2, 2, 3, {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, missing, 3}), "pixel (1, 1) is not finite"}};
    for (const auto& row : rows) check_error(invalid, CALL(image_texture(row.image)), row.part);

    glm::dmat3 perspective(1), infinite(1);
    perspective[0][2] = 0.1;
    infinite[2][0] = 1e300;
    const TextureImage one = image(1, 1, 1, {1});
    check_error(invalid, CALL(image_texture(one, {.to_uv = perspective})), "must be 0 0 1");
    check_error(invalid, CALL(image_texture(one, {.to_uv = infinite})), "not finite");
    const glm::vec3 white(1);
    check_error(invalid, CALL(checkerboard_texture(white, white, 1, perspective)), "must be 0 0 1");
    check_error(invalid, CALL(checkerboard_texture(white, white, 4)), "it must have 1 or 3");
    check_error(invalid, CALL(checkerboard_texture(white, glm::vec3(missing), 3)), "not finite");
    check_error(invalid, CALL(constant_texture(glm::vec4(missing), 1)), "not finite");
    check_error(invalid, CALL(constant_texture(glm::vec4(1), 2)), "has 2 channels");
}

TEST_CASE("a tint is a colour over its luminance") {
    const auto luminance = [](const glm::vec4& c) {
        return glm::dot(glm::vec3(c), glm::vec3(0.212671F, 0.715160F, 0.072169F));
    };
    const TexturePtr board = checkerboard_texture(glm::vec3(0), glm::vec3(0.2F, 0.8F, 0.1F), 3);
    const TexturePtr image =
        image_texture({.width = 2, .height = 1, .channels = 3, .values = {0.2F, 0.8F, 0.1F, 0, 0, 0}},
                      {.filter = TextureSampling::Filter::nearest});
    // Each texture has a black and a coloured part.
    for (const auto& [texture, black, colored] : {std::tuple(board, glm::vec2(0.1F), glm::vec2(0.6F, 0.1F)),
                                                  {image, glm::vec2(0.75F, 0.5F), glm::vec2(0.25F, 0.5F)}}) {
        const TexturePtr tint = tint_texture(texture);
        const glm::vec4 value = tint->at({.uv = colored});
        CHECK(luminance(value) == doctest::Approx(1).epsilon(1e-6));
        CHECK(value.y == doctest::Approx(4 * value.x).epsilon(1e-6));
        CHECK(tint->at({.uv = black}) == glm::vec4(1));
    }
    CHECK(tint_texture(constant_texture(glm::vec4(0.3F), 1))->mean() == glm::vec4(1));
    CHECK(tint_texture(constant_texture({0.2F, 0.8F, 0.1F, 1}, 3))->mean() ==
          tint_texture(board)->at({.uv = {0.6F, 0.1F}}));
    check_error(ErrorCode::unsupported, CALL(tint_texture(mesh_color_texture(ColorsOf::vertices))),
                "a mesh's colours");
    check_error(ErrorCode::invalid_argument, CALL(tint_texture(nullptr)), "null");
}

TEST_CASE("a product of textures is that of their values") {
    const TexturePtr board = checkerboard_texture({1, 1, 1}, {0.5F, 0.5F, 0.5F}, 1);
    const TexturePtr product = product_texture(board, mesh_color_texture(ColorsOf::vertices));
    const TexturePoint point{.uv = {0.75F, 0.25F}, .color = {1, 0.5F, 0.25F}};
    CHECK(product->channels() == 3);
    CHECK(product->at(point) == glm::vec4(0.5F, 0.25F, 0.125F, 1));
    CHECK(product->needs_texcoords());
    CHECK(product->needs_colors(ColorsOf::vertices));
    CHECK_FALSE(product->needs_colors(ColorsOf::faces));
    CHECK_FALSE(product->constant());
    CHECK(product->range() == glm::vec2(0, 1));
    CHECK(product_texture(constant_texture({-2, -2, -2, 1}, 1), board)->range() == glm::vec2(-2, -1));
    CHECK_INVALID(static_cast<void>(product_texture(board, nullptr)));
    CHECK_INVALID(static_cast<void>(product_texture(board, constant_texture({1, 1, 1, 1}, 4))));
}
