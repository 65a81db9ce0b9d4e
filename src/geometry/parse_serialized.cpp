// SPDX-License-Identifier: MIT
// Parser of Mitsuba's serialized meshes: several per file, each deflated, with a directory at the end. All
// numbers are little-endian:
//     a mesh: u16 0x041C, u16 version (3 or 4), then a zlib stream of: u32 flags, from version 4 on a name
//             that ends in a zero, u64 vertices, u64 triangles, positions, normals, texture coordinates and
//             colours if the flags say so, and three u32 per triangle (u64 if a u32 cannot count the
// vertices)
//     the directory: the offset of each mesh (u64, in version 3 u32), then u32, their number
#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>
#include <new>

#include "error.hpp"
#include "geometry/finite.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/polygon_mesh.hpp"

namespace nicol::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied from memory as they are");

enum Flag : std::uint32_t { normals = 1, texcoords = 2, colors = 8, double_precision = 0x2000 };
constexpr std::uint16_t kMagic = 0x041C;
constexpr std::size_t kHeader = 4;
// Largest ratio of inflated to deflated size. Real meshes grow at most tenfold; a file that claims more is
// made to fill the memory.
constexpr std::uint64_t kMostGrowth = 256;

[[noreturn]] void fail(std::string_view name, const std::string& message) {
    throw Error(ErrorCode::invalid_file, std::string(name) + ": " + message);
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
    Number value{};
    std::memcpy(&value, bytes.data() + at, sizeof(Number));
    return value;
}

/// Inflated numbers of one mesh.
class Stream {
public:
    Stream(std::string_view name, std::string_view deflated, const LoadBudget& budget)
        : name_(name), budget_(budget), left_(kMostGrowth * (deflated.size() + 1)), deflated_(deflated) {
        if (inflateInit(&inflate_) != Z_OK) throw std::bad_alloc();
    }
    ~Stream() { inflateEnd(&inflate_); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    void read(void* to, std::size_t size) {
        if (size > left_) fail(name_, "the mesh is more than 256 times as large as its file");
        left_ -= size;
        budget_.take_memory(size);
        budget_.step(size);
        inflate_.next_out = static_cast<Bytef*>(to);
        while (size > 0) {
            const std::size_t step = std::min<std::size_t>(size, std::size_t{1} << 30U);
            inflate_.avail_out = static_cast<uInt>(step);
            size -= step;
            while (inflate_.avail_out > 0) {
                if (inflate_.avail_in == 0) feed();
                const int result = inflate(&inflate_, Z_NO_FLUSH);
                if (result == Z_MEM_ERROR) throw std::bad_alloc();
                if (result == Z_STREAM_END && inflate_.avail_out > 0)
                    fail(name_, "the mesh is shorter than it says");
                if (result != Z_OK && result != Z_STREAM_END) fail(name_, "the mesh cannot be inflated");
            }
        }
    }

    template <class Number>
    Number next() {
        Number value{};
        read(&value, sizeof(Number));
        return value;
    }

    /// Reads `count` vectors. Memory grows while they are read, because a file may claim more than it holds.
    template <class Vector, class Number>
    std::vector<Vector> vectors(std::uint64_t count) {
        constexpr std::uint64_t step = 65536;
        constexpr auto length = static_cast<std::size_t>(Vector::length());
        std::vector<Vector> out;
        std::vector<std::array<Number, length>> some;
        for (std::uint64_t first = 0; first < count; first += step) {
            some.resize(std::min(step, count - first));
            read(some.data(), some.size() * sizeof(some[0]));
            for (const auto& from : some) {
                Vector& to = out.emplace_back();
                for (std::size_t i = 0; i < length; ++i)
                    to[static_cast<glm::length_t>(i)] = static_cast<typename Vector::value_type>(from[i]);
            }
        }
        return out;
    }

private:
    void feed() {
        if (deflated_.empty()) fail(name_, "the file ends within the mesh");
        const std::string_view some = deflated_.substr(0, std::size_t{1} << 30U);
        deflated_.remove_prefix(some.size());
        inflate_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(some.data()));
        inflate_.avail_in = static_cast<uInt>(some.size());
    }

    std::string_view name_;
    const LoadBudget& budget_;
    std::uint64_t left_;
    std::string_view deflated_;
    z_stream inflate_{};
};

