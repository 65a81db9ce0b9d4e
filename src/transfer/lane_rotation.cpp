// SPDX-License-Identifier: MIT
#include "transfer/lane_rotation.hpp"

#include <cmath>
#include <numbers>

#include "nicol/psh.hpp"
#include "nicol/wigner.hpp"
#include "transfer/simd.hpp"

namespace nicol {
namespace {

// out[r] = sum_c matrix[r][c] in[c]; four rows share each load.
NICOL_MULTIVERSION
void multiply(const float* matrix, std::size_t rows, std::size_t columns, const Lanes* in, Lanes* out) {
    std::size_t r = 0;
    for (; r + 4 <= rows; r += 4) {
        const float* m = matrix + r * columns;
        Lanes a{};
        Lanes b{};
        Lanes c{};
        Lanes d{};
        for (std::size_t n = 0; n < columns; ++n) {
            for (std::size_t i = 0; i < kLanes; ++i) a.value[i] += m[n] * in[n].value[i];
            for (std::size_t i = 0; i < kLanes; ++i) b.value[i] += m[columns + n] * in[n].value[i];
            for (std::size_t i = 0; i < kLanes; ++i) c.value[i] += m[2 * columns + n] * in[n].value[i];
            for (std::size_t i = 0; i < kLanes; ++i) d.value[i] += m[3 * columns + n] * in[n].value[i];
        }
        out[r] = a;
        out[r + 1] = b;
        out[r + 2] = c;
        out[r + 3] = d;
    }
    for (; r < rows; ++r) {
        const float* m = matrix + r * columns;
        Lanes a{};
        for (std::size_t n = 0; n < columns; ++n) {
            for (std::size_t i = 0; i < kLanes; ++i) a.value[i] += m[n] * in[n].value[i];
        }
        out[r] = a;
    }
}

// exp(i m angle) for m = 0..count-1 from exp(i angle), in double so that high powers keep their digits.
NICOL_MULTIVERSION
void raise(const std::array<double, kLanes>& cosine, const std::array<double, kLanes>& sine,
           std::size_t count, Lanes* cosines, Lanes* sines) {
    alignas(64) std::array<double, kLanes> re{};
    alignas(64) std::array<double, kLanes> im{};
    re.fill(1);
    for (std::size_t m = 0; m < count; ++m) {
        for (std::size_t i = 0; i < kLanes; ++i) cosines[m].value[i] = static_cast<float>(re[i]);
        for (std::size_t i = 0; i < kLanes; ++i) sines[m].value[i] = static_cast<float>(im[i]);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const double next = re[i] * cosine[i] - im[i] * sine[i];
            im[i] = im[i] * cosine[i] + re[i] * sine[i];
            re[i] = next;
        }
    }
}

// (re + i im) *= (c + i s), or its conjugate.
NICOL_MULTIVERSION
void turn(Lanes& re, Lanes& im, const Lanes& c, const Lanes& s, float sign) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float turned = re.value[i] * c.value[i] - sign * im.value[i] * s.value[i];
        im.value[i] = im.value[i] * c.value[i] + sign * re.value[i] * s.value[i];
        re.value[i] = turned;
    }
}

// (re + i im) = z (c + i s), or with its conjugate.
NICOL_MULTIVERSION
void spread(Lanes& re, Lanes& im, std::complex<float> z, const Lanes& c, const Lanes& s, float sign) {
    const float x = z.real();
    const float y = z.imag();
    for (std::size_t i = 0; i < kLanes; ++i) re.value[i] = x * c.value[i] - sign * y * s.value[i];
    for (std::size_t i = 0; i < kLanes; ++i) im.value[i] = y * c.value[i] + sign * x * s.value[i];
}

NICOL_MULTIVERSION
void add_and_subtract(const Lanes& a, const Lanes& b, Lanes& sum, Lanes& difference) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = a.value[i];
        const float y = b.value[i];
        sum.value[i] = x + y;
        difference.value[i] = x - y;
    }
}

std::size_t of_parity(int l, int odd) {  // how many of 0..l have n - l even (odd = 0) or odd
    return static_cast<std::size_t>(odd == 0 ? l / 2 + 1 : (l + 1) / 2);
}

