// SPDX-License-Identifier: MIT
#include "import/gltf_document.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>  // for tinygltf, which leaves it out of what writes files
#include <limits>
#include <new>
#include <string_view>

#include "files/file_error.hpp"
#include "files/json.hpp"
#include "files/read_bytes.hpp"
#include "import/gltf_json.hpp"
#include "import/xml_file.hpp"
#include "shortest_text.hpp"

// The code of tinygltf, which is a header. It is compiled here because a shared library of it would open
// images. tinygltf calls its values nlohmann::json, which cannot be destroyed where memory is short.
namespace nicol::scene::tiny_json {
using json = Json;
}
#define TINYGLTF_NO_INCLUDE_JSON
#define nlohmann nicol::scene::tiny_json
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
#undef TINYGLTF_IMPLEMENTATION
#undef nlohmann
#undef TINYGLTF_NO_INCLUDE_JSON

namespace nicol::scene {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied from memory as they are");

// Those that are read, and those that only concern what a notice says is not followed.
constexpr std::array<std::string_view, 17> kExtensions = {"KHR_mesh_quantization",
                                                          "KHR_materials_ior",
                                                          "KHR_materials_emissive_strength",
                                                          "KHR_materials_transmission",
                                                          "KHR_materials_volume",
                                                          "KHR_materials_specular",
                                                          "KHR_materials_clearcoat",
                                                          "KHR_materials_iridescence",
                                                          "KHR_materials_sheen",
                                                          "KHR_texture_transform",
                                                          "KHR_lights_punctual",
                                                          "EXT_mesh_gpu_instancing",
                                                          "KHR_texture_basisu",
                                                          "KHR_materials_anisotropy",
                                                          "KHR_materials_variants",
                                                          "KHR_materials_unlit",
                                                          "KHR_materials_pbrSpecularGlossiness"};

/// Errors of tinygltf about members that glTF does not require: the matrices of a skin, and the target node
/// of an animation's channel. A channel without a node has no effect.
constexpr std::array<std::string_view, 2> kOptional = {
    "'inverseBindMatrices' property is missing in Skin.\n",
    "'node' property is missing.\n`node` field is missing in animation.channels.target\n"};

constexpr int kMostLevels = 128;

/// The parser calls itself for each level of arrays and objects.
bool too_deep(std::string_view json) {
    int levels = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_string) {
            if (c == '\\') ++i;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            if (++levels > kMostLevels) return true;
        } else if (c == '}' || c == ']') {
            --levels;
        }
    }
    return false;
}

/// The JSON of a file; the chunks of a binary one lie within it, which tinygltf does not check.
std::string_view json_of(const std::filesystem::path& file, std::string_view bytes) {
    if (!bytes.starts_with("glTF")) return bytes;
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, sizeof(value));
        return std::uint64_t{value};
    };
    constexpr std::uint64_t kHeader = 12, kChunkHeader = 8;
    if (bytes.size() < kHeader + kChunkHeader) invalid_file(file, "ends within the header of a GLB file");
    const std::uint64_t length = number(8);
    if (length > bytes.size())
        invalid_file(file, "is " + std::to_string(bytes.size()) + " bytes long, and " +
                               std::to_string(length) + " as its header says");
    for (std::uint64_t at = kHeader; at < length;) {
        if (length - at < kChunkHeader || number(at) > length - at - kChunkHeader)
            invalid_file(file, "the chunk at byte " + std::to_string(at) + " ends beyond the file");
        at += kChunkHeader + number(at);
    }
    return bytes.substr(kHeader + kChunkHeader, number(kHeader));
}

/// Reads the files that buffers name, for tinygltf, which asks for them in order.
struct Buffers {
    const std::filesystem::path& scene;
    const LoadBudget& budget;
    std::vector<FileRecord>& files;
    std::vector<std::uint64_t> lengths;
    std::size_t next = 0;

    std::string read(const std::string& uri) {
        const std::filesystem::path file = gltf_file(scene, uri, "a buffer");
        if (!budget.files().find(file))
            throw Error(ErrorCode::file_not_found,
                        scene.string() + ": the buffer " + in_quotes(uri) + ": no such file");
        budget.take_file(file);
        std::string bytes = read_bytes(file, budget);
        if (std::ranges::find(files, file, &FileRecord::path) == files.end())
            files.push_back(record_of(file, bytes));
        // A file may be longer, which tinygltf refuses.
        if (next < lengths.size() && lengths[next] < bytes.size()) bytes.resize(lengths[next]);
        ++next;
        return bytes;
    }
};

