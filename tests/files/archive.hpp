// SPDX-License-Identifier: MIT
// Valid and invalid ZIP and NumPy files built byte by byte.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

/// Returns the number as `size` little-endian bytes.
inline std::string bytes_of(std::uint64_t value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(i < 8 ? value >> (8 * i) & 0xff : 0);
    return bytes;
}

template <class T>
std::string raw(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Returns a .npy file with this dictionary.
inline std::string npy(const std::string& dictionary, const std::string& values, int version = 1) {
    std::string bytes = "\x93NUMPY";
    bytes += static_cast<char>(version);
    bytes += '\0';
    return bytes + bytes_of(dictionary.size(), version == 1 ? 2 : 4) + dictionary + values;
}

inline std::string header(const std::string& type, const std::string& shape, bool fortran = false) {
    return "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") +
           ", 'shape': " + shape + ", }\n";
}

/// One archive member. Tests may set its fields to wrong values.
struct ArchiveMember {
    explicit ArchiveMember(std::string name_, const std::string& content, bool deflated = false)
        : name(std::move(name_)), stored(content), size(content.size()), method(deflated ? 8 : 0) {
        crc = crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
        if (deflated) {
            z_stream stream{};
            deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
            stored.resize(deflateBound(&stream, static_cast<uLong>(content.size())));
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
            stream.avail_in = static_cast<uInt>(content.size());
            stream.next_out = reinterpret_cast<Bytef*>(stored.data());
            stream.avail_out = static_cast<uInt>(stored.size());
            if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("deflate");
            stored.resize(stream.total_out);
            deflateEnd(&stream);
        }
        stored_size = stored.size();
    }

    std::string name;
    std::string stored;
    std::uint64_t stored_size = 0, size = 0;
    std::uint64_t crc = 0;
    unsigned method = 0, flags = 0;
    std::uint64_t offset_error = 0;
    std::string local_extra;
};

/// Returns the whole archive. `declared` is the number of entries in the end record; -1 stands for the true
/// number.
inline std::string archive(const std::vector<ArchiveMember>& members, int declared = -1,
                           const std::string& comment = "") {
    std::string data;
    std::string directory;
    for (const ArchiveMember& m : members) {
        const std::string common = bytes_of(m.flags, 2) + bytes_of(m.method, 2) + bytes_of(0, 4) +
                                   bytes_of(m.crc, 4) + bytes_of(m.stored_size, 4) + bytes_of(m.size, 4) +
                                   bytes_of(m.name.size(), 2);
        directory += "PK\x01\x02" + bytes_of(20, 2) + bytes_of(20, 2) + common + bytes_of(0, 12) +
                     bytes_of(data.size() + m.offset_error, 4) + m.name;
        data += "PK\x03\x04" + bytes_of(20, 2) + common + bytes_of(m.local_extra.size(), 2) + m.name +
                m.local_extra + m.stored;
    }
    const std::uint64_t count = declared < 0 ? members.size() : static_cast<std::uint64_t>(declared);
    return data + directory + "PK\x05\x06" + bytes_of(0, 4) + bytes_of(count, 2) + bytes_of(count, 2) +
           bytes_of(directory.size(), 4) + bytes_of(data.size(), 4) + bytes_of(comment.size(), 2) + comment;
}
