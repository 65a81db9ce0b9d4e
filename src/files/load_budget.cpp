// SPDX-License-Identifier: MIT
#include "files/load_budget.hpp"

#include "files/file_error.hpp"

namespace nicol {
namespace {

/// `amount` of at most `limit` beside what `used` says.
void take(std::uint64_t& used, std::uint64_t amount, std::uint64_t limit, const std::filesystem::path& file,
          const char* what, const char* option) {
    if (amount > limit - used)
        unsupported_file(file, std::string("more than ") + std::to_string(limit) + ' ' + what +
                                   ", the limit that the option " + option + " sets");
    used += amount;
}

}  // namespace

void LoadBudget::take_file(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    // A file that cannot be read is left to its reader to report.
    if (!error) take_bytes(file, size);
    check_time(file);
}

void LoadBudget::take_pixels(const std::filesystem::path& file, std::uint64_t pixels) {
    take_bytes(file, 16 * pixels);
    check_time(file);
}

void LoadBudget::take_bytes(const std::filesystem::path& file, std::uint64_t bytes) {
    take(bytes_, bytes, limits_.bytes, file, "bytes in all files and textures of the load",
         "load_bytes_limit");
}

void LoadBudget::take_instance(const std::filesystem::path& file, std::uint64_t vertices,
                               std::uint64_t triangles) {
    take(vertices_, vertices, limits_.vertices, file, "vertices, each instance counted", "vertex_limit");
    take(triangles_, triangles, limits_.triangles, file, "triangles, each instance counted",
         "triangle_limit");
    check_time(file);
}

void LoadBudget::check_time(const std::filesystem::path& file) const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (passed.count() > limits_.seconds)
        unsupported_file(file, "loading takes longer than " + std::to_string(limits_.seconds) +
                                   " seconds, the limit that the option load_seconds_limit sets");
}

}  // namespace nicol
