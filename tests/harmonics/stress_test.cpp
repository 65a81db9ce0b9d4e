// SPDX-License-Identifier: MIT
// Random orders, directions, rotations and coefficients of every magnitude, tested on the whole folder. The
// seed is printed and can be set with NICOL_STRESS_SEED; NICOL_STRESS_CASES is the number of cases.
#include "harmonics/evaluate.hpp"
#include "harmonics/product.hpp"
#include "harmonics/reference.hpp"
#include "harmonics/rotation.hpp"
#include "harmonics/transform.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

unsigned long from_environment(const char* name, unsigned long otherwise) {
    const char* value = std::getenv(name);
    return value != nullptr ? std::stoul(value) : otherwise;
}

class Case {
public:
    explicit Case(std::mt19937_64& random) : random_(random) {}

    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    double real(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    /// Returns coefficients of one magnitude: ordinary, huge, tiny, denormal or zero. Some are set to zero.
    PshVector field(int order) {
        PshVector f = reference::random_field(random_, order);
        const double scales[] = {1, 1, 1e280, 1e-280, 1e-310, 0};
        scale_ = scales[integer(0, 5)];
        const bool sparse = integer(0, 2) == 0;
        for (double& value : f.data()) value = sparse && integer(0, 3) != 0 ? 0 : value * scale_;
        return f;
    }
    /// Returns the unit of errors.
    [[nodiscard]] double unit(int order) const { return scale_ * (order + 1) * (order + 1); }
    /// Returns a relative bound plus the rounding of denormal numbers.
    [[nodiscard]] double bound(double relative, int order) const {
        return relative * unit(order) + 5e-324 * 4 * (order + 1) * (order + 1);
    }

    glm::dvec3 direction() {
        glm::dvec3 d = reference::random_direction(random_);
        switch (integer(0, 5)) {
            case 0:
                return {0, 0, d.z > 0 ? 1 : -1};
            case 1:
                return {d.x * 1e-9, d.y * 1e-9, d.z};
            case 2:
                return {d.x * 1e-160, 0, d.z};
            case 3:
                return d * 1e200;
            default:
                return d;
        }
    }
    glm::dmat3 rotation() {
        switch (integer(0, 5)) {
            case 0:
                return glm::dmat3(1);
            case 1:
                return reference::about_z(real(-7, 7));
            case 2:
                return reference::about_z(real(-7, 7)) * reference::about_y(std::acos(-1.0));
            case 3:
                return glm::transpose(reference::about_y(1e-9)) * reference::about_z(real(-7, 7));
            default:
                return reference::random_rotation(random_);
        }
    }

private:
    std::mt19937_64& random_;
    double scale_ = 1;
};

/// Compares evaluation of a rotated field with the rotated evaluation.
void check_rotation(Case& one) {
    const int order = one.integer(0, 40);
    const PshVector f = one.field(order);
    const glm::dmat3 r = one.rotation();
    const PshVector g = rotated(f, r);
    CHECK(largest_difference(rotated(g, glm::transpose(r)).data(), f.data()) <= one.bound(1e-13, order));
    const glm::dvec3 d = one.direction();
    const Stokes in = evaluate(f, 0, d);
    const Stokes out = evaluate(g, 0, r * d);
    // Intensity, circular part and degree of linear polarization do not depend on the frame.
    CHECK(std::abs(in[0] - out[0]) <= one.bound(1e-12, order));
    CHECK(std::abs(in[3] - out[3]) <= one.bound(1e-12, order));
    CHECK(std::abs(std::hypot(in[1], in[2]) - std::hypot(out[1], out[2])) <= one.bound(1e-12, order));
}

void check_transform(Case& one) {
    const int order = one.integer(0, 60);
    const PshVector f = one.field(order);
    const int extra = one.integer(0, 9);
    const int columns = 2 * order + 1 + one.integer(0, 30);
    const LatitudeRows rows =
        one.integer(0, 1) == 0 ? gauss_legendre_rows(order + 1 + extra) : fejer_rows(2 * order + 1 + extra);
    PshTransform transform(order, rows, columns, one.real(-10, 10));
    std::vector<double> samples(4 * rows.theta.size() * static_cast<std::size_t>(columns));
    std::vector<double> back(f.data().size());
    transform.synthesize(f.channel(0), samples);
    transform.analyze(samples, back);
    CHECK(largest_difference(f.data(), back) <= one.bound(1e-14, order));
}

void check_product(Case& one) {
    const int lv = one.integer(0, 8);
    const int lf = one.integer(0, 8);
    const PshVector scalar = one.field(lv);
    PshVector f = one.field(lf);
    const double unit = one.unit(lf);
    std::vector<double> v(psh_count(lv));
    double size = 0;
    for (std::size_t i = 0; i < v.size(); ++i) size = std::max(size, std::abs(v[i] = scalar.data()[4 * i]));
    // The scalar is normalized, because the product must stay within the range of double.
    if (size > 1e200)
        for (double& value : v) value /= size;
    size = std::min(size, 1.0);
    PshVector out(lv + lf, 1);
    PshProduct(lv, lf, lv + lf).multiply(v, f.channel(0), out.channel(0));
    for (const double value : out.data()) CHECK(std::isfinite(value));
    PshVector visibility(lv, 1);
    for (std::size_t i = 0; i < v.size(); ++i) visibility.data()[4 * i] = v[i];
    const glm::dvec3 d = one.direction();
    const Stokes want = evaluate(visibility, 0, d)[0] * evaluate(f, 0, d);
    const Stokes have = evaluate(out, 0, d);
    const double largest = std::max(1.0, size) * (lv + 1) * (lv + 1) * 10;
    for (int p = 0; p < 4; ++p) CHECK(std::abs(want[p] - have[p]) <= 1e-11 * unit * largest + 1e-319);
}

/// Passes invalid values. Any function may refuse them, but none may crash or return a value that is not
/// finite.
void check_hostile(Case& one) {
    const double values[] = {0, -1, NAN, INFINITY, -INFINITY, 1e308, -1e308, 5e-324, 1};
    const auto any = [&] { return values[one.integer(0, 8)]; };
    PshVector f(one.integer(0, 6), 1);
    for (double& value : f.data()) value = one.integer(0, 9) == 0 ? any() : one.real(-1, 1);
    const bool finite = std::ranges::all_of(f.data(), [](double value) { return std::isfinite(value); });
    try {
        const glm::dvec3 towards{any(), any(), any()};
        (void)evaluate(f, one.integer(-1, 1), towards);
        CHECK(finite);
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::invalid_argument);
    }
    try {
        (void)rotated(f, glm::dmat3{any(), any(), any(), any(), any(), any(), any(), any(), any()});
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::invalid_argument);
    }
    try {
        PshTransform transform{one.integer(-2, 5), fejer_rows(one.integer(-1, 6)), one.integer(-5, 12),
                               any()};
        std::vector<double> samples(static_cast<std::size_t>(one.integer(0, 300)));
        transform.synthesize(f.channel(0), samples);
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::invalid_argument);
    }
}

}  // namespace

TEST_CASE("random cases") {
    const unsigned long seed = from_environment("NICOL_STRESS_SEED", 20240731);
    const unsigned long cases = from_environment("NICOL_STRESS_CASES", 300);
    MESSAGE("seed " << seed << ", " << cases << " cases");
    for (unsigned long i = 0; i < cases; ++i) {
        std::mt19937_64 random(seed + i);
        CAPTURE(seed + i);
        Case one(random);
        check_rotation(one);
        check_transform(one);
        check_product(one);
        check_hostile(one);
    }
}
