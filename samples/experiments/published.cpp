// SPDX-License-Identifier: MIT
#include "published.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

Doubles published(const std::string& path, std::size_t count) {
    const auto fail = [&](const std::string& what) { throw std::runtime_error(path + ": " + what); };
    std::ifstream in(path, std::ios::binary);
    if (!in) fail("cannot be read");
    const std::string file{std::istreambuf_iterator<char>(in), {}};
    // The array begins with a signature and, in version 1, two bytes that hold the length of its header.
    const std::size_t member = file.find("coeff.npy");
    const std::size_t mark = member == std::string::npos ? member : file.find("\x93NUMPY\x01", member);
    if (mark == std::string::npos || file.size() < mark + 10) fail("has no member coeff that can be read");
    const auto byte = [&](std::size_t i) {
        return static_cast<std::size_t>(static_cast<unsigned char>(file[i]));
    };
    const std::size_t length = byte(mark + 8) + 256 * byte(mark + 9);
    const std::string head = file.substr(mark + 10, length);
    if (head.find("'<f8'") == std::string::npos || head.find("'fortran_order': False") == std::string::npos)
        fail("coeff must hold doubles, the last index running fastest");
    const std::size_t first = mark + 10 + length;
    const std::size_t end = file.find("PK\x01\x02", first);  // the archive's list of members
    if (end == std::string::npos || end - first < count * sizeof(double))
        fail("coeff must hold " + std::to_string(count) + " doubles");
    Doubles values(count);
    std::memcpy(values.data(), file.data() + first, count * sizeof(double));
    return values;
}
