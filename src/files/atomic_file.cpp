// SPDX-License-Identifier: MIT
// Temporary file and rename.
#include "files/atomic_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "error.hpp"

namespace nicol {

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)) {
    if (!target_.has_filename()) fail(EISDIR);
    // Renaming would replace a device, a pipe or a folder by a file.
    std::error_code unknown;
    const std::filesystem::file_status status = std::filesystem::status(target_, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        throw Error(ErrorCode::write_failed, target_.string() + ": exists and is not a regular file");
    }
    std::random_device random;
    for (int attempt = 0; attempt < 16; ++attempt) {
        temporary_ = target_;
        temporary_ += std::to_string(random()).insert(0, 1, '.').append(".tmp");
        // Exclusive creation: never follow a link or overwrite another file.
        file_ = std::fopen(temporary_.c_str(), "wbx");
        if (file_ != nullptr) return;
        if (errno != EEXIST) fail(errno);
    }
    fail(EEXIST);
}

AtomicFile::~AtomicFile() {
    if (file_ != nullptr) static_cast<void>(std::fclose(file_));
    if (!temporary_.empty()) {
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
    }
}

std::filesystem::file_time_type AtomicFile::time() const {
    std::error_code error;
    const auto found = std::filesystem::last_write_time(temporary_, error);
    if (error) fail(error.value());
    return found;
}

void AtomicFile::sync() noexcept {
    if (std::fflush(file_) == 0) static_cast<void>(::fsync(::fileno(file_)));
}

void AtomicFile::commit() {
    errno = 0;
    const bool written = std::fflush(file_) == 0 && std::ferror(file_) == 0;
    const int write_error = errno;
    // Some file systems report a full disk only when the file is closed.
    const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
    if (!written) fail(write_error);
    if (!closed) fail(errno);
    std::error_code error;
    std::filesystem::rename(temporary_, target_, error);
    if (error) fail(error.value());
    temporary_.clear();
}

void AtomicFile::fail(int error) const {
    const std::string reason = error != 0 ? std::generic_category().message(error) : "the disk may be full";
    throw Error(ErrorCode::write_failed, target_.string() + ": cannot be written (" + reason +
                                             "); the folder must exist, be writable and have space");
}

}  // namespace nicol
