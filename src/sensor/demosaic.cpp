// SPDX-License-Identifier: MIT
#include "sensor/demosaic.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "arguments.hpp"

namespace nicol {
namespace {

/// Values of all pixels, [y][x].
class Grid {
public:
    Grid(int width, int height)
        : width_(width), values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
    [[nodiscard]] double& operator()(int x, int y) { return values_[index(x, y)]; }
    [[nodiscard]] double operator()(int x, int y) const { return values_[index(x, y)]; }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_;
    std::vector<double> values_;
};

/// Returns the light behind each pixel's polarizer.
Grid intensities(const Sensor& sensor, const RawImage& raw) {
    Grid grid(raw.width, raw.height);
    const double dark = sensor.dark_current * sensor.exposure_time;
    std::array<double, 3> scale{};
    for (std::size_t c = 0; c < scale.size(); ++c) scale[c] = electrons_of(sensor, c);
    tbb::parallel_for(0, raw.height, [&](int y) {
        const std::uint16_t* const row =
            &raw.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(raw.width)];
        for (int x = 0; x < raw.width; ++x) {
            const std::size_t colour = sensor.mosaic == Mosaic::polarized_bayer ? colour_at(x, y) : 0;
            grid(x, y) = ((row[x] - sensor.black_level) / gain_of(sensor) - dark) / scale[colour];
        }
    });
    return grid;
}

/// Returns the positions of every second sample, from `first` on, on both sides of i: i itself twice if it is
/// one, and the nearest one twice beyond the first or the last.
std::pair<int, int> around(int i, int first, int count) {
    if ((i - first) % 2 == 0) return {i, i};
    if (i == 0) return {1, 1};
    if (i == count - 1) return {i - 1, i - 1};
    return {i - 1, i + 1};
}

/// Returns the bilinear interpolation of at(x, y), which is known at every second x and y from first_x and
/// first_y on.
template <class At>
double interpolated(const At& at, int x, int y, int first_x, int first_y, int width, int height) {
    const auto [left, right] = around(x, first_x, width);
    const auto [above, below] = around(y, first_y, height);
    return ((at(left, above) + at(right, above)) + (at(left, below) + at(right, below))) / 4;
}

/// Returns one colour at every pixel, behind the pixel's own polarizer. The pixels of one angle are an image
/// with R G / G B filters, in which colours are interpolated bilinearly.
Grid one_colour(const Grid& mosaic, std::size_t colour, int width, int height) {
    Grid grid(width, height);
    const int columns = width / 2;
    const int rows = height / 2;
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const int column = x / 2;
            const int row = y / 2;
            const auto at = [&](int c, int r) { return mosaic(2 * c + x % 2, 2 * r + y % 2); };
            if (colour != 1) {
                const int first = colour == 0 ? 0 : 1;
                grid(x, y) = interpolated(at, column, row, first, first, columns, rows);
            } else if ((column + row) % 2 == 1) {
                grid(x, y) = at(column, row);
            } else {
                const auto [left, right] = around(column, column + 1, columns);
                const auto [above, below] = around(row, row + 1, rows);
                grid(x, y) = ((at(left, row) + at(right, row)) + (at(column, above) + at(column, below))) / 4;
            }
        }
    });
    return grid;
}

void store(StokesImage& image, int channel, int x, int y, const std::array<float, 4>& stokes) {
    const std::span<float, 4> out = image.at(channel, y, x);
    for (std::size_t p = 0; p < 4; ++p) out[p] = stokes[p];
}

void demosaic_blocks(const Sensor& sensor, const Grid& grid, double across, StokesImage& image) {
    const int side = cell_side(sensor.mosaic);
    const bool coloured = sensor.mosaic == Mosaic::polarized_bayer;
    tbb::parallel_for(0, image.height, [&](int y) {
        for (int x = 0; x < image.width; ++x) {
            std::array<std::array<double, 4>, 3> sum{};
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i)
                    sum[coloured ? colour_at(i, j) : 0][angle_at(i, j)] += grid(side * x + i, side * y + j);
            if (coloured)
                for (double& green : sum[1]) green /= 2;
            for (int c = 0; c < image.channels; ++c)
                store(image, c, x, y, stokes_of_angles(sum[static_cast<std::size_t>(c)], across));
        }
    });
}

/// Returns i, reflected at the first and the last position, which keeps it even or odd.
int reflected(int i, int count) {
    const int period = 2 * (count - 1);
    const int place = (i % period + period) % period;
    return std::min(place, period - place);
}

/// Mean of two samples on opposite sides of a pixel, and how much the image varies along their line.
struct Along {
    double mean;
    double variation;
};

/// at(i, j): value of the wanted angle; own(i, j): value of the mosaic, of one angle at even distances.
template <class At, class Own>
Along along(const At& at, const Own& own, int dx, int dy) {
    const double before = at(-dx, -dy);
    const double after = at(dx, dy);
    const double middle = own(0, 0);
    return {(before + after) / 2, std::abs(after - before) + std::abs(own(2 * dx, 2 * dy) - middle) +
                                      std::abs(own(-2 * dx, -2 * dy) - middle)};
}