int first_of_parity(int l, int odd) {
    return (l + odd) % 2;
}

std::size_t triangle(int l, int m) {
    return static_cast<std::size_t>(l * (l + 1) / 2 + m);
}

}  // namespace

LaneRotation::LaneRotation(int order) : order_(order) {
    const std::vector<double> d = wigner_d(order, -std::numbers::pi / 2);
    const auto count = static_cast<std::size_t>(order) + 1;
    for (int l = 0; l <= order; ++l) {
        const auto element = [&](int m, int n) {
            return static_cast<float>(
                d[wigner_offset(l) + static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)]);
        };
        Quarter& transposed = first_.emplace_back();
        Quarter& straight = second_.emplace_back();
        for (int odd_row = 0; odd_row < 2; ++odd_row) {
            for (int odd_column = 0; odd_column < 2; ++odd_column) {
                const auto part = static_cast<std::size_t>(2 * odd_row + odd_column);
                for (int a = first_of_parity(l, odd_row); a <= l; a += 2) {
                    for (int n = first_of_parity(l, odd_column); n <= l; n += 2) {
                        transposed.part[part].push_back(element(n, a));
                        straight.part[part].push_back(element(a, n));
                    }
                }
            }
        }
    }
    for (Phases* phases : {&azimuth_, &zenith_}) {
        phases->cosine.resize(count);
        phases->sine.resize(count);
    }
    re_.resize(psh_count(order));
    im_.resize(psh_count(order));
    folded_.resize(4 * count);
    product_.resize(4 * count);
}

void LaneRotation::set_normals(std::span<const glm::vec3> normals) {
    std::array<double, kLanes> azimuth_cosine{};
    std::array<double, kLanes> azimuth_sine{};
    std::array<double, kLanes> zenith_cosine{};
    std::array<double, kLanes> zenith_sine{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::dvec3 n(normals[i < normals.size() ? i : 0]);
        const double rho = std::hypot(n.x, n.y);
        // At a pole theta_phi_frame takes phi as 0, and so must this. The quarter turn is i exp(i phi).
        azimuth_cosine[i] = rho > 0 ? -n.y / rho : 0;
        azimuth_sine[i] = rho > 0 ? n.x / rho : 1;
        const double length = std::hypot(rho, n.z);
        zenith_cosine[i] = n.z / length;
        zenith_sine[i] = -rho / length;
    }
    raise(azimuth_cosine, azimuth_sine, azimuth_.cosine.size(), azimuth_.cosine.data(), azimuth_.sine.data());
    raise(zenith_cosine, zenith_sine, zenith_.cosine.size(), zenith_.cosine.data(), zenith_.sine.data());
}

// A real field has h_-m = (-1)^m conj(h_m), also between the two products, so each column contributes either
// its real or its imaginary part: to even results real parts where n = l mod 2 and imaginary ones elsewhere,
// to odd results the other way round; and the columns with n = l mod 2 make the real part of even results and
// the imaginary one of odd.
void LaneRotation::multiply_real(const Quarter& quarter, int l, std::size_t first) {
    for (int odd_row = 0; odd_row < 2; ++odd_row) {
        const int lowest = first_of_parity(l, odd_row);
        const std::size_t rows = of_parity(l, odd_row);
        const bool even_result = lowest % 2 == 0;
        for (int odd_column = 0; odd_column < 2; ++odd_column) {
            const bool real_parts = even_result == (odd_column == 0);
            const std::size_t columns = of_parity(l, odd_column);
            Lanes* folded = folded_.data();
            for (int n = first_of_parity(l, odd_column); n <= l; n += 2, ++folded) {
                const Lanes& part = (real_parts ? re_ : im_)[first + static_cast<std::size_t>(n)];
                const float factor = n == 0 ? 1.0F : 2.0F;
                for (std::size_t i = 0; i < kLanes; ++i) (*folded)[i] = factor * part[i];
            }
            const auto part = static_cast<std::size_t>(2 * odd_row + odd_column);
            multiply(quarter.part[part].data(), rows, columns, folded_.data(),
                     product_.data() + part * (static_cast<std::size_t>(order_) + 1));
        }
    }
    for (int odd_row = 0; odd_row < 2; ++odd_row) {
        const int lowest = first_of_parity(l, odd_row);
        const bool even_result = lowest % 2 == 0;
        const Lanes* same =
            product_.data() + static_cast<std::size_t>(2 * odd_row) * (static_cast<std::size_t>(order_) + 1);
        const Lanes* other = same + order_ + 1;
        for (int a = lowest; a <= l; a += 2, ++same, ++other) {
            re_[first + static_cast<std::size_t>(a)] = even_result ? *same : *other;
            im_[first + static_cast<std::size_t>(a)] = even_result ? *other : *same;
        }
    }
}

