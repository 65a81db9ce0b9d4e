// SPDX-License-Identifier: MIT
// Linear maps that make each number of at most two others.

struct SparseRow {
    int first;
    int second;
    float first_factor;
    float second_factor;
};
