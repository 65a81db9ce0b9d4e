// SPDX-License-Identifier: MIT
#include "import/file_kind.hpp"

#include <algorithm>
#include <array>

#include "files/first_statement.hpp"
#include "files/suffix.hpp"
#include "geometry/mesh_format.hpp"

namespace nicol {
namespace {

using namespace std::string_view_literals;

// Kinds of files that are no meshes, which know their own beginnings.
struct Beginning {
    std::string_view bytes;
    std::string_view suffix;  // empty: not read
    std::string_view kind;    // empty: a scene
};
constexpr std::array kBeginnings{
    Beginning{"\x89PNG"sv, ".png", "a PNG image"},
    Beginning{"\xff\xd8\xff"sv, ".jpg", "a JPEG image"},
    Beginning{"\x76\x2f\x31\x01"sv, ".exr", "an OpenEXR image"},
    Beginning{"#?RADIANCE"sv, ".hdr", "a Radiance HDR image"},
    Beginning{"#?RGBE"sv, ".hdr", "a Radiance HDR image"},
    Beginning{"BM"sv, ".bmp", "a BMP image"},
    Beginning{"II*\0"sv, "", "a TIFF image"},
    Beginning{"MM\0*"sv, "", "a TIFF image"},
    Beginning{"tensor_file"sv, ".pbsdf", "a measured material"},
    Beginning{"\x93NUMPY"sv, "", "a NumPy array"},
    Beginning{"PK\3\4"sv, ".npz", "an archive"},
    Beginning{"BLENDER"sv, "", "a Blender file"},
    Beginning{"Kaydara FBX"sv, "", "an FBX file"},
    Beginning{"PXR-USDC"sv, "", "a USD file"},
    Beginning{"#usda"sv, "", "a USD file"},
    Beginning{"%PDF"sv, "", "a PDF"},
    Beginning{"\x1f\x8b"sv, "", "a compressed file"},
    Beginning{"\x28\xb5\x2f\xfd"sv, "", "a compressed file"},
    Beginning{"version https://git-lfs"sv, "", "a pointer of Git LFS (`git lfs pull` fetches the file)"},
    Beginning{"glTF"sv, ".glb", "a binary glTF file, whose name must end in .glb"}};

// Beginnings of first statements in lower case.
constexpr std::array kTexts{
    Beginning{"{"sv, ".gltf", "a JSON file (the name of a glTF file must end in .gltf)"},
    Beginning{"<!doctype html"sv, "", "a web page"}, Beginning{"<html"sv, "", "a web page"},
    Beginning{"<"sv, ".xml", ""}};

// Returns null for meshes and what is not known.
const Beginning* beginning_of(std::string_view bytes) {
    for (const Beginning& beginning : kBeginnings)
        if (bytes.starts_with(beginning.bytes)) return &beginning;
    const std::string text = lower_case(std::string(first_statement(bytes).substr(0, 16)));
    for (const Beginning& beginning : kTexts)
        if (text.starts_with(beginning.bytes)) return &beginning;
    return nullptr;
}

}  // namespace

std::string suffix_of_content(std::string_view bytes) {
    if (const Beginning* const known = beginning_of(bytes)) return std::string(known->suffix);
    if (const MeshFormat* const format = mesh_format_of_content(bytes))
        return "." + std::string(format->name);
    constexpr std::size_t looked_at = 256;
    const bool is_text =
        !bytes.empty() && bytes.substr(0, looked_at).find_first_of("\0\1\2\3\4"sv) == std::string_view::npos;
    return is_text ? ".obj" : "";
}

std::string scene::kind_of_other_file(const std::filesystem::path& file, const FileSource& files) {
    const auto in = files.open(file);
    if (!in) return {};
    // Exporters write some lines of comments first.
    std::array<char, 4096> first{};
    in->read(first.data(), first.size());
    const std::string_view bytes(first.data(), static_cast<std::size_t>(in->gcount()));
    if (bytes.empty()) return "an empty file";
    const std::string suffix = suffix_of(file);
    const bool is_gltf_name = suffix == ".gltf" || suffix == ".glb";
    const Beginning* const known = beginning_of(bytes);
    if (known != nullptr && known->kind.empty())
        return is_gltf_name ? "an XML file (the name of a Mitsuba scene ends in .xml)" : "";
    if (known != nullptr) {
        const bool is_gltf = known->suffix == ".gltf" || known->suffix == ".glb";
        return is_gltf && is_gltf_name ? "" : std::string(known->kind);
    }
    if (const MeshFormat* const format = mesh_format_of_content(bytes)) return std::string(format->kind);
    if (const MeshFormat* const format = mesh_format_of(file)) return std::string(format->kind);
    return suffix == ".pbrt" ? "a pbrt scene" : "";
}

}  // namespace nicol
