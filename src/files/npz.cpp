// SPDX-License-Identifier: MIT
// Reading of arrays from NumPy archives.
#include "files/npz.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "error.hpp"
#include "files/npy.hpp"

namespace nicol {
namespace {

using std::filesystem::path;
static_assert(std::endian::native == std::endian::little, "files are little-endian");

constexpr std::string_view kSuffix = ".npy";
constexpr std::size_t kMaxCharacters = 1024;

ZipEntry find_member(const path& file, std::string_view name, const FileSource& files) {
    std::string there;
    for (const ZipEntry& entry : read_zip_directory(file, files)) {
        if (entry.name == std::string(name).append(kSuffix)) return entry;
        // A few names are enough to identify the kind of file.
        if (there.size() < 200) there += (there.empty() ? "" : ", ") + entry.name;
    }
    throw Error(ErrorCode::invalid_file, file.string() + ": has no member " + std::string(name) +
                                             ".npy; it holds " + (there.empty() ? "none" : there));
}

/// Archive member whose size agrees with its header.
struct Member {
    Member(const path& file, std::string_view member_name, const FileSource& files)
        : name(file.string() + ": member " + std::string(member_name) + ".npy"),
          entry(find_member(file, member_name, files)),
          stream(file, entry, files),
          header(read_npy_header(stream, name)) {}

    std::size_t check_size(std::size_t value_bytes, std::size_t most) const {
        const std::size_t count = header.count(name, most);
        if (stream.left() != std::uint64_t{count} * value_bytes)
            throw Error(ErrorCode::invalid_file, name + " has " + std::to_string(stream.left()) +
                                                     " bytes of values; its shape needs " +
                                                     std::to_string(std::uint64_t{count} * value_bytes));
        return count;
    }

    std::string name;
    ZipEntry entry;
    ZipStream stream;
    NpyHeader header;
};

template <class T>
void read_values(Member& member, std::size_t count, const LoadBudget& budget, std::vector<double>& values) {
    std::array<T, 4096> chunk;
    // Stored bytes exist, whereas the size of deflated bytes is only a claim.
    values.reserve(member.entry.deflated ? std::min(count, chunk.size()) : count);
    while (values.size() < count) {
        const std::size_t n = std::min(chunk.size(), count - values.size());
        budget.step(n * sizeof(T));
        member.stream.read({reinterpret_cast<unsigned char*>(chunk.data()), n * sizeof(T)});
        for (std::size_t i = 0; i < n; ++i) {
            const auto value = static_cast<double>(chunk[i]);
            if constexpr (sizeof(T) == 8 && std::is_integral_v<T>) {
                constexpr T exact = T{1} << 53;
                if (chunk[i] > exact || chunk[i] < -exact)
                    throw Error(ErrorCode::invalid_file, member.name + " has an integer beyond 2^53");
            }
            values.push_back(value);
        }
    }
}

}  // namespace

std::vector<std::string> npz_members(const path& file, const LoadBudget& budget) {
    std::vector<std::string> names;
    for (const ZipEntry& entry : read_zip_directory(file, budget.files()))
        if (entry.name.ends_with(kSuffix))
            names.push_back(entry.name.substr(0, entry.name.size() - kSuffix.size()));
    return names;
}

NpyArray read_npz_member(const path& file, std::string_view name, std::size_t most_values,
                         const LoadBudget& budget) {
    Member member(file, name, budget.files());
    const std::string& type = member.header.type;
    if (type.ends_with('O'))
        throw Error(ErrorCode::unsupported, member.name + " is an object array; it must hold numbers");
    if (type != "<f4" && type != "<f8" && type != "<i4" && type != "<i8")
        throw Error(ErrorCode::unsupported,
                    member.name + " has type \"" + type + "\"; it must be <f4, <f8, <i4 or <i8");
    if (member.header.fortran_order && member.header.shape.size() > 1)
        throw Error(ErrorCode::unsupported,
                    member.name + " is in Fortran order; save it with numpy.ascontiguousarray");

    NpyArray array{member.header.shape, {}};
    const std::size_t count = member.check_size(type[2] == '4' ? 4 : 8, most_values);
    budget.take_memory(std::uint64_t{count} * sizeof(double));
    if (type == "<f4") read_values<float>(member, count, budget, array.values);
    if (type == "<f8") read_values<double>(member, count, budget, array.values);
    if (type == "<i4") read_values<std::int32_t>(member, count, budget, array.values);
    if (type == "<i8") read_values<std::int64_t>(member, count, budget, array.values);
    return array;
}

std::string read_npz_text(const path& file, std::string_view name, const LoadBudget& budget) {
    Member member(file, name, budget.files());
    const std::string& type = member.header.type;
    const bool wide = type.starts_with("<U");
    if (!wide && !type.starts_with("|S"))
        throw Error(ErrorCode::unsupported,
                    member.name + " has type \"" + type + "\"; it must be a text (U or S)");
    const std::size_t width = wide ? 4 : 1;
    if (member.header.count(member.name, 1) != 1 || member.stream.left() > width * kMaxCharacters ||
        member.stream.left() % width != 0)
        throw Error(ErrorCode::invalid_file, member.name + " must be one text of at most " +
                                                 std::to_string(kMaxCharacters) + " characters");
    std::vector<unsigned char> bytes(member.stream.left());
    member.stream.read(bytes);
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += width) {
        std::uint32_t c = 0;
        std::memcpy(&c, &bytes[i], width);
        if (c > 126 || (c < 32 && c != 0))
            throw Error(ErrorCode::invalid_file, member.name + " has characters that are not ASCII");
        text += static_cast<char>(c);
    }
    // NumPy pads texts with zeros.
    text.erase(text.find_last_not_of('\0') + 1);
    if (text.find('\0') != std::string::npos)
        throw Error(ErrorCode::invalid_file, member.name + " has a zero inside its text");
    return text;
}

}  // namespace nicol