tinygltf::FsCallbacks callbacks_to(Buffers& buffers) {
    tinygltf::FsCallbacks callbacks{};
    callbacks.FileExists = [](const std::string&, void*) { return true; };  // read() says it better
    callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name,
                                 void* user) {
        const std::string bytes = static_cast<Buffers*>(user)->read(name);
        out->assign(bytes.begin(), bytes.end());
        return true;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                  void*) { return false; };
    // Newer versions of TinyGLTF take all callbacks or none. The size is asked for to limit it, which read()
    // does.
    [](auto& all) {
        if constexpr (requires { all.GetFileSizeInBytes; })
            all.GetFileSizeInBytes = [](std::size_t* bytes, std::string*, const std::string&, void*) {
                *bytes = 0;
                return true;
            };
    }(callbacks);
    callbacks.user_data = &buffers;
    return callbacks;
}

/// On one line, of bounded length.
std::string shortened(std::string text) {
    constexpr std::size_t most = 300;
    while (text.ends_with('\n')) text.pop_back();
    if (text.size() > most) text = text.substr(0, most) + "...";
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return text.empty() ? "cannot be read" : text;
}

void check_extensions(const tinygltf::Model& model, const std::filesystem::path& file) {
    for (const std::string& name : model.extensionsRequired)
        if (std::ranges::find(kExtensions, name) == kExtensions.end())
            unsupported_file(file, "extensionsRequired: " + in_quotes(name) + " is not supported");
}

tinygltf::Model parsed(const std::string& bytes, Buffers& buffers) {
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(callbacks_to(buffers));
    // Keeps the bytes of images in data URIs, as they are.
    parser.SetImageLoader(
        [](tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
           int size, void*) {
            if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
            return true;
        },
        nullptr);
    tinygltf::Model model;
    std::string error, warning;
    const auto size = static_cast<unsigned int>(bytes.size());
    try {
        const bool complete =
            bytes.starts_with("glTF")
                ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                              reinterpret_cast<const unsigned char*>(bytes.data()), size)
                : parser.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
        for (const std::string_view missing : kOptional)
            for (std::size_t at = 0; (at = error.find(missing)) != std::string::npos;)
                error.erase(at, missing.size());
        if (complete && error.empty()) return model;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        error = e.what();
    }
    // tinygltf keeps the text alone of an exception.
    if (error == std::bad_alloc().what()) throw std::bad_alloc();
    // A file of such an extension may have nothing where glTF itself wants something.
    check_extensions(model, buffers.scene);
    invalid_file(buffers.scene, shortened(error));
}

}  // namespace

std::filesystem::path gltf_file(const std::filesystem::path& scene, const std::string& uri,
                                const std::string& what) {
    const std::filesystem::path name = uri;
    const bool is_below =
        !name.is_absolute() && std::ranges::find(name, std::filesystem::path("..")) == name.end();
    if (!is_below || uri.find("://") != std::string::npos || uri.starts_with("data:"))
        unsupported_file(scene, what + "'s uri is " + in_quotes(uri) +
                                    "; expected a relative one, of a file in the folder of the scene or "
                                    "below, or data:...;base64,...");
    return scene.parent_path() / name;
}

GltfDocument::GltfDocument(const std::filesystem::path& file, const LoadBudget& budget) : path_(file) {
    budget.take_file(file);
    const std::string bytes = read_bytes(file, budget);
    files_.push_back(record_of(file, bytes));
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
        unsupported_file(file, "a glTF file of 4 GiB or more; keep its buffers in files of their own");
    const std::string_view json = json_of(file, bytes);
    if (too_deep(json))
        unsupported_file(file,
                         "arrays and objects more than " + std::to_string(kMostLevels) + " levels deep");
    const JsonRoom room(json);
    Buffers buffers{file, budget, files_, {}};
    {
        const Json members = gltf_members(json, budget);
        check_gltf_members(members, file);
        buffers.lengths = lengths_of_buffers(members);
    }
    budget.check();
    model_ = parsed(bytes, buffers);
    budget.check();
    for (const tinygltf::Buffer& buffer : model_.buffers) buffer_bytes_ += buffer.data.size();
    if (!model_.asset.version.starts_with("2."))
        fail("asset", "version is " + in_quotes(model_.asset.version) + "; expected 2.0",
             ErrorCode::unsupported);
    check_extensions(model_, file);
}

void GltfDocument::fail(const std::string& where, const std::string& what, ErrorCode code) const {
    throw Error(code, path_.string() + ": " + where + ": " + what);
}

double GltfDocument::in_range(double value, double least, double most, const std::string& where,
                              const char* name) const {
    if (!(value >= least && value <= most))
        fail(where, std::string(name) + " is " + std::to_string(value) + "; expected " +
                        shortest_text(least) + " to " + shortest_text(most));
    return value;
}

}  // namespace nicol::scene
