// SPDX-License-Identifier: MIT
// Parser of Wavefront OBJ.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "error.hpp"
#include "files/first_statement.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/polygon_mesh.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {
namespace {

// Statements that are ignored: they describe no surface, or other programs ignore them too.
constexpr std::array<std::string_view, 19> kIgnored = {
    "vp",       "o",        "g",          "s",         "mg",  "l",     "p",    "mtllib", "usemap", "maplib",
    "c_interp", "d_interp", "shadow_obj", "trace_obj", "lod", "bevel", "call", "csh",    "off"};
constexpr std::array<std::string_view, 4> kFreeForm = {"curv", "curv2", "surf", "cstype"};

using Corner = PolygonMesh::Corner;
constexpr std::uint32_t kNone = PolygonMesh::kNone;

/// Returns the 0-based index for the text's 1-based one; a negative one counts back from the last. Returns
/// nothing if the text is neither. Moves `at` past the number.
std::optional<std::uint32_t> resolved(const char*& at, const char* end, std::size_t count_so_far) {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    at = stop;
    if (error != std::errc() || value == 0) return std::nullopt;
    if (value < 0) value += static_cast<std::int64_t>(count_so_far) + 1;
    if (value < 1 || value >= kNone) return std::nullopt;
    return static_cast<std::uint32_t>(value - 1);
}

/// Parses one file. Indices are checked at the end, since OBJ allows references to later vertices.
class ObjParser {
public:
    ObjParser(std::string_view name, std::string_view bytes, LeftOut& left_out, const LoadBudget& budget)
        : name_(name), bytes_(as_text(name, bytes)), left_out_(left_out), budget_(budget) {}

    PolygonMesh run() {
        std::size_t line_number = 0;
        while (!bytes_.empty()) {
            const std::size_t first_line = ++line_number;
            std::string joined;
            std::string_view line = take_line();
            // A backslash at its end continues a line.
            while (line.ends_with('\\') && !bytes_.empty()) {
                joined.append(line.substr(0, line.size() - 1)).append(" ");
                line = take_line();
                ++line_number;
            }
            if (!joined.empty()) line = joined.append(line);
            statement(line, first_line);
        }
        check_ranges();
        drop_missing_texcoords();
        if (!out_.colors.empty()) out_.colors.resize(out_.positions.size(), glm::vec3(1));
        left_out_.add("characters behind numbers", trailing_);
        left_out_.add("normals that are not finite", bad_normals_);
        left_out_.add("choices of a material (usemtl)", materials_);
        return std::move(out_);
    }

private:
    std::string_view take_line() {
        const std::size_t end = std::min(bytes_.find_first_of("\n\r"), bytes_.size());
        const std::string_view line = bytes_.substr(0, end);
        const bool two = bytes_.substr(end).starts_with("\r\n");
        bytes_.remove_prefix(std::min(end + (two ? 2 : 1), bytes_.size()));
        budget_.step(line.size() + 1);
        return line;
    }

    void statement(std::string_view line, std::size_t number) {
        Tokenizer tokens(name_, line, '#', number);
        const std::string_view key = tokens.next();
        if (key == "v") {
            vertex(tokens);
        } else if (key == "f" || key == "fo") {
            face(tokens, number);
        } else if (key == "vn") {
            normal(tokens);
        } else if (key == "vt") {
            texcoord(tokens);
        } else if (key == "usemtl") {
            ++materials_;
        } else if (std::ranges::find(kFreeForm, key) != kFreeForm.end()) {
            throw Error(ErrorCode::unsupported, std::string(name_) + ":" + std::to_string(number) +
                                                    ": free-form curves and surfaces (" + std::string(key) +
                                                    "); export polygons instead");
        } else if (!key.empty() && std::ranges::find(kIgnored, key) == kIgnored.end()) {
            tokens.fail(
                "a line that starts with none of OBJ's statements; expected v, vt, vn, f, a group or a "
                "comment");
        }
    }

    float number(Tokenizer& tokens, std::string_view what) {
        bool whole = true;
        const float value = tokens.number_at_start(what, whole);
        if (!whole) ++trailing_;
        return value;
    }

    void vertex(Tokenizer& tokens) {
        glm::vec3 p;
        p.x = number(tokens, "vertex x");
        p.y = number(tokens, "vertex y");
        p.z = number(tokens, "vertex z");
        out_.positions.push_back(p);
        if (Tokenizer(tokens).next().empty()) return;
        // A fourth number alone is a weight.
        std::array<float, 3> rest{};
        std::size_t count = 0;
        bool finite = true;
        while (!Tokenizer(tokens).next().empty() && count < rest.size())
            rest[count++] = tokens.number_or_zero("a colour", finite);
        if (count < rest.size() || !finite) return;
        out_.colors.resize(out_.positions.size(), glm::vec3(1));
        out_.colors.back() = {rest[0], rest[1], rest[2]};
    }

