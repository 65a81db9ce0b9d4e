// SPDX-License-Identifier: MIT
// Parser of PLY, text and binary of either byte order.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "files/load_budget.hpp"
#include "geometry/mesh_format.hpp"
#include "geometry/ply_header.hpp"
#include "geometry/polygon_mesh.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry {
namespace {

using namespace ply;

/// Reader of the values after the header, in order, text or binary.
class Values {
public:
    Values(std::string_view name, std::string_view bytes, const Header& header, const LoadBudget& budget)
        : name_(name),
          bytes_(bytes.substr(header.size)),
          format_(header.format),
          tokens_(name, bytes_, 0, header.lines + 1),
          budget_(budget) {}

    /// Returns the next value. `what()` names the value in error messages, for example "vertex 5 (0-based)".
    template <class Name>
    double next(Type type, const Name& what) {
        budget_.step(8);
        if (format_ == Format::text) return tokens_.number(what());
        return binary(type, what);
    }

    /// Returns the next value, which is not finite if the text is no finite number.
    template <class Name>
    double any(Type type, const Name& what) {
        budget_.step(8);
        if (format_ != Format::text) return binary(type, what);
        bool finite = true;
        const float value = tokens_.number_or_zero(what(), finite);
        return finite ? value : std::numeric_limits<double>::quiet_NaN();
    }

    /// Returns the next value as a count or an index: an integer from 0 to 2^32 - 1.
    template <class Name>
    std::uint64_t integer(Type type, const Name& what) {
        budget_.step(8);
        if (format_ == Format::text) return tokens_.count(what());
        const double value = next(type, what);
        if (!(value >= 0.0 && value == std::floor(value) && value <= 4294967295.0))
            fail(what() + " has a count or an index that is not a whole number from 0 up");
        return static_cast<std::uint64_t>(value);
    }

    [[noreturn]] void fail(const std::string& message) const {
        if (format_ == Format::text) tokens_.fail(message);
        throw Error(ErrorCode::invalid_file, std::string(name_) + ": " + message);
    }

private:
    template <class Name>
    double binary(Type type, const Name& what) {
        switch (type) {
            case Type::i8:
                return raw<std::int8_t>(what);
            case Type::u8:
                return raw<std::uint8_t>(what);
            case Type::i16:
                return raw<std::int16_t>(what);
            case Type::u16:
                return raw<std::uint16_t>(what);
            case Type::i32:
                return raw<std::int32_t>(what);
            case Type::u32:
                return raw<std::uint32_t>(what);
            case Type::f32:
                return raw<float>(what);
            case Type::f64:
                return raw<double>(what);
        }
        return 0.0;
    }

    template <class T, class Name>
    double raw(const Name& what) {
        if (bytes_.size() - at_ < sizeof(T)) fail("the file ends within " + what());
        std::array<char, sizeof(T)> bytes{};
        std::copy_n(bytes_.data() + at_, sizeof(T), bytes.data());
        at_ += sizeof(T);
        if ((format_ == Format::big) != (std::endian::native == std::endian::big))
            std::ranges::reverse(bytes);
        return static_cast<double>(std::bit_cast<T>(bytes));
    }

    std::string_view name_;
    std::string_view bytes_;
    Format format_;
    Tokenizer tokens_;
    const LoadBudget& budget_;
    std::size_t at_ = 0;
};

/// Skips a property of one row.
template <class Name>
void skip(Values& values, const Property& property, const Name& what) {
    const std::uint64_t count = property.length ? values.integer(*property.length, what) : 1;
    for (std::uint64_t i = 0; i < count; ++i) values.any(property.type, what);
}

/// Use of a property of a vertex or a face.
enum Slot : std::size_t { x, y, z, nx, ny, nz, u, v, red, green, blue, slots, none = slots };

Slot slot_of(const Property& property) {
    struct Name {
        std::string_view name;
        Slot slot;
    };
    constexpr std::array<Name, 24> names = {{{"x", x},
                                             {"y", y},
                                             {"z", z},
                                             {"nx", nx},
                                             {"ny", ny},
                                             {"nz", nz},
                                             {"u", u},
                                             {"v", v},
                                             {"s", u},
                                             {"t", v},
                                             {"texture_u", u},
                                             {"texture_v", v},
                                             {"red", red},
                                             {"green", green},
                                             {"blue", blue},
                                             {"r", red},
                                             {"g", green},
                                             {"b", blue},
                                             {"color_0", red},
                                             {"color_1", green},
                                             {"color_2", blue},
                                             {"diffuse_red", red},
                                             {"diffuse_green", green},
                                             {"diffuse_blue", blue}}};
    const auto known = std::ranges::find(names, std::string_view(property.name), &Name::name);
    return known == names.end() || property.length ? none : known->slot;
}

/// Returns the name of the attribute that a property belongs to, as MeshColorNames has it; empty if none.
std::string attribute_of(const Property& property) {
    const std::size_t end = property.name.rfind('_');
    if (end == std::string::npos || property.length) return {};
    const std::string_view ending = std::string_view(property.name).substr(end + 1);
    const bool color = ending == "r" || ending == "g" || ending == "b";
    return property.name.substr(0, end) + (color ? "_color" : "");
}

/// Returns the value that counts as 1 in a colour: the largest of an integer type, or 1.
double largest(Type type) {
    switch (type) {
        case Type::u8:
            return std::numeric_limits<std::uint8_t>::max();
        case Type::u16:
            return std::numeric_limits<std::uint16_t>::max();
        default:
            return 1;
    }
}

/// Uses of an element's properties, and their values in one row.
class Row {
public:
    /// color: name of the attribute that becomes the colour, see MeshColorNames.
    Row(const Element& element, const std::string& color) : own_color_(color == MeshColorNames().vertices) {
        for (const Property& property : element.properties) {
            Slot slot = slot_of(property);
            if (!own_color_) {
                if (slot >= red) slot = none;
                if (attribute_of(property) == color) slot = std::min(Slot(red + numbers_++), none);
            }
            if (present_[slot]) slot = none;  // only the first of two equal names counts
            present_[slot] = true;
            slots_.push_back(slot);
        }
    }

