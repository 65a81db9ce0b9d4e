// SPDX-License-Identifier: MIT
#include "sensor/expose.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "arguments.hpp"
#include "sensor/lens.hpp"
#include "sensor/noise.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

/// Electrons beyond all full wells, which keep Poisson's quantile finite.
constexpr double kMostElectrons = 1e12;

/// Returns whether all numbers are finite: whether no exponent has all its bits.
bool all_finite(std::span<const float> numbers) {
    constexpr std::uint32_t exponent = 0x7F800000;
    std::uint32_t wrong = 0;
    for (const float number : numbers)
        wrong |= (std::bit_cast<std::uint32_t>(number) & exponent) == exponent ? 1U : 0U;
    return wrong == 0;
}

[[noreturn]] void refuse_infinite_light(const StokesImage& light) {
    const auto wrong = std::ranges::find_if(light.data, [](float v) { return !std::isfinite(v); });
    const auto pixel = static_cast<std::size_t>(wrong - light.data.begin()) / 4;
    const auto width = static_cast<std::size_t>(light.width);
    const auto height = static_cast<std::size_t>(light.height);
    refuse("the light of channel " + std::to_string(pixel / (width * height)) + " at column " +
           std::to_string(pixel % width) + ", row " + std::to_string(pixel / width % height) +
           " is not finite");
}

bool finite_row(const StokesImage& light, int y) {
    const std::size_t row = 4 * static_cast<std::size_t>(light.width);
    bool finite = true;
    for (int c = 0; c < light.channels; ++c)
        finite &= all_finite(
            std::span(light.data).subspan(static_cast<std::size_t>(c * light.height + y) * row, row));
    return finite;
}

/// Two normal numbers that belong to a pixel in every frame.
std::array<double, 2> pixel_errors(const Sensor& sensor, std::uint32_t pixel, NoiseOf purpose) {
    const std::array<double, 2> u = uniform_pair(sensor.seed, 0, pixel, purpose);
    return {normal_quantile(u[0]), normal_quantile(u[1])};
}

/// Sensitivity of a pixel to the Stokes vector in front of the optics: the first row of the Mueller matrices
/// of the pixel's polarizer times the optics.
class Analysers {
public:
    explicit Analysers(const Sensor& sensor)
        : sensor_(sensor),
          across_(sensor.extinction_ratio > 0 ? 1 / sensor.extinction_ratio : 0),
          differ_(sensor.misalignment > 0 || sensor.extinction_spread > 0) {
        for (std::size_t angle = 0; angle < exact_.size(); ++angle)
            exact_[angle] = sensor.mosaic == Mosaic::plain ? behind_optics({1, 0, 0, 0})
                                                           : behind_polarizer(angle, {1, 0}, across_);
    }

    /// Returns whether polarizers of one angle differ from pixel to pixel.
    [[nodiscard]] bool differ() const { return differ_; }
    [[nodiscard]] Stokes at(int x, int y, std::uint32_t pixel) const {
        const std::size_t angle = angle_at(x, y);
        if (sensor_.mosaic == Mosaic::plain || !differ_) return exact_[angle];
        const std::array<double, 2> error = pixel_errors(sensor_, pixel, NoiseOf::micro_polarizer);
        return behind_polarizer(angle,
                                cosine_and_sine(std::numbers::pi / 90 * sensor_.misalignment * error[0]),
                                std::clamp(across_ * (1 + sensor_.extinction_spread * error[1]), 0.0, 1.0));
    }

private:
    /// turned: cosine and sine of twice the angle by which the polarizer is misaligned.
    [[nodiscard]] Stokes behind_polarizer(std::size_t angle, const std::array<double, 2>& turned,
                                          double across) const {
        constexpr std::array<std::array<double, 2>, 4> axes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const std::array<double, 2> axis = axes[angle];
        const double half = (1 - across) / 2;
        return behind_optics({(1 + across) / 2, half * (axis[0] * turned[0] - axis[1] * turned[1]),
                              half * (axis[1] * turned[0] + axis[0] * turned[1]), 0});
    }
    [[nodiscard]] Stokes behind_optics(const Stokes& row) const {
        Stokes product(0);
        for (int column = 0; column < 4; ++column)
            for (int i = 0; i < 4; ++i)
                product[column] +=
                    row[i] * sensor_.optics(static_cast<std::size_t>(i), static_cast<std::size_t>(column));
        return product;
    }

    const Sensor& sensor_;
    double across_;
    bool differ_;
    std::array<Stokes, 4> exact_;
};

/// Analysers of consecutive pixels, by component.
using LaneAnalysers = std::array<NoiseLanes, 4>;

