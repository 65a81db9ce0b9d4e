// SPDX-License-Identifier: MIT
#include "harmonics/batch_fft.hpp"

#include "test.hpp"

using namespace nicol;

TEST_CASE("Fourier transforms of every kind of length agree with the sum") {
    std::mt19937_64 random(3);
    for (const int n : {1,  2,  3,  4,  5,  6,  7,   8,   9,   11,  12,  13,  15,  16,  19,  21,
                        30, 49, 61, 64, 66, 67, 101, 122, 127, 134, 202, 210, 256, 257, 360, 602}) {
        CAPTURE(n);
        const auto count = static_cast<std::size_t>(n);
        BatchFft fft(n);
        for (int repeat = 0; repeat < 2; ++repeat) {
            std::normal_distribution<double> normal;
            std::vector<double> in(BatchFft::kElement * count);
            for (double& value : in) value = normal(random);
            std::vector<double> data = in;
            const double* out = fft.forward(data.data());
            double worst = 0;
            for (std::size_t k = 0; k < count; k += 1 + count / 40)
                for (std::size_t lane = 0; lane < BatchFft::kLanes; ++lane) {
                    std::complex<double> sum = 0;
                    for (std::size_t i = 0; i < count; ++i)
                        sum += std::complex(in[BatchFft::kElement * i + lane],
                                            in[BatchFft::kElement * i + 8 + lane]) *
                               std::polar(1.0, -2 * pi * static_cast<double>(i * k % count) / n);
                    worst =
                        std::max(worst, std::abs(sum - std::complex(out[BatchFft::kElement * k + lane],
                                                                    out[BatchFft::kElement * k + 8 + lane])));
                }
            CHECK(worst < 1e-14 * (3 + n));
        }
    }
}