/// Weighs two directions by the inverse squares of their variations.
double less_varied(const Along& a, const Along& b) {
    const double weight_a = b.variation * b.variation;
    const double weight_b = a.variation * a.variation;
    if (weight_a + weight_b == 0) return (a.mean + b.mean) / 2;
    return (weight_a * a.mean + weight_b * b.mean) / (weight_a + weight_b);
}

/// Returns one angle at every pixel, after the gradient-based interpolation of Gao and Gruev (2013): first at
/// the pixels whose diagonal neighbours have the angle, along the diagonal that varies less; then at the
/// others, along the row or the column. A smooth weight replaces their threshold.
Grid one_angle(const Grid& mosaic, int first_x, int first_y, int width, int height) {
    Grid grid(width, height);
    const auto fill = [&](int step_x, int step_y) {
        tbb::parallel_for(0, height / 2, [&](int row) {
            const int y = 2 * row + (first_y + step_y) % 2;
            for (int x = (first_x + step_x) % 2; x < width; x += 2) {
                const auto at = [&](int i, int j) {
                    return grid(reflected(x + i, width), reflected(y + j, height));
                };
                const auto own = [&](int i, int j) {
                    return mosaic(reflected(x + i, width), reflected(y + j, height));
                };
                const bool diagonal = step_x == step_y;
                grid(x, y) = diagonal ? less_varied(along(at, own, 1, 1), along(at, own, 1, -1))
                                      : less_varied(along(at, own, 1, 0), along(at, own, 0, 1));
            }
        });
    };
    for (int y = first_y; y < height; y += 2)
        for (int x = first_x; x < width; x += 2) grid(x, y) = mosaic(x, y);
    fill(1, 1);
    fill(1, 0);
    fill(0, 1);
    return grid;
}

void interpolate_along_edges(const Grid& grid, double across, int channel, StokesImage& image) {
    std::vector<Grid> angles(4, Grid(0, 0));
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) angles[angle_at(i, j)] = one_angle(grid, i, j, image.width, image.height);
    tbb::parallel_for(0, image.height, [&](int y) {
        for (int x = 0; x < image.width; ++x)
            store(image, channel, x, y,
                  stokes_of_angles({angles[0](x, y), angles[1](x, y), angles[2](x, y), angles[3](x, y)},
                                   across));
    });
}

void interpolate_angles(const Grid& grid, double across, int channel, StokesImage& image) {
    tbb::parallel_for(0, image.height, [&](int y) {
        for (int x = 0; x < image.width; ++x) {
            std::array<double, 4> angles{};
            for (int j = 0; j < 2; ++j)
                for (int i = 0; i < 2; ++i)
                    angles[angle_at(i, j)] = interpolated(grid, x, y, i, j, image.width, image.height);
            store(image, channel, x, y, stokes_of_angles(angles, across));
        }
    });
}

}  // namespace

std::array<float, 4> stokes_of_angles(const std::array<double, 4>& intensities, double across) {
    const double s0 = ((intensities[0] + intensities[2]) + (intensities[1] + intensities[3])) / 2;
    return {static_cast<float>(s0 / (1 + across)),
            static_cast<float>((intensities[0] - intensities[2]) / (1 - across)),
            static_cast<float>((intensities[1] - intensities[3]) / (1 - across)), 0};
}

StokesImage demosaic(const Sensor& sensor, const RawImage& raw, Demosaic method) {
    const int channels = sensor.mosaic == Mosaic::polarized_bayer ? 3 : 1;
    check(sensor, raw.width, raw.height, channels);
    if (method > Demosaic::gradient) refuse("method must be one of the kinds of demosaicing");
    if (sensor.extinction_ratio == 1)
        refuse("extinction_ratio of the sensor is 1; such pixels polarize nothing");
    const int shrink = method == Demosaic::blocks ? cell_side(sensor.mosaic) : 1;
    StokesImage image(raw.width / shrink, raw.height / shrink, channels);
    const Grid grid = intensities(sensor, raw);
    const double across = sensor.extinction_ratio > 0 ? 1 / sensor.extinction_ratio : 0;
    if (sensor.mosaic == Mosaic::plain) {
        for (int y = 0; y < raw.height; ++y)
            for (int x = 0; x < raw.width; ++x)
                store(image, 0, x, y, {static_cast<float>(grid(x, y)), 0, 0, 0});
    } else if (method == Demosaic::blocks) {
        demosaic_blocks(sensor, grid, across, image);
    } else {
        const auto interpolate = method == Demosaic::gradient ? interpolate_along_edges : interpolate_angles;
        for (int c = 0; c < channels; ++c)
            interpolate(
                channels == 1 ? grid : one_colour(grid, static_cast<std::size_t>(c), raw.width, raw.height),
                across, c, image);
    }
    return image;
}

}  // namespace nicol
