// SPDX-License-Identifier: MIT
// Parser of STL, text and binary.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <utility>

#include "error.hpp"
#include "files/first_statement.hpp"
#include "geometry/crease_normals.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/polygon_mesh.hpp"
#include "geometry/position_hash.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is copied from memory as it is");

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kFacetSize = 50;
constexpr std::size_t kNormalSize = 12;  // bytes of the normal at the start of a facet

using Corners = std::array<std::array<float, 3>, 3>;

/// Mesh of consecutive facets; equal positions are merged.
class StlMesh {
public:
    StlMesh(LeftOut& left_out, const LoadBudget& budget) : left_out_(left_out), budget_(budget) {}

    void add(std::string_view name, const Corners& facet) {
        ++facets_;
        budget_.step(16);
        if (facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0])
            return left_out_.add("triangles without area");
        for (const std::array<float, 3>& corner : facet) {
            if (!std::ranges::all_of(corner, [](float x) { return std::isfinite(x); }))
                throw Error(ErrorCode::invalid_file, std::string(name) + ": facet " +
                                                         std::to_string(facets_ - 1) +
                                                         " (0-based) has a corner that is not finite");
            const glm::vec3 position(corner[0], corner[1], corner[2]);
            const auto fresh = static_cast<std::uint32_t>(mesh_.positions.size());
            const auto [known, is_new] = vertices_.try_emplace(position, fresh);
            if (is_new) mesh_.positions.push_back(position);
            mesh_.corners.push_back({.position = known->second});
        }
        mesh_.face_ends.push_back(mesh_.corners.size());
    }
    [[nodiscard]] std::size_t facets() const { return facets_; }
    PolygonMesh take() { return std::move(mesh_); }

private:
    struct Hash {
        std::size_t operator()(const glm::vec3& position) const { return hash_of(position); }
    };
    LeftOut& left_out_;
    const LoadBudget& budget_;
    PolygonMesh mesh_;
    std::size_t facets_ = 0;
    std::unordered_map<glm::vec3, std::uint32_t, Hash> vertices_;
};

std::uint32_t binary_count(std::string_view bytes) {
    std::uint32_t count = 0;
    if (bytes.size() >= kHeaderSize) std::memcpy(&count, bytes.data() + 80, 4);
    return count;
}

void expect(Tokenizer& tokens, std::string_view expected) {
    const std::string_view token = tokens.require(expected);
    if (!std::ranges::equal(token, expected,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; }))
        tokens.fail("expected \"" + std::string(expected) + "\"");
}

void read_text(StlMesh& out, std::string_view name, std::string_view bytes) {
    Tokenizer tokens(name, bytes, 0);
    for (Tokenizer ahead = tokens; !ahead.next().empty(); ahead = tokens) {
        expect(tokens, "solid");
        tokens.rest_of_line();  // the name of the solid
        for (;;) {
            Tokenizer end = tokens;
            const std::string_view token = end.require("facet or endsolid");
            if (token == "endsolid" || token == "ENDSOLID") break;
            expect(tokens, "facet");
            expect(tokens, "normal");
            // The normal is ignored: it follows from the corners, and some programs write nan here.
            for (int i = 0; i < 3; ++i) tokens.require("the normal");
            expect(tokens, "outer");
            expect(tokens, "loop");
            Corners facet{};
            for (std::array<float, 3>& corner : facet) {
                expect(tokens, "vertex");
                for (float& x : corner)
                    x = tokens.number("a coordinate of facet " + std::to_string(out.facets()) + " (0-based)");
            }
            expect(tokens, "endloop");
            expect(tokens, "endfacet");
            out.add(name, facet);
        }
        tokens.next();
        tokens.rest_of_line();
    }
}

void read_binary(StlMesh& out, std::string_view name, std::string_view bytes) {
    const std::uint32_t count = binary_count(bytes);
    if (bytes.size() < kHeaderSize || (bytes.size() - kHeaderSize) / kFacetSize < count)
        throw Error(ErrorCode::invalid_file,
                    std::string(name) +
                        ": neither a text STL, which begins with \"solid\", nor a whole binary one: " +
                        std::to_string(count) + " facets take " +
                        std::to_string(kHeaderSize + std::uint64_t{count} * kFacetSize) +
                        " bytes, the file has " + std::to_string(bytes.size()));
    for (std::size_t f = 0; f < count; ++f) {
        Corners facet{};
        std::memcpy(&facet, bytes.data() + kHeaderSize + f * kFacetSize + kNormalSize, sizeof(facet));
        out.add(name, facet);
    }
}

bool begins_with_solid(std::string_view text) {
    return text.starts_with("solid") || text.starts_with("SOLID");
}

// Binary files may begin with "solid", too.
bool sized_as_binary(std::string_view bytes) {
    return bytes.size() >= kHeaderSize &&
           bytes.size() == kHeaderSize + std::uint64_t{binary_count(bytes)} * kFacetSize;
}

PolygonMesh parse_stl(const MeshBytes& mesh, LeftOut& left_out, const LoadBudget& budget) {
    StlMesh read(left_out, budget);
    const std::string_view text =
        sized_as_binary(mesh.bytes) ? std::string_view() : as_text(mesh.name, mesh.bytes);
    if (begins_with_solid(text))
        read_text(read, mesh.name, text);
    else
        read_binary(read, mesh.name, mesh.bytes);
    PolygonMesh out = read.take();
    add_crease_normals(out, kStlCreaseDegrees, budget);
    return out;
}

bool begins_as_stl(std::string_view bytes) {
    const std::string_view statement = first_statement(bytes);
    const std::string_view keyword = statement.substr(0, statement.find_first_of(" \t\r\n"));
    return sized_as_binary(bytes) || keyword == "solid" || keyword == "SOLID";
}

}  // namespace

const MeshFormat kStl{.name = "stl", .kind = "an STL mesh", .parse = parse_stl, .begins = begins_as_stl};

}  // namespace nicol::geometry
