// SPDX-License-Identifier: MIT
// Tests of Mitsuba's serialized meshes, written here by its documentation.
#include <zlib.h>

#include <cstring>

#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

template <class T>
std::string raw(T value) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    return bytes;
}

std::string deflated(const std::string& content) {
    uLongf size = compressBound(static_cast<uLong>(content.size()));
    std::string out(size, '\0');
    REQUIRE(compress(reinterpret_cast<Bytef*>(out.data()), &size,
                     reinterpret_cast<const Bytef*>(content.data()),
                     static_cast<uLong>(content.size())) == Z_OK);
    out.resize(size);
    return out;
}

// Returns the content of a mesh: a triangle at z = `height` with every kind of vertex data.
template <class Number>
std::string triangle(int version, Number height, std::uint32_t last = 2) {
    const bool is_double = sizeof(Number) == 8;
    std::string out = raw<std::uint32_t>((is_double ? 0x2000U : 0x1000U) | 1U | 2U | 8U);
    if (version == 4) out += std::string("name\0", 5);
    out += raw<std::uint64_t>(3) + raw<std::uint64_t>(1);
    for (const int x : {0, 0, 1, 1, 0, 1, 0, 1, 1}) out += raw(static_cast<Number>(x));
    for (int v = 0; v < 3; ++v)
        for (const Number x : {Number(0), Number(0), height}) out += raw(x);
    for (const Number x : {Number(0), Number(0), Number(0.5), Number(0), Number(0), Number(1)}) out += raw(x);
    for (const int x : {1, 0, 0, 0, 1, 0, 0, 0, 1}) out += raw(static_cast<Number>(x));
    for (const std::uint32_t i : {0U, 1U, last}) out += raw(i);
    return out;
}

std::string file_of(int version, const std::vector<std::string>& contents) {
    std::string out;
    std::string directory;
    for (const std::string& content : contents) {
        directory += version == 3 ? raw(static_cast<std::uint32_t>(out.size()))
                                  : raw(static_cast<std::uint64_t>(out.size()));
        out += raw<std::uint16_t>(0x041C) + raw(static_cast<std::uint16_t>(version)) + deflated(content);
    }
    return out + directory + raw(static_cast<std::uint32_t>(contents.size()));
}

}  // namespace

TEST_CASE("each mesh of a serialized file is read, of both versions and precisions") {
    const TemporaryFolder folder;
    for (const int version : {3, 4}) {
        CAPTURE(version);
        const auto file = folder.write("a.serialized",
                                       file_of(version, {triangle(version, 2.0F), triangle(version, -1.0)}));
        for (const std::size_t shape : {0, 1}) {
            const Mesh mesh = load_mesh(file, {}, shape);
            CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
            for (const glm::vec3& n : mesh.normals) CHECK(n == glm::vec3(0, 0, shape == 0 ? 1 : -1));
            CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}});
            CHECK(mesh.colors == std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
            REQUIRE(mesh.texcoord_triangles.size() == 1);
            CHECK(mesh.texcoords[mesh.texcoord_triangles[0].y] == glm::vec2(0.5F, 0));
        }
    }
}

TEST_CASE("faults of serialized files") {
    const std::string content = triangle(4, 1.0F);
    const std::string good = file_of(4, {content});
    std::string no_magic = good;
    no_magic[0] = 'x';
    std::string version = good;
    version[2] = 7;
    std::string astray = good;
    astray[good.size() - 5] = '\x7f';
    // The header claims 2^32 - 2 vertices, but the data are zeros that compress by a factor of a thousand.
    std::string bomb = raw<std::uint32_t>(0x1000U) + std::string(1, '\0') + raw<std::uint64_t>(0xfffffffe) +
                       raw<std::uint64_t>(1) + std::string(1 << 24, '\0');
    struct Row {
        std::string bytes;
        ErrorCode code;
        std::string part;
        std::size_t shape = 0;
    };
    const std::vector<Row> rows{
        {"", ErrorCode::invalid_file, "begin with 1C 04"},
        {no_magic, ErrorCode::invalid_file, "begin with 1C 04"},
        {version, ErrorCode::unsupported, "version 7; expected 3 or 4"},
        {good, ErrorCode::invalid_file, "has 1 meshes; there is no mesh 1 (0-based)", 1},
        {astray, ErrorCode::invalid_file, "directory's entry of mesh 0 (0-based) leads to none"},
        {good.substr(0, good.size() - 4) + raw<std::uint32_t>(0), ErrorCode::invalid_file,
         "end in a directory"},
        // The directory would begin before the start of the file.
        {good.substr(0, 15) + raw<std::uint32_t>(2), ErrorCode::invalid_file, "end in a directory"},
        {file_of(4, {content.substr(0, content.size() - 1)}), ErrorCode::invalid_file,
         "shorter than it says"},
        {file_of(4, {triangle(4, 1.0F, 3)}), ErrorCode::invalid_file, "face 0 (0-based) uses vertex 3"},
        {file_of(4, {bomb}), ErrorCode::invalid_file, "more than 256 times as large"}};
    const TemporaryFolder folder;
    for (const Row& row : rows) {
        CAPTURE(row.part);
        const auto file = folder.write("a.serialized", row.bytes);
        const std::string message = error_of(CALL(load_mesh(file, {}, row.shape)), row.code);
        CAPTURE(message);
        CHECK(message.starts_with(file.string()));
        CHECK(message.find(row.part) != std::string::npos);
    }
}

TEST_CASE("the meshes of Mitsuba's documentation load") {
    const auto file = test_data("mitsuba_scenes/common/meshes/matpreview.serialized");
    if (file.empty()) return;
    for (const std::size_t shape : {0, 1, 2}) {
        const Mesh mesh = load_mesh(file, {}, shape);
        CAPTURE(shape);
        CHECK(mesh.triangles.size() >= 2);
        for (const glm::vec3& n : mesh.normals) CHECK(glm::length(n) == doctest::Approx(1).epsilon(1e-5));
    }
}
