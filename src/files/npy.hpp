// SPDX-License-Identifier: MIT
// Headers of NumPy arrays.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/zip.hpp"

namespace nicol {

/// Header that precedes the values of an array.
struct NpyHeader {
    std::string type;  ///< NumPy's descr, such as "<f8"
    bool fortran_order = false;
    std::vector<std::size_t> shape;

    /// Returns the product of the shape. Throws Error(invalid_file) that names `member` if the product is
    /// above `most`.
    [[nodiscard]] std::size_t count(const std::string& member, std::size_t most) const;
};

/// Reads the header, versions 1 to 3, and leaves the stream at the first value. Throws Error(unsupported) for
/// structured types and later versions, and Error(invalid_file) that names `member` if the header is
/// malformed.
[[nodiscard]] NpyHeader read_npy_header(ZipStream& stream, const std::string& member);

}  // namespace nicol