/// Returns the deflated bytes of one mesh of the file.
std::string_view mesh_at(std::string_view name, std::string_view bytes, std::size_t shape) {
    if (bytes.size() < kHeader + sizeof(std::uint32_t) || number_at<std::uint16_t>(bytes, 0) != kMagic)
        fail(name, "not a serialized mesh: it does not begin with 1C 04");
    const auto version = number_at<std::uint16_t>(bytes, 2);
    if (version != 3 && version != 4)
        throw Error(ErrorCode::unsupported, std::string(name) + ": serialized meshes of version " +
                                                std::to_string(version) + "; expected 3 or 4");
    const auto count = number_at<std::uint32_t>(bytes, bytes.size() - sizeof(std::uint32_t));
    const std::size_t entry = version == 3 ? 4 : 8;
    if (count == 0 || count > (bytes.size() - sizeof(std::uint32_t)) / entry)
        fail(name, "the file does not end in a directory of its meshes");
    if (shape >= count)
        fail(name, "has " + std::to_string(count) + " meshes; there is no mesh " + std::to_string(shape) +
                       " (0-based)");
    const std::size_t directory = bytes.size() - sizeof(std::uint32_t) - count * entry;
    const auto offset_of = [&](std::size_t i) -> std::uint64_t {
        const std::size_t at = directory + i * entry;
        return version == 3 ? number_at<std::uint32_t>(bytes, at) : number_at<std::uint64_t>(bytes, at);
    };
    const std::uint64_t begin = offset_of(shape);
    const std::uint64_t end = shape + 1 < count ? offset_of(shape + 1) : directory;
    if (end > directory || begin >= end || end - begin <= kHeader ||
        number_at<std::uint16_t>(bytes, begin) != kMagic)
        fail(name, "the directory's entry of mesh " + std::to_string(shape) + " (0-based) leads to none");
    return bytes.substr(begin + kHeader, end - begin - kHeader);
}

template <class Number>
void read_attributes(Stream& stream, std::uint32_t flags, std::uint64_t vertices, PolygonMesh& out) {
    out.positions = stream.vectors<glm::vec3, Number>(vertices);
    if ((flags & normals) != 0) out.normals = stream.vectors<glm::vec3, Number>(vertices);
    if ((flags & texcoords) != 0) out.texcoords = stream.vectors<glm::vec2, Number>(vertices);
    if ((flags & colors) != 0) out.colors = stream.vectors<glm::vec3, Number>(vertices);
}

// Texture coordinates and colours that are not finite stay.
PolygonMesh parse_serialized(const MeshBytes& mesh, LeftOut& left_out, const LoadBudget& budget) {
    const std::string_view name = mesh.name;
    const std::string_view bytes = mesh.bytes;
    const auto version = bytes.size() < kHeader ? std::uint16_t{0} : number_at<std::uint16_t>(bytes, 2);
    Stream stream(name, mesh_at(name, bytes, mesh.shape), budget);
    const auto flags = stream.next<std::uint32_t>();
    if (version >= 4)
        while (stream.next<char>() != 0) continue;
    const auto vertices = stream.next<std::uint64_t>();
    const auto triangles = stream.next<std::uint64_t>();
    if (vertices >= PolygonMesh::kNone || triangles >= PolygonMesh::kNone)
        throw Error(ErrorCode::unsupported, std::string(name) + ": more than 2^32 - 2 vertices or triangles");

    PolygonMesh out;
    if ((flags & double_precision) != 0) {
        read_attributes<double>(stream, flags, vertices, out);
    } else {
        read_attributes<float>(stream, flags, vertices, out);
    }
    for (std::size_t v = 0; v < out.positions.size(); ++v)
        if (!is_finite(out.positions[v]))
            fail(name, "vertex " + std::to_string(v) + " (0-based) is not finite");
    for (glm::vec3& n : out.normals) {
        if (is_finite(n)) continue;
        left_out.add("normals that are not finite");
        n = glm::vec3(0);
    }
    for (std::uint64_t t = 0; t < triangles; ++t) {
        for (const std::uint32_t v : stream.next<std::array<std::uint32_t, 3>>()) {
            if (v >= vertices)
                fail(name, "face " + std::to_string(t) + " (0-based) uses vertex " + std::to_string(v) +
                               ", but there are " + std::to_string(vertices));
            out.corners.push_back({.position = v,
                                   .normal = out.normals.empty() ? PolygonMesh::kNone : v,
                                   .texcoord = out.texcoords.empty() ? PolygonMesh::kNone : v});
        }
        out.end_face(left_out);
    }
    return out;
}

bool begins_as_serialized(std::string_view bytes) {
    return bytes.starts_with("\x1c\x04");
}

}  // namespace

const MeshFormat kSerialized{.name = "serialized",
                             .kind = "a Mitsuba mesh",
                             .parse = parse_serialized,
                             .begins = begins_as_serialized,
                             .several_meshes = true};

}  // namespace nicol::geometry
