// SPDX-License-Identifier: MIT
#include "import/other_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "files/suffix.hpp"

namespace nicol::scene {
namespace {

using namespace std::string_view_literals;

struct Beginning {
    std::string_view bytes;
    const char* kind;
};
constexpr std::array kBeginnings{
    Beginning{"\x89PNG"sv, "a PNG image"},
    Beginning{"\xff\xd8\xff"sv, "a JPEG image"},
    Beginning{"\x76\x2f\x31\x01"sv, "an OpenEXR image"},
    Beginning{"#?RADIANCE"sv, "a Radiance HDR image"},
    Beginning{"#?RGBE"sv, "a Radiance HDR image"},
    Beginning{"II*\0"sv, "a TIFF image"},
    Beginning{"MM\0*"sv, "a TIFF image"},
    Beginning{"ply\n"sv, "a PLY mesh"},
    Beginning{"ply\r"sv, "a PLY mesh"},
    Beginning{"solid "sv, "an STL mesh"},
    Beginning{"\x1c\x04"sv, "a Mitsuba mesh"},
    Beginning{"tensor_file"sv, "a measured material"},
    Beginning{"\x93NUMPY"sv, "a NumPy array"},
    Beginning{"BLENDER"sv, "a Blender file"},
    Beginning{"Kaydara FBX"sv, "an FBX file"},
    Beginning{"PXR-USDC"sv, "a USD file"},
    Beginning{"#usda"sv, "a USD file"},
    Beginning{"PK\3\4"sv, "an archive"},
    Beginning{"%PDF"sv, "a PDF"},
    Beginning{"\x1f\x8b"sv, "a compressed file"},
    Beginning{"\x28\xb5\x2f\xfd"sv, "a compressed file"},
    Beginning{"version https://git-lfs"sv, "a pointer of Git LFS (`git lfs pull` fetches the file)"},
    Beginning{"glTF"sv, "a binary glTF file, whose name must end in .glb"}};

// Beginnings of texts in lower case, after blanks and # comments.
constexpr std::array kTexts{Beginning{"{"sv, "a JSON file (the name of a glTF file must end in .gltf)"},
                            Beginning{"<!doctype html"sv, "a web page"}, Beginning{"<html"sv, "a web page"},
                            Beginning{"off\n"sv, "an OFF mesh"}, Beginning{"off\r"sv, "an OFF mesh"}};

// Statements that can come first in an OBJ file. Blanks follow the keyword.
constexpr std::array kObjKeywords{"v"sv, "vt"sv, "vn"sv, "f"sv, "g"sv, "o"sv, "s"sv, "mtllib"sv, "usemtl"sv};

struct Suffix {
    std::string_view text;
    const char* kind;
};
constexpr std::array kSuffixes{Suffix{".obj", "an OBJ mesh"},   Suffix{".stl", "an STL mesh"},
                               Suffix{".ply", "a PLY mesh"},    Suffix{".off", "an OFF mesh"},
                               Suffix{".pbrt", "a pbrt scene"}, Suffix{".serialized", "a Mitsuba mesh"}};

/// Returns the text behind a byte order mark, blanks, and lines that begin with #.
std::string_view first_statement(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        if (!text.starts_with('#')) return text;
        text.remove_prefix(std::min(text.find('\n'), text.size()));
    }
}

const char* kind_of_text(std::string_view statement) {
    const std::string lower = lower_case(std::string(statement.substr(0, 16)));
    for (const Beginning& beginning : kTexts)
        if (lower.starts_with(beginning.bytes)) return beginning.kind;
    const std::size_t blank = statement.find_first_of(" \t");
    const std::string_view keyword = statement.substr(0, blank);
    const bool is_obj = blank != std::string_view::npos && std::ranges::count(kObjKeywords, keyword) > 0;
    return is_obj ? "an OBJ mesh" : nullptr;
}

}  // namespace

std::string kind_of_other_file(const std::filesystem::path& file, const FileSource& files) {
    const auto in = files.open(file);
    if (!in) return {};
    // Exporters write some lines of comments first.
    std::array<char, 4096> first{};
    in->read(first.data(), first.size());
    const std::string_view bytes(first.data(), static_cast<std::size_t>(in->gcount()));
    if (bytes.empty()) return "an empty file";
    const std::string suffix = suffix_of(file);
    const bool is_gltf_name = suffix == ".gltf" || suffix == ".glb";
    const std::string_view statement = first_statement(bytes);
    if (is_gltf_name && (bytes.starts_with("glTF") || statement.starts_with('{'))) return {};
    for (const Beginning& beginning : kBeginnings)
        if (bytes.starts_with(beginning.bytes)) return beginning.kind;
    if (const char* const kind = kind_of_text(statement)) return kind;
    if (is_gltf_name && statement.starts_with('<'))
        return "an XML file (the name of a Mitsuba scene ends in .xml)";
    for (const Suffix& known : kSuffixes)
        if (suffix == known.text) return known.kind;
    return {};
}

}  // namespace nicol::scene
