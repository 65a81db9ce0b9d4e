// SPDX-License-Identifier: MIT
// Writing of NumPy archives: every member is stored, and all sizes are known beforehand.
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <set>

#include "error.hpp"
#include "files/atomic_file.hpp"
#include "files/npz.hpp"

namespace nicol {
namespace {

constexpr std::uint64_t kMaxBytes = 0xfffffffe;
/// Date of all members, 1 January 1980, so that equal content makes equal files.
constexpr std::uint32_t kNoDate = 1 << 5 | 1;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw Error(ErrorCode::invalid_argument, "write_npz: member \"" + name + "\" " + what);
}

void append(std::string& bytes, std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

/// Returns magic, version 1.0 and the dictionary, padded so that values start at a multiple of 64 bytes.
std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape) {
    std::string text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (";
    for (const std::size_t n : shape) text += std::to_string(n) + ", ";
    // NumPy writes (3, 4) and (3,).
    if (shape.size() > 1) text.erase(text.size() - 2);
    if (shape.size() == 1) text.pop_back();
    text += "), }";
    while ((10 + text.size() + 1) % 64 != 0) text += ' ';
    text += '\n';
    std::string header = "\x93NUMPY\x01";
    header += '\0';
    append(header, static_cast<std::uint32_t>(text.size()), 2);
    return header + text;
}

/// Header and values of one member. Numbers are not copied.
struct Content {
    std::string header;
    std::string text;
    std::span<const double> values;

    [[nodiscard]] std::uint64_t size() const {
        return std::uint64_t{header.size()} + text.size() + std::uint64_t{8} * values.size();
    }
};

Content content_of(const NpzMember& member) {
    Content content;
    if (const auto* array = std::get_if<NpyArray>(&member.content)) {
        const bool empty = std::ranges::count(array->shape, 0u) > 0;
        std::size_t count = empty ? 0 : 1;
        for (const std::size_t n : array->shape) {
            if (!empty && count > array->values.size() / n)
                refuse(member.name, "has a shape beyond its values");
            count *= n;
        }
        if (count != array->values.size() || array->shape.size() > 32)
            refuse(member.name, "has " + std::to_string(array->values.size()) + " values, its shape says " +
                                    std::to_string(count));
        content.header = npy_header("<f8", array->shape);
        content.values = array->values;
    } else {
        const auto& text = std::get<std::string>(member.content);
        if (text.empty() || text.size() > 1024 ||
            std::any_of(text.begin(), text.end(), [](char c) { return c < 32 || c == 127; }))
            refuse(member.name, "must be 1 to 1024 printable ASCII characters");
        content.header = npy_header("<U" + std::to_string(text.size()), {});
        for (const char c : text) append(content.text, static_cast<std::uint32_t>(c), 4);
    }
    return content;
}

std::uint32_t checksum(const Content& content) {
    uLong crc = crc32_z(0, reinterpret_cast<const Bytef*>(content.header.data()), content.header.size());
    crc = crc32_z(crc, reinterpret_cast<const Bytef*>(content.text.data()), content.text.size());
    if (!content.values.empty())
        crc = crc32_z(crc, reinterpret_cast<const Bytef*>(content.values.data()), 8 * content.values.size());
    return static_cast<std::uint32_t>(crc);
}

/// Returns the fields that local header and directory share: version, flags, method, date, CRC, sizes, name
/// length.
std::string common_fields(const std::string& file_name, const Content& content, std::uint32_t crc) {
    std::string bytes;
    append(bytes, 20, 2);
    append(bytes, 0, 4);
    append(bytes, 0, 2);
    append(bytes, kNoDate, 2);
    append(bytes, crc, 4);
    append(bytes, static_cast<std::uint32_t>(content.size()), 4);
    append(bytes, static_cast<std::uint32_t>(content.size()), 4);
    append(bytes, static_cast<std::uint32_t>(file_name.size()), 2);
    append(bytes, 0, 2);
    return bytes;
}

}  // namespace

void write_npz(const std::filesystem::path& path, std::span<const NpzMember> members) {
    std::set<std::string> names;
    std::vector<Content> contents;
    std::uint64_t total = 0;
    for (const NpzMember& member : members) {
        if (member.name.empty() || member.name.size() > 200 || !names.insert(member.name).second)
            refuse(member.name, "needs a name of 1 to 200 bytes that no other has");
        contents.push_back(content_of(member));
        total += contents.back().size() + 1024;
    }
    if (total > kMaxBytes || members.size() > 1000)
        throw Error(ErrorCode::invalid_argument,
                    "write_npz: the archive must be smaller than 4 GiB and have at most 1000 members");

    AtomicFile file(path);
    std::string directory;
    std::uint32_t offset = 0;
    // A failed write stays recorded in the FILE, where commit() finds it.
    const auto write = [&](const void* bytes, std::size_t size) {
        if (size > 0) static_cast<void>(std::fwrite(bytes, 1, size, file.handle()));
        offset += static_cast<std::uint32_t>(size);
    };
    for (std::size_t i = 0; i < contents.size(); ++i) {
        const Content& content = contents[i];
        const std::string file_name = members[i].name + ".npy";
        const std::string fields = common_fields(file_name, content, checksum(content));
        directory += "PK\x01\x02";
        append(directory, 20, 2);
        directory += fields;
        append(directory, 0, 4);  // comment, volume
        append(directory, 0, 2);  // internal attributes
        append(directory, 0, 4);  // external attributes
        append(directory, offset, 4);
        directory += file_name;

        std::string local = "PK\x03\x04";
        local += fields;
        local += file_name;
        write(local.data(), local.size());
        write(content.header.data(), content.header.size());
        write(content.text.data(), content.text.size());
        write(content.values.data(), 8 * content.values.size());
    }
    std::string end = "PK\x05\x06";
    append(end, 0, 4);
    append(end, static_cast<std::uint32_t>(members.size()), 2);
    append(end, static_cast<std::uint32_t>(members.size()), 2);
    append(end, static_cast<std::uint32_t>(directory.size()), 4);
    append(end, offset, 4);
    append(end, 0, 2);
    write(directory.data(), directory.size());
    write(end.data(), end.size());
    file.commit();
}

}  // namespace nicol
