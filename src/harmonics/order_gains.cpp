// SPDX-License-Identifier: MIT
#include "harmonics/order_gains.hpp"

#include <cmath>
#include <string>

#include "error.hpp"
#include "harmonics/psh.hpp"

namespace nicol {
namespace {

void check_orders(int first, int last) {
    if (first < 0 || last < first || last > kMaxOrder) {
        throw Error(ErrorCode::invalid_argument,
                    "a lobe of orders " + std::to_string(first) + " to " + std::to_string(last) +
                        "; they must ascend within 0 to " + std::to_string(kMaxOrder));
    }
}

}  // namespace

OrderGains gaussian_gains(double width, int first, int last) {
    check_orders(first, last);
    if (!(width >= 0 && width <= 4)) {
        throw Error(ErrorCode::invalid_argument,
                    "the width of a lobe is " + std::to_string(width) + "; it must lie in 0 to 4 radians");
    }
    OrderGains gains(static_cast<std::size_t>(last) + 1);
    for (int l = first; l <= last; ++l)
        gains[static_cast<std::size_t>(l)] = std::exp(-0.5 * l * (l + 1.0) * width * width);
    return gains;
}

OrderGains cosine_gains(int first, int last) {
    check_orders(first, last);
    OrderGains gains(static_cast<std::size_t>(last) + 1);
    if (first == 0) gains[0] = 1;
    if (first <= 1 && last >= 1) gains[1] = 2.0 / 3;
    // The gain of even l is 2 (-1)^(l/2 - 1) l! / ((l + 2) (l - 1) 2^l (l/2)!^2) (Ramamoorthi and Hanrahan
    // 2001).
    double central = -1;
    for (int l = 2; l <= last; l += 2) {
        central *= -(l - 1.0) / l;
        if (l >= first) gains[static_cast<std::size_t>(l)] = 2 * central / ((l + 2.0) * (l - 1.0));
    }
    return gains;
}

}  // namespace nicol