    void normal(Tokenizer& tokens) {
        glm::vec3 n;
        bool finite = true;
        n.x = tokens.number_or_zero("normal x", finite);
        n.y = tokens.number_or_zero("normal y", finite);
        n.z = tokens.number_or_zero("normal z", finite);
        if (!finite) ++bad_normals_;
        out_.normals.push_back(finite ? n : glm::vec3(0));
    }

    void texcoord(Tokenizer& tokens) {
        glm::vec2 uv(number(tokens, "texture u"), 0);
        if (!Tokenizer(tokens).next().empty()) uv.y = number(tokens, "texture v");
        out_.texcoords.push_back(uv);
    }

    std::optional<Corner> corner(std::string_view token) const {
        const char* at = token.data();
        const char* const end = at + token.size();
        const auto position = resolved(at, end, out_.positions.size());
        if (!position) return std::nullopt;
        Corner corner{.position = *position};
        if (at != end && *at == '/') {
            ++at;
            if (at != end && *at != '/') {
                const auto texcoord = resolved(at, end, out_.texcoords.size());
                if (!texcoord) return std::nullopt;
                corner.texcoord = *texcoord;
            }
            if (at != end && *at == '/') {
                ++at;
                if (at != end) {
                    const auto normal = resolved(at, end, out_.normals.size());
                    if (!normal) return std::nullopt;
                    corner.normal = *normal;
                }
            }
        }
        return at == end ? std::optional(corner) : std::nullopt;
    }

    void face(Tokenizer& tokens, std::size_t number) {
        const std::size_t first = out_.corners.size();
        for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
            const auto found = corner(token);
            if (!found)
                tokens.fail("corner " + std::to_string(out_.corners.size() - first) +
                            " of the face is not v, v/vt, v//vn or v/vt/vn with numbers that exist");
            out_.corners.push_back(*found);
            reach(furthest_position_, found->position, number);
            if (found->normal != kNone) reach(furthest_normal_, found->normal, number);
        }
        if (out_.corners.size() == first) tokens.fail("a face with no corners; it needs 3 or more");
        out_.end_face(left_out_);
    }

    /// Largest index of one kind plus 1, and the first line with that index.
    struct Furthest {
        std::uint64_t end = 0;
        std::size_t line = 0;
    };
    static void reach(Furthest& furthest, std::uint32_t index, std::size_t line) {
        if (index >= furthest.end) furthest = {.end = std::uint64_t{index} + 1, .line = line};
    }
    void check(const Furthest& furthest, const char* kind, std::size_t count) const {
        if (furthest.end > count)
            fail_at(name_, furthest.line,
                    "a face uses " + std::string(kind) + " " + std::to_string(furthest.end) +
                        " (1-based), but the file has " + std::to_string(count));
    }
    void check_ranges() const {
        check(furthest_position_, "vertex", out_.positions.size());
        check(furthest_normal_, "normal", out_.normals.size());
    }

    // Drops missing texture coordinates, because the surface is valid without them.
    void drop_missing_texcoords() {
        std::uint64_t missing = 0;
        for (Corner& corner : out_.corners) {
            if (corner.texcoord == kNone || corner.texcoord < out_.texcoords.size()) continue;
            corner.texcoord = kNone;
            ++missing;
        }
        left_out_.add("texture coordinates that the file does not have", missing);
    }

    std::string_view name_;
    std::string_view bytes_;
    LeftOut& left_out_;
    const LoadBudget& budget_;
    PolygonMesh out_;
    Furthest furthest_position_;
    Furthest furthest_normal_;
    std::uint64_t trailing_ = 0;
    std::uint64_t bad_normals_ = 0;
    std::uint64_t materials_ = 0;
};

PolygonMesh parse_obj(const MeshBytes& mesh, LeftOut& left_out, const LoadBudget& budget) {
    return ObjParser(mesh.name, mesh.bytes, left_out, budget).run();
}

// Blanks follow the keyword of a statement that can come first. Headers of binary STL files may look like
// one, but end in zeros.
bool begins_as_obj(std::string_view bytes) {
    if (bytes.substr(0, 256).find('\0') != std::string_view::npos) return false;
    constexpr std::array<std::string_view, 9> keywords{"v", "vt", "vn",     "f",     "g",
                                                       "o", "s",  "mtllib", "usemtl"};
    const std::string_view statement = first_statement(bytes);
    const std::size_t blank = statement.find_first_of(" \t");
    return blank != std::string_view::npos && std::ranges::count(keywords, statement.substr(0, blank)) > 0;
}

}  // namespace

const MeshFormat kObj{.name = "obj",
                      .kind = "an OBJ mesh",
                      .parse = parse_obj,
                      .begins = begins_as_obj,
                      .upward_texcoords = true};

}  // namespace nicol::geometry
