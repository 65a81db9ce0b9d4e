// SPDX-License-Identifier: MIT
#include "inspect/file_options.hpp"

#include "arguments.hpp"
#include "error.hpp"
#include "files/npy.hpp"
#include "files/zip.hpp"
#include "light/cube_cross.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

// Light and materials share the suffix .npz. The shape of the coefficients distinguishes them.
FileKind kind_of_archive(const path& file) {
    for (const ZipEntry& entry : read_zip_directory(file)) {
        if (entry.name != "coeff.npy") continue;
        ZipStream stream(file, entry);
        const NpyHeader header = read_npy_header(stream, file.string() + ": member coeff.npy");
        return header.shape.size() >= 4 ? FileKind::material_psh : FileKind::light_psh;
    }
    throw Error(ErrorCode::unsupported,
                file.string() + ": has no member coeff.npy; neither light (SHVec) nor a material (SHMat)");
}

}  // namespace

void require_no_image_options(const FileOptions& options, const std::string& output) {
    if (options.width != 0) refuse("width and height are those of an image to write, not of " + output);
    if (options.edge != 0) refuse("edge is that of a cube map to write, not of " + output);
    if (options.physical) refuse("NICOL_FILE_PHYSICAL is for images to write, not for " + output);
}

FileKind identify(const path& file) {
    std::error_code error;
    const bool there = std::filesystem::exists(file, error);
    if (cube_cross_stem(file) ||
        (!there && !file.empty() && std::filesystem::exists(cube_cross_file(file, 0), error)))
        return FileKind::light_cross;
    if (!there) throw Error(ErrorCode::file_not_found, file.string() + ": does not exist");
    if (!std::filesystem::is_regular_file(file, error))
        throw Error(ErrorCode::unsupported, file.string() + ": is not a file");
    const path suffix = file.extension();
    if (suffix == ".exr") return FileKind::light_image;
    if (suffix == ".npz") return kind_of_archive(file);
    if (suffix == ".pbsdf") return FileKind::material_measured;
    if (suffix == ".response") return FileKind::material_table;
    throw Error(ErrorCode::unsupported,
                file.string() +
                    ": the suffix must be .exr or .npz for light, .npz, .pbsdf or .response "
                    "for materials");
}

}  // namespace nicol