/// Adds the electrons from the Stokes vectors of consecutive pixels in one channel. electrons: for s0 = 1
/// behind the polarizer.
[[gnu::always_inline]] inline void add_electrons(const float* stokes, const LaneAnalysers& analysers,
                                                 const NoiseLanes& electrons, NoiseLanes& sum) {
    for (std::size_t i = 0; i < kNoiseLanes; ++i) {
        const float* const s = stokes + 4 * i;
        const double behind =
            analysers[0][i] * static_cast<double>(s[0]) + analysers[1][i] * static_cast<double>(s[1]) +
            analysers[2][i] * static_cast<double>(s[2]) + analysers[3][i] * static_cast<double>(s[3]);
        sum[i] += std::min(std::max(electrons[i] * behind, 0.0), kMostElectrons);
    }
}

/// Mean electrons of a sensor's pixels from light, before crosstalk.
class LitElectrons {
public:
    LitElectrons(const Sensor& sensor, const StokesImage& light)
        : light_(light), analysers_(sensor), coloured_(sensor.mosaic == Mosaic::polarized_bayer) {
        for (std::size_t c = 0; c < static_cast<std::size_t>(light.channels); ++c)
            electrons_.push_back(electrons_of(sensor, c));
    }

    /// Sets the electrons of a row of pixels.
    void find_row(int y, std::span<double> out) const {
        const std::vector<NoiseLanes> electrons = electrons_of_row(y);
        const double share = coloured_ ? 1 : light_.channels;
        const auto width = static_cast<std::size_t>(light_.width);
        const std::size_t plane = width * static_cast<std::size_t>(light_.height);
        const std::size_t row = width * static_cast<std::size_t>(y);
        LaneAnalysers analysers{};
        std::array<float, 4 * kNoiseLanes> last{};
        for (std::size_t begin = 0; begin < width; begin += kNoiseLanes) {
            const std::size_t count = std::min(kNoiseLanes, width - begin);
            if (begin == 0 || analysers_.differ()) find_analysers(begin, y, count, analysers);
            NoiseLanes sum{};
            for (std::size_t c = 0; c < electrons.size(); ++c) {
                const float* stokes = &light_.data[4 * (c * plane + row + begin)];
                if (count < kNoiseLanes) {
                    std::copy_n(stokes, 4 * count, last.begin());
                    stokes = last.data();
                }
                dispatch<add_electrons>(stokes, analysers, electrons[c], sum);
            }
            for (std::size_t i = 0; i < count; ++i) out[begin + i] = sum[i] / share;
        }
    }

private:
    /// Returns the electrons of sixteen pixels of a row by channel, which repeat along the row: 0 behind the
    /// filter of another colour.
    [[nodiscard]] std::vector<NoiseLanes> electrons_of_row(int y) const {
        std::vector<NoiseLanes> out(electrons_.size());
        for (std::size_t c = 0; c < out.size(); ++c)
            for (std::size_t i = 0; i < kNoiseLanes; ++i)
                out[c][i] = !coloured_ || colour_at(static_cast<int>(i), y) == c ? electrons_[c] : 0;
        return out;
    }
    void find_analysers(std::size_t begin, int y, std::size_t count, LaneAnalysers& out) const {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(light_.width) + begin;
        for (std::size_t i = 0; i < count; ++i) {
            const Stokes analyser =
                analysers_.at(static_cast<int>(begin + i), y, static_cast<std::uint32_t>(pixel + i));
            for (std::size_t p = 0; p < 4; ++p) out[p][i] = analyser[static_cast<glm::length_t>(p)];
        }
    }

    const StokesImage& light_;
    Analysers analysers_;
    bool coloured_;
    std::vector<double> electrons_;  ///< electrons of each channel, for s0 = 1 behind the polarizer
};

/// Means of all pixels from light, which must be finite, with row-wise access to neighbours. Beyond the
/// border a pixel is its own neighbour, so that crosstalk loses no electrons.
class Means {
public:
    Means(const Sensor& sensor, const StokesImage& light)
        : width_(light.width), height_(light.height), crosstalk_(sensor.crosstalk > 0) {
        const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        values_.resize(pixels);
        if (crosstalk_) given_.resize(pixels);
        const LitElectrons lit(sensor, light);
        std::atomic<bool> finite = true;
        tbb::parallel_for(0, height_, [&](int y) {
            if (!finite_row(light, y)) finite = false;
            lit.find_row(y, std::span(values_).subspan(index(0, y), static_cast<std::size_t>(width_)));
            for (std::size_t i = index(0, y); crosstalk_ && i < index(0, y + 1); ++i)
                given_[i] = crosstalk_of(sensor, static_cast<std::uint32_t>(i)) / 4 * values_[i];
        });
        if (!finite) refuse_infinite_light(light);
    }

