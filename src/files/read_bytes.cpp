// SPDX-License-Identifier: MIT
#include "files/read_bytes.hpp"

#include <algorithm>

#include "error.hpp"

namespace nicol {

std::string read_bytes(const std::filesystem::path& file, const LoadBudget& budget) {
    const FileSource& files = budget.files();
    const auto found = files.find(file);
    if (!found) {
        // Names in memory have no folders; every name may be one.
        const bool is_folder = &files == &file_system() && files.has_folder(file);
        throw Error(ErrorCode::file_not_found,
                    file.string() + (is_folder ? ": is a folder; expected a file" : ": no such file"));
    }
    const auto in = files.open(file);
    if (!in) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read");
    const std::uint64_t size = found->bytes;
    std::string bytes(size, '\0');
    constexpr std::size_t most = std::size_t{1} << 22;
    for (std::size_t at = 0; *in && at < size; at += most) {
        const std::size_t count = std::min(most, size - at);
        in->read(bytes.data() + at, static_cast<std::streamsize>(count));
        budget.step(count);
    }
    if (!*in) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read to its end");
    return bytes;
}

}  // namespace nicol
