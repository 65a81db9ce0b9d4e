// SPDX-License-Identifier: MIT
#include "render/filtered_image.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace nicol {
namespace {

// Weights, in a pixel, of the samples of the pixels first, first + 1 ... from it along one axis.
struct Taps {
    int first = 0;
    std::vector<float> weights;
};

Taps taps(const ReconstructionFilter& filter, double place) {
    const double radius = filter.radius();
    Taps out{.first = static_cast<int>(std::ceil(-radius - place)), .weights = {}};
    const int last = static_cast<int>(std::floor(radius - place));
    for (int i = out.first; i <= last; ++i) out.weights.push_back(static_cast<float>(filter(i + place)));
    return out;
}

// Calls visit(neighbour, weight) for each pixel within `size` that has a sample in the pixel `at`.
template <class Visit>
void for_neighbours(const Taps& taps, int at, int size, const Visit& visit) {
    for (std::size_t i = 0; i < taps.weights.size(); ++i) {
        const int neighbour = at + taps.first + static_cast<int>(i);
        if (neighbour >= 0 && neighbour < size) visit(static_cast<std::size_t>(neighbour), taps.weights[i]);
    }
}

std::vector<float> sums(const Taps& taps, int size) {
    std::vector<float> out(static_cast<std::size_t>(size));
    for (int at = 0; at < size; ++at)
        for_neighbours(taps, at, size,
                       [&](std::size_t, float weight) { out[static_cast<std::size_t>(at)] += weight; });
    return out;
}

}  // namespace

FilteredImage::FilteredImage(const ReconstructionFilter& filter, int width, int height, int channels)
    : filter_(filter),
      sum_(width, height, channels),
      weights_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      across_(sum_.data.size()) {}

void FilteredImage::add(const StokesImage& samples, const glm::dvec2& place) {
    const Taps x = taps(filter_, place.x);
    const Taps y = taps(filter_, place.y);
    const std::vector<float> sums_x = sums(x, sum_.width);
    const std::vector<float> sums_y = sums(y, sum_.height);
    const auto row = 4 * static_cast<std::size_t>(sum_.width);
    const int rows = sum_.height * sum_.channels;

    tbb::parallel_for(0, rows, [&](int r) {
        const float* from = samples.data.data() + static_cast<std::size_t>(r) * row;
        float* to = across_.data() + static_cast<std::size_t>(r) * row;
        for (int at = 0; at < sum_.width; ++at, to += 4) {
            std::fill_n(to, 4, 0.0F);
            for_neighbours(x, at, sum_.width, [&](std::size_t neighbour, float weight) {
                for (std::size_t p = 0; p < 4; ++p) to[p] += weight * from[4 * neighbour + p];
            });
        }
    });
    tbb::parallel_for(0, rows, [&](int r) {
        const int at = r % sum_.height;
        const std::size_t of_channel = static_cast<std::size_t>(r - at) * row;
        float* to = sum_.data.data() + static_cast<std::size_t>(r) * row;
        for_neighbours(y, at, sum_.height, [&](std::size_t neighbour, float weight) {
            const float* from = across_.data() + of_channel + neighbour * row;
            for (std::size_t i = 0; i < row; ++i) to[i] += weight * from[i];
        });
    });
    for (std::size_t i = 0; i < sums_y.size(); ++i)
        for (std::size_t k = 0; k < sums_x.size(); ++k)
            weights_[i * sums_x.size() + k] += sums_y[i] * sums_x[k];
}

StokesImage FilteredImage::mean() && {
    for (std::size_t i = 0; i < sum_.data.size(); ++i) sum_.data[i] /= weights_[i / 4 % weights_.size()];
    return std::move(sum_);
}

}  // namespace nicol
