// SPDX-License-Identifier: MIT
// Whether a picture can be light at all (Eq. 70).
#include <algorithm>
#include <cmath>

#include "light/environment_checks.hpp"

namespace nicol {
namespace {

class PhysicalCheck {
public:
    PhysicalCheck(StokesImage& image, const std::string& name, ErrorCode code)
        : image_(image), name_(name), code_(code) {}

    void run() const {
        if (image_.width < 2 || image_.height < 2)
            throw Error(code_, name_ + ": " + std::to_string(image_.width) + " x " +
                                   std::to_string(image_.height) +
                                   " pixels; an environment needs at least 2 x 2");
        const std::size_t plane = image_.data.size() / static_cast<std::size_t>(image_.channels);
        for (std::size_t first = 0; first < image_.data.size(); first += plane) check_plane(first, plane);
    }

private:
    void check_plane(std::size_t first, std::size_t plane) const {
        float* data = image_.data.data();
        float largest = 0;
        for (std::size_t i = first; i < first + plane; i += 4) {
            for (std::size_t p = 0; p < 4; ++p)
                if (!std::isfinite(data[i + p])) refuse(i, "is not finite");
            largest = std::max(largest, data[i]);
        }
        for (std::size_t i = first; i < first + plane; i += 4) {
            const double polarized = std::hypot(data[i + 1], data[i + 2], data[i + 3]);
            if (data[i] < 0) {
                // Colours outside the gamut of the file's primaries and lossy compression leave such values.
                if (polarized > 0 || data[i] < -0.1 * largest)
                    refuse(i, "has s0 < 0; radiance cannot be negative");
                data[i] = 0;
            }
            if (polarized > 1.01 * data[i] + 1e-3 * largest)
                refuse(i, "is polarized more than fully: sqrt(s1^2 + s2^2 + s3^2) exceeds s0");
        }
    }

    [[noreturn]] void refuse(std::size_t element, const std::string& what) const {
        const std::size_t pixel = element / 4;
        const auto width = static_cast<std::size_t>(image_.width);
        const auto height = static_cast<std::size_t>(image_.height);
        throw Error(code_, name_ + ": channel " + std::to_string(pixel / (width * height)) + ", pixel (" +
                               std::to_string(pixel % width) + ", " + std::to_string(pixel / width % height) +
                               ") " + what);
    }

    StokesImage& image_;
    const std::string& name_;
    ErrorCode code_;
};

}  // namespace

void check_physical(StokesImage& image, const std::string& name, ErrorCode code) {
    PhysicalCheck(image, name, code).run();
}

}  // namespace nicol
