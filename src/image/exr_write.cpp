// SPDX-License-Identifier: MIT
// Writing of Stokes images to OpenEXR files.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "error.hpp"
#include "files/atomic_file.hpp"
#include "image/exr_layout.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

/// Output stream of OpenEXR. OpenEXR writes its line table from a destructor that swallows exceptions, so a
/// failure is not only thrown but also stays recorded in the FILE, where AtomicFile::commit() finds it.
class FileStream : public Imf::OStream {
public:
    FileStream(std::FILE* file, const char* name) : OStream(name), file_(file) {}
    void write(const char* bytes, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (std::fwrite(bytes, 1, size, file_) != size) fail("write error");
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(ftello(file_)); }
    void seekp(std::uint64_t position) override {
        if (fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) fail("seek error");
    }
    [[nodiscard]] bool failed() const { return failed_; }

private:
    [[noreturn]] void fail(const char* what) {
        failed_ = true;
        throw std::runtime_error(what);
    }

    std::FILE* file_;
    bool failed_ = false;
};

/// Returns a mutable pointer, because OpenEXR's frame buffers also serve for reading.
template <class Number>
char* writable(const Number* values) {
    return reinterpret_cast<char*>(const_cast<Number*>(values));
}

/// Returns the part after "S<p>." of each channel's name.
std::vector<std::string> exr_colours(const StokesImage& image) {
    std::vector<std::string> colours;
    for (const double nm : image.wavelengths) colours.push_back(exr_wavelength(nm));
    if (!colours.empty()) return colours;
    if (image.channels == 1) return {"Y"};
    if (image.channels == 3) return {"R", "G", "B"};
    for (int c = 0; c < image.channels; ++c) colours.push_back(std::to_string(c));
    return colours;
}

void insert_aovs(const Aovs& aovs, const std::vector<std::string>& colours, Imf::Header& header,
                 Imf::FrameBuffer& buffer) {
    // Inserts every `components`-th number of a plane, from index `first` on.
    const auto insert = [&]<class Number>(const std::string& name, const std::vector<Number>& plane,
                                          std::size_t first, std::size_t components) {
        if (plane.empty()) return;
        constexpr Imf::PixelType type = std::is_same_v<Number, float> ? Imf::FLOAT : Imf::UINT;
        header.channels().insert(name, Imf::Channel(type));
        const std::size_t pixel_bytes = components * sizeof(Number);
        buffer.insert(name, Imf::Slice(type, writable(plane.data() + first), pixel_bytes,
                                       static_cast<std::size_t>(aovs.width) * pixel_bytes));
    };
    insert("Z", aovs.depth, 0, 1);
    insert("id", aovs.instances, 0, 1);
    insert("A", aovs.alpha, 0, 1);
    static constexpr std::array axes{"X", "Y", "Z"};
    for (std::size_t i = 0; i < 3; ++i) {
        insert(std::string("N.") + axes[i], aovs.normals, i, 3);
        insert(std::string("P.") + axes[i], aovs.positions, i, 3);
    }
    const std::size_t floats = aovs.variance.size() / colours.size();
    for (std::size_t c = 0; c < colours.size(); ++c)
        for (std::size_t p = 0; p < 4; ++p)
            insert("variance." + exr_channel(p, colours[c]), aovs.variance, c * floats + p, 4);
}

}  // namespace

void write_exr(const std::filesystem::path& path, const StokesImage& image, const ExrOptions& options) {
    AtomicFile file(path);
    encode_exr(file.handle(), path.string(), image, options);
    file.commit();
}

void encode_exr(std::FILE* file, const std::string& name, const StokesImage& image,
                const ExrOptions& options) {
    image.check("write_exr: image");
    if (image.channels > kMaxFileChannels)
        throw Error(ErrorCode::invalid_argument, "write_exr: image has " + std::to_string(image.channels) +
                                                     " channels; it may have at most " +
                                                     std::to_string(kMaxFileChannels));
    if (std::ranges::adjacent_find(image.wavelengths, std::greater_equal()) != image.wavelengths.end())
        throw Error(ErrorCode::invalid_argument,
                    "write_exr: each wavelength must be larger than the one before");
    if ((options.components & ~kStokesAll) != 0)
        throw Error(ErrorCode::invalid_argument, "write_exr: components has bits beyond s0..s3 (0b1111)");

    if (options.aovs != nullptr) {
        options.aovs->check("write_exr: aovs");
        if (!options.aovs->fit(image.width, image.height, image.channels))
            throw Error(ErrorCode::invalid_argument,
                        "write_exr: aovs must have the image's width, height and channels");
    }

    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.insert("software", Imf::StringAttribute("Nicol " NICOL_VERSION_STRING));
    if (!options.frame.empty()) header.insert("stokesFrame", Imf::StringAttribute(options.frame));
    if (!options.comment.empty()) Imf::addComments(header, options.comment);

    if (!image.wavelengths.empty()) {
        header.insert("spectralLayoutVersion", Imf::StringAttribute("1.0"));
        header.insert("emissiveUnits", Imf::StringAttribute("W.m^-2.sr^-1"));
        header.insert("polarisationHandedness", Imf::StringAttribute("right"));
    }

    constexpr std::size_t pixel_bytes = 4 * sizeof(float);
    const std::size_t row_bytes = static_cast<std::size_t>(image.width) * pixel_bytes;
    const std::size_t plane_floats =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    Imf::FrameBuffer buffer;
    const auto insert = [&](const std::string& name, int channel, std::size_t component) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        const float* base = image.data.data() + static_cast<std::size_t>(channel) * plane_floats + component;
        buffer.insert(name, Imf::Slice(Imf::FLOAT, writable(base), pixel_bytes, row_bytes));
    };
    const std::vector<std::string> colours = exr_colours(image);
    const bool preview = image.wavelengths.empty() && (image.channels == 1 || image.channels == 3);
    for (int c = 0; c < image.channels; ++c) {
        const std::string& colour = colours[static_cast<std::size_t>(c)];
        if (preview) insert(colour, c, 0);
        for (std::size_t p = 0; p < 4; ++p)
            if ((options.components >> p & 1u) != 0 || (p == 0 && !preview))
                insert(exr_channel(p, colour), c, p);
    }

    if (options.aovs != nullptr) insert_aovs(*options.aovs, colours, header, buffer);

    FileStream stream(file, name.c_str());
    try {
        // No OpenEXR threads (0), because OpenEXR's thread pool exists once per process and belongs to the
        // host.
        Imf::OutputFile output(stream, header, 0);
        output.setFrameBuffer(buffer);
        // OpenEXR leaves out rows without an error if zlib lacks memory, so each block of zlib is checked for
        // output.
        constexpr int block = 16;
        for (int row = 0; row < image.height; row += block) {
            const std::uint64_t before = stream.tellp();
            output.writePixels(std::min(block, image.height - row));
            if (stream.tellp() == before) throw std::bad_alloc();
        }
    } catch (const std::exception& e) {
        // OpenEXR reports a lack of memory as "output failed".
        if (!stream.failed()) throw std::bad_alloc();
        throw Error(ErrorCode::write_failed, name + ": cannot be written (" + e.what() +
                                                 "); the disk may be full or the folder not writable");
    }
}

}  // namespace nicol
