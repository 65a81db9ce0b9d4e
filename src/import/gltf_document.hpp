// SPDX-License-Identifier: MIT
// A glTF file with its buffers in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "error.hpp"
#include "files/file_record.hpp"
#include "files/load_budget.hpp"

// tinygltf opens no files and decodes no images here.
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace nicol::scene {

/// Returns the file that a relative uri names, in the folder of the scene's file or below. Throws
/// Error(unsupported) that names `what`, the user of the uri, for any other uri.
[[nodiscard]] std::filesystem::path gltf_file(const std::filesystem::path& scene, const std::string& uri,
                                              const std::string& what);

/// Well-formed glTF 2 file that requires only extensions that Nicol has. Indices, counts and offsets are not
/// checked and may be out of range.
class GltfDocument {
public:
    /// Takes the sizes of the file and its buffers off the budget. Throws as read_gltf_scene does.
    GltfDocument(const std::filesystem::path& file, const LoadBudget& budget);

    [[nodiscard]] const tinygltf::Model& model() const { return model_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const std::vector<FileRecord>& files() const { return files_; }
    /// Returns the size of all buffers together.
    [[nodiscard]] std::uint64_t buffer_bytes() const { return buffer_bytes_; }

    /// Throws an error "file: where: what". where: an element, such as "meshes[2].primitives[0]".
    [[noreturn]] void fail(const std::string& where, const std::string& what,
                           ErrorCode code = ErrorCode::invalid_file) const;

    /// Returns `value`. Throws what fail() throws unless it lies in least to most. name: its name in the
    /// file.
    [[nodiscard]] double in_range(double value, double least, double most, const std::string& where,
                                  const char* name) const;

    /// Returns an element of one of the model's lists to which the element `where` refers. name: name of the
    /// list in the file. Throws what fail() throws if the index is out of range.
    template <class Element>
    [[nodiscard]] const Element& at(const std::vector<Element>& list, const char* name, int index,
                                    const std::string& where) const {
        if (index < 0 || static_cast<std::size_t>(index) >= list.size())
            fail(where, "refers to " + std::string(name) + "[" + std::to_string(index) + "]; the file has " +
                            std::to_string(list.size()));
        return list[static_cast<std::size_t>(index)];
    }

private:
    std::filesystem::path path_;
    std::vector<FileRecord> files_;
    tinygltf::Model model_;
    std::uint64_t buffer_bytes_ = 0;
};

}  // namespace nicol::scene
