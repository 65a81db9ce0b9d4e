// SPDX-License-Identifier: MIT
#include "files/read_bytes.hpp"

#include <fstream>

#include "error.hpp"

namespace nicol {

std::string read_bytes(const std::filesystem::path& file) {
    std::error_code status;
    // Reading a device or a pipe might never end.
    if (!std::filesystem::is_regular_file(file, status))
        throw Error(ErrorCode::file_not_found, file.string() + ": no such file");
    std::ifstream in(file, std::ios::binary);
    const auto size = std::filesystem::file_size(file, status);
    if (!in || status) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read");
    std::string bytes(size, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!in) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read to its end");
    return bytes;
}

}  // namespace nicol
