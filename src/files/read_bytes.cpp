// SPDX-License-Identifier: MIT
#include "files/read_bytes.hpp"

#include <algorithm>
#include <fstream>

#include "error.hpp"

namespace nicol {

std::string read_bytes(const std::filesystem::path& file, const LoadBudget& budget) {
    std::error_code status;
    // A device or a pipe is not read, because it may never end.
    if (!std::filesystem::is_regular_file(file, status))
        throw Error(ErrorCode::file_not_found, file.string() + ": no such file");
    std::ifstream in(file, std::ios::binary);
    const auto size = std::filesystem::file_size(file, status);
    if (!in || status) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read");
    std::string bytes(size, '\0');
    constexpr std::size_t most = std::size_t{1} << 22;
    for (std::size_t at = 0; in && at < size; at += most) {
        const std::size_t count = std::min(most, size - at);
        in.read(bytes.data() + at, static_cast<std::streamsize>(count));
        budget.step(count);
    }
    if (!in) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read to its end");
    return bytes;
}

}  // namespace nicol