    [[nodiscard]] double after_crosstalk(int x, int y) const {
        const std::size_t i = index(x, y);
        if (!crosstalk_) return values_[i];
        const double got =
            given_[index(std::max(x - 1, 0), y)] + given_[index(std::min(x + 1, width_ - 1), y)] +
            given_[index(x, std::max(y - 1, 0))] + given_[index(x, std::min(y + 1, height_ - 1))];
        return values_[i] - 4 * given_[i] + got;
    }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

private:
    static double crosstalk_of(const Sensor& sensor, std::uint32_t pixel) {
        if (sensor.crosstalk_spread == 0) return sensor.crosstalk;
        const double error = pixel_errors(sensor, pixel, NoiseOf::crosstalk)[0];
        return std::clamp(sensor.crosstalk * (1 + sensor.crosstalk_spread * error), 0.0, 1.0);
    }

    int width_, height_;
    bool crosstalk_;
    std::vector<double> values_;
    std::vector<double> given_;  ///< electrons that a pixel gives to each of its four neighbours
};

/// Numbers of a sensor by electrons: the parameters of the formula of Sensor.
struct Curve {
    double full_well, read_noise, gain, black_level, largest;
};

/// Replaces electrons by numbers.
[[gnu::always_inline]] inline void digitize(const Curve& curve, const NoiseLanes& read_noise,
                                            const NoiseLanes& offset, NoiseLanes& electrons) {
    for (std::size_t i = 0; i < kNoiseLanes; ++i) {
        const double kept = std::min(electrons[i], curve.full_well);
        const double number = std::floor(curve.gain * (kept + curve.read_noise * read_noise[i] + offset[i]) +
                                         curve.black_level + 0.5);
        electrons[i] = std::min(std::max(number, 0.0), curve.largest);
    }
}

/// Numbers of pixels by their mean electrons.
class Numbers {
public:
    Numbers(const Sensor& sensor, std::uint64_t frame)
        : sensor_(sensor),
          frame_(frame),
          dark_(sensor.dark_current * sensor.exposure_time),
          curve_{.full_well = sensor.full_well,
                 .read_noise = sensor.read_noise,
                 .gain = gain_of(sensor),
                 .black_level = sensor.black_level,
                 .largest = largest_number(sensor)} {}

    /// Sets the numbers of the pixels from `pixel` on, at most kNoiseLanes, from their means, which change.
    void write(NoiseLanes& mean, std::uint32_t pixel, std::span<std::uint16_t> numbers) const {
        NoiseLanes offset{}, first, second;
        if (sensor_.prnu > 0 || sensor_.dsnu > 0) {
            uniform_pairs(sensor_.seed, 0, pixel, NoiseOf::response, first, second);
            to_normal(first);
            to_normal(second);
            for (std::size_t i = 0; i < kNoiseLanes; ++i) {
                mean[i] = std::max(mean[i] * (1 + sensor_.prnu * first[i]), 0.0);
                offset[i] = sensor_.dsnu * second[i];
            }
        }
        for (double& electrons : mean) electrons += dark_;
        uniform_pairs(sensor_.seed, frame_, pixel, NoiseOf::exposure, first, second);
        if (sensor_.shot_noise) to_poisson(first, mean);
        if (sensor_.read_noise > 0) to_normal(second);
        dispatch<digitize>(curve_, second, offset, mean);
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::uint16_t>(mean[i]);
    }

private:
    const Sensor& sensor_;
    std::uint64_t frame_;
    double dark_;  ///< mean electrons without light
    Curve curve_;
};

}  // namespace

RawImage expose(const Sensor& sensor, const StokesImage& light, std::uint64_t frame) {
    light.check("light");
    check(sensor, light.width, light.height, light.channels);
    std::optional<StokesImage> behind_lens;
    if (sensor.blur > 0 || sensor.vignetting > 0) {
        // The blur would spread the number, and the error would name another pixel.
        if (!all_finite(light.data)) refuse_infinite_light(light);
        behind_lens = through_lens(sensor, light);
    }
    const Means means(sensor, behind_lens ? *behind_lens : light);
    const Numbers numbers(sensor, frame);
    RawImage raw{light.width, light.height, {}};
    raw.values.resize(static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height));
    tbb::parallel_for(0, light.height, [&](int y) {
        const std::span row =
            std::span(raw.values).subspan(means.index(0, y), static_cast<std::size_t>(light.width));
        for (std::size_t begin = 0; begin < row.size(); begin += kNoiseLanes) {
            const std::size_t count = std::min(kNoiseLanes, row.size() - begin);
            NoiseLanes mean{};
            for (std::size_t i = 0; i < count; ++i)
                mean[i] = means.after_crosstalk(static_cast<int>(begin + i), y);
            numbers.write(mean, static_cast<std::uint32_t>(means.index(static_cast<int>(begin), y)),
                          row.subspan(begin, count));
        }
    });
    return raw;
}

}  // namespace nicol
