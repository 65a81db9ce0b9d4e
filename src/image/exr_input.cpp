// SPDX-License-Identifier: MIT
#include "image/exr_input.hpp"

#include <ImfHeader.h>
#include <ImfIO.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <istream>
#include <new>
#include <stdexcept>
#include <string_view>

#include "error.hpp"
#include "files/file_error.hpp"
#include "image/exr_structure.hpp"

namespace nicol {
namespace {

/// Input stream of OpenEXR.
class InputStream : public Imf::IStream {
public:
    InputStream(std::istream& in, const char* name) : IStream(name), in_(in) {}

    bool read(char* bytes, int count) override {
        in_.read(bytes, count);
        if (!in_) throw std::runtime_error("early end of file");
        return true;
    }
    std::uint64_t tellg() override { return static_cast<std::uint64_t>(in_.tellg()); }
    void seekg(std::uint64_t position) override { in_.seekg(static_cast<std::streamoff>(position)); }
    void clear() override { in_.clear(); }

private:
    std::istream& in_;
};

}  // namespace

void read_exr_input(const std::filesystem::path& file, const LoadBudget& budget,
                    const std::function<void(Imf::MultiPartInputFile& input)>& read) {
    const auto found = budget.files().find(file);
    const auto in = budget.files().open(file);
    if (!found || !in)
        throw Error(ErrorCode::file_not_found, file.string() + ": cannot be opened for reading");
    if (found->bytes == 0) invalid_file(file, "is empty");
    try {
        check_exr_structure(file, *in, found->bytes, budget);
        in->clear();
        in->seekg(0);
        InputStream stream(*in, file.c_str());
        // No OpenEXR threads (0), because OpenEXR's thread pool exists once per process and belongs to the
        // host.
        Imf::MultiPartInputFile input(stream, 0);
        read(input);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        // OpenEXR reports a lack of memory only in this text.
        if (std::string_view(e.what()).find("Failed to allocate memory") != std::string_view::npos)
            throw std::bad_alloc();
        invalid_file(file, std::string("is damaged or truncated (") + e.what() + ")");
    }
}

void read_exr_rows(Imf::InputPart& part, const LoadBudget& budget) {
    const Imath::Box2i window = part.header().dataWindow();
    // Chunks that two blocks of rows share stay in the reader's memory.
    constexpr int rows = 64;
    for (int y = window.min.y; y <= window.max.y; y += rows) {
        budget.check();
        part.readPixels(y, std::min(y + rows - 1, window.max.y));
    }
}

void require_finite_pixel(const std::filesystem::path& file, const std::string& channel, std::size_t pixel,
                          int width, float value) {
    if (std::isfinite(value)) return;
    const auto columns = static_cast<std::size_t>(width);
    invalid_file(file, "channel " + channel + ", pixel (" + std::to_string(pixel % columns) + ", " +
                           std::to_string(pixel / columns) + ") is " +
                           (std::isnan(value) ? "not a number" : "infinite") + "; all values must be finite");
}

}  // namespace nicol