    [[nodiscard]] Slot slot(std::size_t property) const { return slots_[property]; }
    [[nodiscard]] bool has(Slot first, Slot last) const {
        return std::all_of(&present_[first], &present_[last] + 1, [](bool is_there) { return is_there; });
    }
    void set(Slot slot, Type type, double value) {
        values_[slot] = slot >= red && own_color_ ? value / largest(type) : value;
    }
    [[nodiscard]] bool has_color() const {
        return own_color_ ? has(red, blue) : numbers_ == 1 || numbers_ == 3;
    }
    /// Returns the colour of the row; black if it is not finite.
    [[nodiscard]] glm::vec3 color() {
        if (numbers_ == 1) values_[green] = values_[blue] = values_[red];
        return triple(red);
    }
    [[nodiscard]] bool finite(Slot first, Slot last) const {
        return std::all_of(&values_[first], &values_[last] + 1,
                           [](double value) { return std::abs(value) <= std::numeric_limits<float>::max(); });
    }
    /// Returns two values of the row; 0 if they are not finite.
    [[nodiscard]] glm::vec2 pair(Slot first) const {
        return finite(first, Slot(first + 1)) ? glm::vec2(values_[first], values_[first + 1]) : glm::vec2(0);
    }
    [[nodiscard]] glm::vec3 triple(Slot first) const {
        return finite(first, Slot(first + 2))
                   ? glm::vec3(values_[first], values_[first + 1], values_[first + 2])
                   : glm::vec3(0);
    }

private:
    bool own_color_;           // whether the colour is red, green and blue
    unsigned numbers_ = 0;     // number of properties of another attribute
    std::vector<Slot> slots_;  // by property
    std::array<bool, slots + 1> present_{};
    std::array<double, slots + 1> values_{};
};

void read_vertices(Values& values, const Element& element, const MeshColorNames& names, PolygonMesh& out,
                   LeftOut& left_out) {
    Row row(element, names.vertices);
    for (const auto& [needed, name] : {std::pair(x, "x"), {y, "y"}, {z, "z"}})
        if (!row.has(needed, needed))
            values.fail("the vertices have no property " + std::string(name) + "; expected x, y and z");
    const bool normals = row.has(nx, nz);
    const bool texcoords = row.has(u, v);
    const bool colors = row.has_color();
    for (std::uint64_t i = 0; i < element.count; ++i) {
        const auto what = [&] { return "vertex " + std::to_string(i) + " (0-based)"; };
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const Property& property = element.properties[p];
            const Slot slot = row.slot(p);
            if (slot == none) {
                skip(values, property, what);
                continue;
            }
            row.set(slot, property.type,
                    slot <= z ? values.next(property.type, what) : values.any(property.type, what));
            if (slot <= z && !row.finite(slot, slot))
                values.fail(what() + " has a " + property.name + " that is not finite");
        }
        out.positions.push_back(row.triple(x));
        if (normals) {
            if (!row.finite(nx, nz)) left_out.add("normals that are not finite");
            out.normals.push_back(row.triple(nx));
        }
        if (texcoords) out.texcoords.push_back(row.pair(u));
        if (colors) out.colors.push_back(row.color());
    }
}

