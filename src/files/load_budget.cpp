// SPDX-License-Identifier: MIT
#include "files/load_budget.hpp"

#include <chrono>
#include <string>
#include <utility>

#include "files/file_error.hpp"
#include "progress.hpp"

namespace nicol {
namespace {

/// Adds `amount` to `used`. Throws Error(unsupported) if `used` would exceed `limit`.
void take(std::uint64_t& used, std::uint64_t amount, std::uint64_t limit, const std::filesystem::path& file,
          const char* what, const char* option) {
    if (amount > limit - used)
        unsupported_file(file, std::string("more than ") + std::to_string(limit) + ' ' + what +
                                   ", the limit that the option " + option + " sets");
    used += amount;
}

}  // namespace

struct LoadBudget::Account {
    struct Shapes {
        std::uint64_t vertices = 0;
        std::uint64_t triangles = 0;
    };

    explicit Account(LoadLimits given) : limits(std::move(given)) {}

    void take_bytes(std::uint64_t amount) {
        take(bytes, amount, limits.bytes, file,
             "bytes in all files of the load and what is decoded from them", "load_bytes_limit");
    }
    void take_shapes(Shapes& used, const std::filesystem::path& of, const Shapes& amount) const {
        take(used.vertices, amount.vertices, limits.vertices, of, "vertices, each instance counted",
             "vertex_limit");
        take(used.triangles, amount.triangles, limits.triangles, of, "triangles, each instance counted",
             "triangle_limit");
    }

    LoadLimits limits;
    Progress progress{limits.progress};
    Stopwatch time;
    std::filesystem::path file;  // last file that was taken
    std::uint64_t steps = 0;
    std::uint64_t bytes = 0;
    Shapes meshes;
    Shapes instances;
};

LoadBudget::LoadBudget(const LoadLimits& limits)
    : account_(std::make_shared<Account>(limits)), steps_(&account_->steps) {}

const FileSource& LoadBudget::files() const {
    return account_->limits.files ? *account_->limits.files : file_system();
}

void LoadBudget::take_file(const std::filesystem::path& file) const {
    account_->file = file;
    // A file that cannot be read is left to its reader to report.
    if (const auto found = files().find(file)) account_->take_bytes(found->bytes);
    check();
}

void LoadBudget::take_memory(std::uint64_t bytes) const {
    account_->take_bytes(bytes);
}

void LoadBudget::take_pixels(const std::filesystem::path& file, std::uint64_t pixels) const {
    account_->file = file;
    account_->take_bytes(16 * pixels);
    check();
}

void LoadBudget::take_mesh(const std::filesystem::path& file, std::uint64_t vertices,
                           std::uint64_t triangles) const {
    account_->take_shapes(account_->meshes, file, {vertices, triangles});
    check_time(file);
}

void LoadBudget::take_instance(const std::filesystem::path& file, std::uint64_t vertices,
                               std::uint64_t triangles) const {
    account_->take_shapes(account_->instances, file, {vertices, triangles});
    check_time(file);
}

void LoadBudget::check() const {
    account_->steps = 0;
    check_deadline();
    account_->progress.report("load", 0);
}

void LoadBudget::check_time(const std::filesystem::path& file) const {
    account_->file = file;
    check();
}

void LoadBudget::check_deadline() const {
    const double most = account_->limits.seconds;
    if (account_->time.milliseconds() > 1000 * most)
        unsupported_file(account_->file, "loading takes longer than " + std::to_string(most) +
                                             " seconds, the limit that the option load_seconds_limit sets");
}

}  // namespace nicol
