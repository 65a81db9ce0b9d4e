// SPDX-License-Identifier: MIT
// The dot products of shade, sixteen vertices at once.
#pragma once

#include <cstddef>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/mirror_basis.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// The terms that light and response share, by azimuthal frequency.
struct ShadeTerms {
    explicit ShadeTerms(const LightLayout& layout);

    /// Pairs [first, last) of a basis have one frequency m.
    struct Run {
        std::size_t first = 0;
        std::size_t last = 0;
    };

    MirrorBasis basis;
    std::vector<Run> scalars;  // by m
    std::vector<Run> spins;
    bool circular;
};

/// Makes rows of a response table, [p][entry of the layout], ready for respond(). In place.
void prepare_rows(const ShadeTerms& terms, std::size_t row_size, std::size_t rows, Lanes* table);

/// stokes[p] for p < rows (1, 3 or 4) = the response of prepared rows to a split light, rotated by the
/// azimuth phi: cosine and sine hold those of m phi.
void respond(const ShadeTerms& terms, std::size_t row_size, std::size_t rows, const Lanes* table,
             const Lanes* light, const Lanes* cosine, const Lanes* sine, Lanes* stokes);

}  // namespace nicol
