// SPDX-License-Identifier: MIT
// Reader of the visibility buffer of hits.frag.

struct Hit {
    bool exists;
    uint triangle;
    bool front;
};

Hit hit_of(uint texel) {
    return Hit(texel != 0u, (texel & 0x7fffffffu) - 1u, (texel & 0x80000000u) != 0u);
}
