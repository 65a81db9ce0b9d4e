// SPDX-License-Identifier: MIT
// Wavefront OBJ.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <vector>

#include "error.hpp"
#include "geometry/parse.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {
namespace {

// Statements that describe no surface, or whose effect is not supported.
constexpr std::array<std::string_view, 21> kIgnored = {
    "vt",         "vp",        "o",      "g",      "s",      "mg",       "l",
    "p",          "usemtl",    "mtllib", "usemap", "maplib", "c_interp", "d_interp",
    "shadow_obj", "trace_obj", "lod",    "bevel",  "call",   "csh",      "off"};
constexpr std::array<std::string_view, 4> kFreeForm = {"curv", "curv2", "surf", "cstype"};

/// 1-based position and normal of a corner; normal 0 if the file gives none.
struct Corner {
    std::uint64_t position = 0;
    std::uint64_t normal = 0;
};

/// A 1-based index; a negative one counts back from the last. Empty if the token is neither.
std::optional<std::uint64_t> resolved(std::string_view token, std::uint64_t count_so_far) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc() || end != token.data() + token.size() || value == 0) return std::nullopt;
    if (value > 0) return static_cast<std::uint64_t>(value);
    const std::uint64_t back = 0 - static_cast<std::uint64_t>(value);
    if (back > count_so_far) return std::nullopt;
    return count_so_far - back + 1;
}

std::optional<Corner> parsed_corner(std::string_view token, std::uint64_t positions, std::uint64_t normals) {
    const std::size_t first = token.find('/');
    const auto position = resolved(token.substr(0, first), positions);
    if (!position) return std::nullopt;
    if (first == std::string_view::npos) return Corner{*position, 0};
    const std::size_t second = token.find('/', first + 1);
    if (second == std::string_view::npos) return Corner{*position, 0};
    const auto normal = resolved(token.substr(second + 1), normals);
    if (!normal) return std::nullopt;
    return Corner{*position, *normal};
}

/// The shortest text of a number without a decimal point, 15e-1 for 1.5: OpenMesh expects the locale's
/// decimal point, which may be a comma.
std::string without_point(float x) {
    std::array<char, 32> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::scientific).ptr;
    const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    const std::size_t e = text.find('e');
    int exponent = 0;
    std::from_chars(text.data() + e + 2, end, exponent);
    if (text[e + 1] == '-') exponent = -exponent;
    std::string digits(text.substr(0, e));
    if (const std::size_t point = digits.find('.'); point != std::string::npos) {
        exponent -= static_cast<int>(digits.size() - point - 1);
        digits.erase(point, 1);
    }
    return digits + "e" + std::to_string(exponent);
}

/// Parses one file. Indices are checked at the end, since OBJ allows references to later vertices.
class ObjParser {
public:
    ObjParser(std::string_view name, std::string_view bytes) : name_(name), bytes_(bytes) {}

    ParsedFile run() {
        out_.suffix = ".obj";
        if (bytes_.starts_with("\xEF\xBB\xBF")) bytes_.remove_prefix(3);  // byte order mark
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
        return std::move(out_);
    }

private:
    std::string_view take_line() {
        const std::size_t end = std::min(bytes_.find('\n'), bytes_.size());
        std::string_view line = bytes_.substr(0, end);
        bytes_.remove_prefix(std::min(end + 1, bytes_.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    void statement(std::string_view line, std::size_t number) {
        Tokenizer tokens(name_, line, '#', number);
        const std::string_view key = tokens.next();
        if (key == "v" || key == "vn") {
            triple(key, line, number);
        } else if (key == "f" || key == "fo") {
            face(tokens, number);
        } else if (std::ranges::find(kFreeForm, key) != kFreeForm.end()) {
            throw Error(ErrorCode::unsupported, std::string(name_) + ":" + std::to_string(number) +
                                                    ": free-form curves and surfaces (" + std::string(key) +
                                                    "); export polygons instead");
        } else if (!key.empty() && std::ranges::find(kIgnored, key) == kIgnored.end()) {
            tokens.fail(
                "a line that starts with none of OBJ's statements; expected v, vn, f, a group or a comment");
        }
    }

    void triple(std::string_view key, std::string_view line, std::size_t number) {
        Tokenizer tokens(name_, line, '#', number);
        out_.bytes.append(tokens.next());
        for (const char* coordinate : {"x", "y", "z"})
            out_.bytes.append(" ").append(
                without_point(tokens.number(std::string(key == "v" ? "vertex " : "normal ") + coordinate)));
        out_.bytes.append("\n");
        ++(key == "v" ? out_.vertices : normals_);
    }

    void face(Tokenizer& tokens, std::size_t number) {
        corners_.clear();
        for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
            const auto corner = parsed_corner(token, out_.vertices, normals_);
            if (!corner)
                tokens.fail("corner " + std::to_string(corners_.size()) +
                            " of the face is not v, v/vt, v//vn or v/vt/vn with numbers that exist");
            corners_.push_back(*corner);
        }
        if (corners_.size() < 3)
            tokens.fail("a face with " + std::to_string(corners_.size()) + " corners; it needs 3 or more");
        out_.bytes.append("f");
        for (const Corner& corner : corners_) {
            if (corner.position > furthest_position_)
                furthest_position_ = corner.position, position_line_ = number;
            if (corner.normal > furthest_normal_) furthest_normal_ = corner.normal, normal_line_ = number;
            out_.bytes.append(" ").append(std::to_string(corner.position));
            if (corner.normal != 0) out_.bytes.append("//").append(std::to_string(corner.normal));
        }
        out_.bytes.append("\n");
        std::ranges::sort(corners_, {}, &Corner::position);
        if (std::ranges::adjacent_find(corners_, {}, &Corner::position) != corners_.end())
            tokens.fail("degenerate face " + std::to_string(out_.faces) +
                        " (0-based): it uses a vertex twice; remove the face or merge it with its neighbour");
        ++out_.faces;
    }

    void check_ranges() const {
        if (furthest_position_ > out_.vertices)
            fail_at(name_, position_line_,
                    "a face uses vertex " + std::to_string(furthest_position_) +
                        " (1-based), but the file has " + std::to_string(out_.vertices));
        if (furthest_normal_ > normals_)
            fail_at(name_, normal_line_,
                    "a face uses normal " + std::to_string(furthest_normal_) +
                        " (1-based), but the file has " + std::to_string(normals_));
    }

    std::string_view name_;
    std::string_view bytes_;
    ParsedFile out_;
    std::size_t normals_ = 0;
    std::vector<Corner> corners_;
    std::uint64_t furthest_position_ = 0;
    std::uint64_t furthest_normal_ = 0;
    std::size_t position_line_ = 0;
    std::size_t normal_line_ = 0;
};

}  // namespace

ParsedFile parse_obj(std::string_view name, std::string_view bytes) {
    return ObjParser(name, bytes).run();
}

}  // namespace nicol::geometry