void LaneRotation::turn_real(std::span<const std::complex<float>> in) {
    for (int l = 0; l <= order_; ++l) {
        const std::size_t first = triangle(l, 0);
        for (std::size_t m = 0; m <= static_cast<std::size_t>(l); ++m) {
            spread(re_[first + m], im_[first + m], in[first + m], azimuth_.cosine[m], azimuth_.sine[m], 1);
        }
        multiply_real(first_[static_cast<std::size_t>(l)], l, first);
        for (std::size_t k = 0; k <= static_cast<std::size_t>(l); ++k) {
            turn(re_[first + k], im_[first + k], zenith_.cosine[k], zenith_.sine[k], 1);
        }
        multiply_real(second_[static_cast<std::size_t>(l)], l, first);
    }
}

// out_{+-a} = E +- O: sums over columns with n = l mod 2 and over the others, of h_n + h_-n where l + a is
// even and of h_n - h_-n where it is odd.
void LaneRotation::multiply_complex(const Quarter& quarter, int l, std::size_t middle) {
    const std::size_t stride = static_cast<std::size_t>(order_) + 1;
    for (std::vector<Lanes>* values : {&re_, &im_}) {
        Lanes* centre = values->data() + middle;
        // [sum, difference] by the parity of the column.
        Lanes scratch;
        for (int odd_column = 0; odd_column < 2; ++odd_column) {
            std::size_t at = static_cast<std::size_t>(odd_column) * stride;
            for (int n = first_of_parity(l, odd_column); n <= l; n += 2, ++at) {
                if (n == 0) {
                    folded_[at] = *centre;
                    folded_[at + 2 * stride] = Lanes{};
                } else {
                    add_and_subtract(centre[n], centre[-n], folded_[at], folded_[at + 2 * stride]);
                }
            }
        }
        for (int odd_row = 0; odd_row < 2; ++odd_row) {
            const std::size_t rows = of_parity(l, odd_row);
            for (int odd_column = 0; odd_column < 2; ++odd_column) {
                const auto part = static_cast<std::size_t>(2 * odd_row + odd_column);
                multiply(quarter.part[part].data(), rows, of_parity(l, odd_column),
                         folded_.data() + part * stride, product_.data() + part * stride);
            }
        }
        for (int odd_row = 0; odd_row < 2; ++odd_row) {
            const Lanes* same = product_.data() + static_cast<std::size_t>(2 * odd_row) * stride;
            const Lanes* other = same + stride;
            for (int a = first_of_parity(l, odd_row); a <= l; a += 2, ++same, ++other) {
                add_and_subtract(*same, *other, centre[a], a == 0 ? scratch : centre[-a]);
            }
        }
    }
}

void LaneRotation::turn_complex(std::span<const std::complex<float>> in) {
    for (int l = 0; l <= order_; ++l) {
        const std::size_t middle = psh_index(l, 0);
        for (int m = -l; m <= l; ++m) {
            const std::size_t position = psh_index(l, m);
            const auto k = static_cast<std::size_t>(std::abs(m));
            spread(re_[position], im_[position], in[position], azimuth_.cosine[k], azimuth_.sine[k],
                   m < 0 ? -1.0F : 1.0F);
        }
        multiply_complex(first_[static_cast<std::size_t>(l)], l, middle);
        for (int m = -l; m <= l; ++m) {
            const std::size_t position = psh_index(l, m);
            const auto k = static_cast<std::size_t>(std::abs(m));
            turn(re_[position], im_[position], zenith_.cosine[k], zenith_.sine[k], m < 0 ? -1.0F : 1.0F);
        }
        multiply_complex(second_[static_cast<std::size_t>(l)], l, middle);
    }
}

}  // namespace nicol