void check_index(const Values& values, const PolygonMesh& mesh, std::uint32_t index, std::uint64_t face) {
    if (index >= mesh.positions.size())
        values.fail("face " + std::to_string(face) + " (0-based) uses vertex " + std::to_string(index) +
                    ", but there are " + std::to_string(mesh.positions.size()));
}

void read_faces(Values& values, const Element& element, const MeshColorNames& names, PolygonMesh& out,
                LeftOut& left_out) {
    const auto is_indices = [](const Property& p) {
        return p.length && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    if (std::ranges::count_if(element.properties, is_indices) != 1)
        values.fail("the faces have no list vertex_indices, or more than one");
    Row row(element, names.faces);
    const bool colors = row.has_color();
    std::vector<float> texcoords;
    for (std::uint64_t f = 0; f < element.count; ++f) {
        const auto what = [&] { return "face " + std::to_string(f) + " (0-based)"; };
        const std::size_t first = out.corners.size();
        texcoords.clear();
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const Property& property = element.properties[p];
            if (is_indices(property)) {
                const std::uint64_t corners = values.integer(*property.length, what);
                for (std::uint64_t i = 0; i < corners; ++i) {
                    const auto index = static_cast<std::uint32_t>(values.integer(property.type, what));
                    if (!out.positions.empty()) check_index(values, out, index, f);
                    out.corners.push_back({.position = index});
                }
            } else if (property.length && property.name == "texcoord") {
                const std::uint64_t count = values.integer(*property.length, what);
                for (std::uint64_t i = 0; i < count; ++i)
                    texcoords.push_back(static_cast<float>(values.any(property.type, what)));
            } else if (row.slot(p) >= red && row.slot(p) != none) {
                row.set(row.slot(p), property.type, values.any(property.type, what));
            } else {
                skip(values, property, what);
            }
        }
        if (texcoords.size() == 2 * (out.corners.size() - first)) {
            for (std::size_t i = 0; i < texcoords.size(); i += 2) {
                out.corners[first + i / 2].texcoord = static_cast<std::uint32_t>(out.texcoords.size());
                out.texcoords.emplace_back(texcoords[i], texcoords[i + 1]);
            }
        }
        if (out.end_face(left_out) && colors) out.face_colors.push_back(row.color());
    }
}

/// Gives each corner its vertex's attributes, except texture coordinates if the corner has its own. The
/// texture coordinates of vertices begin at `first_texcoord` (kNone: vertices have none).
void complete_corners(const Values& values, PolygonMesh& out, std::uint32_t first_texcoord) {
    for (std::size_t f = 0, i = 0; f < out.face_ends.size(); ++f) {
        for (; i < out.face_ends[f]; ++i) {
            PolygonMesh::Corner& corner = out.corners[i];
            check_index(values, out, corner.position, f);
            if (!out.normals.empty()) corner.normal = corner.position;
            if (corner.texcoord == PolygonMesh::kNone && first_texcoord != PolygonMesh::kNone)
                corner.texcoord = first_texcoord + corner.position;
        }
    }
}

PolygonMesh parse_ply(const MeshBytes& mesh, LeftOut& left_out, const LoadBudget& budget) {
    const std::string_view bytes = as_text(mesh.name, mesh.bytes);
    const Header header = parsed_header(mesh.name, bytes, left_out);
    Values values(mesh.name, bytes, header, budget);
    for (const std::string_view wanted : {"vertex", "face"})
        if (std::ranges::count(header.elements, wanted, &Element::name) != 1)
            values.fail("expected one element \"" + std::string(wanted) + "\" in the header");
    PolygonMesh out;
    std::uint32_t first_texcoord = PolygonMesh::kNone;
    for (const Element& e : header.elements) {
        if (e.name == "vertex") {
            const auto before = static_cast<std::uint32_t>(out.texcoords.size());
            read_vertices(values, e, mesh.colors, out, left_out);
            if (out.texcoords.size() > before) first_texcoord = before;
        } else if (e.name == "face") {
            read_faces(values, e, mesh.colors, out, left_out);
        } else if (!e.properties.empty()) {
            const auto what = [&] { return "element " + e.name; };
            for (std::uint64_t i = 0; i < e.count; ++i)
                for (const Property& p : e.properties) skip(values, p, what);
        }
    }
    budget.check();
    complete_corners(values, out, first_texcoord);
    return out;
}

bool begins_as_ply(std::string_view bytes) {
    return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

}  // namespace

const MeshFormat kPly{.name = "ply",
                      .kind = "a PLY mesh",
                      .parse = parse_ply,
                      .begins = begins_as_ply,
                      .other_attributes = true};

}  // namespace nicol::geometry
