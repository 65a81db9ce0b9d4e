// SPDX-License-Identifier: MIT
#include "image/exr_input.hpp"

#include <ImfHeader.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>
#include <new>
#include <string_view>

#include "error.hpp"
#include "files/file_error.hpp"
#include "image/exr_structure.hpp"

namespace nicol {

void read_exr_input(const std::filesystem::path& file, const LoadBudget& budget,
                    const std::function<void(Imf::MultiPartInputFile& input)>& read) {
    std::error_code error;
    const std::uintmax_t size =
        std::filesystem::is_directory(file, error) ? 0 : std::filesystem::file_size(file, error);
    if (error || size == 0 || !std::ifstream(file)) {
        if (!error && std::filesystem::is_regular_file(file, error) && size == 0)
            invalid_file(file, "is empty");
        throw Error(ErrorCode::file_not_found, file.string() + ": cannot be opened for reading" +
                                                   (error ? " (" + error.message() + ")" : ""));
    }
    try {
        check_exr_structure(file, size, budget);
        // No OpenEXR threads (0), because OpenEXR's thread pool exists once per process and belongs to the
        // host.
        Imf::MultiPartInputFile input(file.c_str(), 0);
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
