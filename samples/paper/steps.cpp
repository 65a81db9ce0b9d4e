// SPDX-License-Identifier: MIT
#include "steps.hpp"

std::span<const Step> steps() {
    static const Step all[] = {
        {"low orders 0-4, unshadowed",
         "low.exr",
         {.method = NICOL_METHOD_DENSE,
          .order_high = 4,
          .shadows = false,
          .high_orders = NICOL_HIGH_ORDERS_NONE}},
        {"+ shadow",
         "shadow.exr",
         {.method = NICOL_METHOD_DENSE, .order_high = 4, .high_orders = NICOL_HIGH_ORDERS_NONE}},
        {"low orders 0-5, + shadow",
         "five.exr",
         {.method = NICOL_METHOD_DENSE,
          .order_low = 5,
          .order_high = 5,
          .high_orders = NICOL_HIGH_ORDERS_NONE}},
        {"+ high orders 5-9 by convolution",
         "convolution.exr",
         {.method = NICOL_METHOD_DENSE, .high_orders = NICOL_HIGH_ORDERS_CONVOLUTION}},
        {"+ high orders 5-9 split", "stokes.exr", {}},
    };
    return all;
}
