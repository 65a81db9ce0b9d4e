// SPDX-License-Identifier: MIT
#include "files/atomic_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <ctime>
#include <initializer_list>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "error.hpp"

namespace nicol {
namespace {

namespace fs = std::filesystem;

bool is_number(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns the process whose open file `path` is, in a folder such as /proc/1234/fd; 0 if `path` is no open
/// file.
long process_of(const fs::path& path) {
    std::error_code error;
    const fs::path folder = fs::canonical(path.parent_path(), error);
    if (error || folder.filename() != "fd" || !is_number(path.filename().string())) return 0;
    fs::path process = folder.parent_path();
    // A thread shares the open files of its process.
    if (process.parent_path().filename() == "task") process = process.parent_path().parent_path();
    const std::string name = process.filename().string();
    if (process.parent_path() != "/proc" || !is_number(name)) return 0;
    long number = 0;
    std::from_chars(name.data(), name.data() + name.size(), number);
    return number;
}

}  // namespace

OutputPlace output_place(const fs::path& target) {
    constexpr int most_links = 40;  // the limit of Linux
    if (!target.has_filename()) cannot_write(target, EISDIR);
    OutputPlace place{.file = target};
    std::error_code error;
    for (int links = 0;; ++links) {
        if (links == most_links) cannot_write(target, ELOOP);
        const fs::path beside = place.file.has_parent_path() ? place.file.parent_path() : fs::path(".");
        if (const long process = process_of(beside / place.file.filename()); process != 0) {
            place.stream = true;
            const std::string number = place.file.filename().string();
            if (process == ::getpid())
                std::from_chars(number.data(), number.data() + number.size(), place.descriptor);
            return place;
        }
        if (!fs::is_symlink(fs::symlink_status(place.file, error))) break;
        const fs::path next = fs::read_symlink(place.file, error);
        if (error) cannot_write(target, error.value());
        place.file = next.is_absolute() ? next : beside / next;
    }
    const fs::file_status status = fs::status(place.file, error);
    if (fs::is_directory(status)) cannot_write(target, EISDIR);
    place.stream = fs::exists(status) && !fs::is_regular_file(status);
    return place;
}

void cannot_write(const fs::path& target, int error) {
    const std::string reason = error != 0 ? std::generic_category().message(error) : "the disk may be full";
    throw Error(ErrorCode::write_failed, target.string() + ": cannot be written (" + reason +
                                             "); the folder must exist, be writable and have space");
}

HeldSignals::HeldSignals() noexcept {
    sigset_t pending;
    sigemptyset(&added_);
    sigpending(&pending);
    for (const int number : {SIGXFSZ, SIGPIPE})
        if (sigismember(&pending, number) == 0) sigaddset(&added_, number);
    pthread_sigmask(SIG_BLOCK, &added_, &mask_);
}

HeldSignals::~HeldSignals() {
    // A signal that a write has sent would arrive as soon as the mask is restored, so it is consumed first.
    const timespec at_once{};
    while (sigtimedwait(&added_, nullptr, &at_once) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
}

namespace {

// Mode of a new file, before the process's mask applies.
constexpr mode_t kMode = 0666;
// Number of names that are tried if names are taken.
constexpr int kNameAttempts = 16;

/// Returns the file's path below /proc, through which a nameless file gets a name.
std::string name_of(std::FILE* file) {
    return "/proc/self/fd/" + std::to_string(::fileno(file));
}

/// Returns whether an error means that the folder's file system or the kernel does not support nameless
/// files.
bool lacks_nameless(int error) {
    return error == EOPNOTSUPP || error == EISDIR || error == EINVAL || error == ENOENT;
}

}  // namespace

AtomicFile::AtomicFile(fs::path target) : target_(std::move(target)), place_(output_place(target_)) {
    int descriptor = -1;
    if (place_.stream) {
        descriptor = ::memfd_create("nicol output", MFD_CLOEXEC);
        if (descriptor < 0) fail(errno);
    } else {
        const fs::path folder = place_.file.has_parent_path() ? place_.file.parent_path() : fs::path(".");
        descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
        if (descriptor < 0 && !lacks_nameless(errno)) fail(errno);
        // Without /proc the file could not be given a name.
        if (descriptor >= 0 && ::access("/proc/self/fd", X_OK) != 0) {
            ::close(descriptor);
            descriptor = -1;
        }
    }
    if (descriptor < 0) {
        open_beside();
        return;
    }
    file_ = ::fdopen(descriptor, "w+b");
    if (file_ == nullptr) {
        ::close(descriptor);
        fail(ENOMEM);
    }
}

AtomicFile::~AtomicFile() {
    if (file_ != nullptr) static_cast<void>(std::fclose(file_));
    if (!temporary_.empty()) {
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }
}

fs::path AtomicFile::new_name() const {
    std::random_device random;
    fs::path name = place_.file;
    name += std::to_string(random()).insert(0, 1, '.').append(".tmp");
    return name;
}

void AtomicFile::open_beside() {
    for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
        temporary_ = new_name();
        // Exclusive creation never follows a link and never overwrites another file.
        file_ = std::fopen(temporary_.c_str(), "w+bxe");
        if (file_ != nullptr) return;
        const int error = std::exchange(errno, 0);
        if (error != EEXIST) {
            temporary_.clear();
            fail(error);
        }
    }
    temporary_.clear();
    fail(EEXIST);
}

fs::file_time_type AtomicFile::time() const {
    std::error_code error;
    const auto found = fs::last_write_time(name_of(file_), error);
    if (error) fail(error.value());
    return found;
}

void AtomicFile::sync() noexcept {
    if (std::fflush(file_) == 0) static_cast<void>(::fsync(::fileno(file_)));
}

void AtomicFile::keep_mode() const {
    struct stat before {};
    if (::stat(place_.file.c_str(), &before) != 0) return;
    const int descriptor = ::fileno(file_);
    struct stat now {};
    // Only a privileged process can give files away. Changing the owner may clear bits of the mode.
    if (::fstat(descriptor, &now) == 0 && (now.st_uid != before.st_uid || now.st_gid != before.st_gid) &&
        ::fchown(descriptor, before.st_uid, before.st_gid) != 0)
        errno = 0;
    if (::fchmod(descriptor, before.st_mode & 07777) != 0) fail(errno);
}

void AtomicFile::copy_to_stream() const {
    // A duplicate of an open file of this process keeps the file's position and append mode.
    const int to = place_.descriptor >= 0 ? ::dup(place_.descriptor)
                                          : ::open(place_.file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (to < 0) fail(errno);
    const int from = ::fileno(file_);
    int error = ::lseek(from, 0, SEEK_SET) < 0 ? errno : 0;
    char block[1 << 14];
    ssize_t count = 0;
    while (error == 0 && (count = ::read(from, block, sizeof block)) != 0) {
        if (count < 0) error = errno;
        for (ssize_t done = 0; error == 0 && done < count;) {
            const ssize_t written = ::write(to, block + done, static_cast<std::size_t>(count - done));
            if (written >= 0)
                done += written;
            else if (errno != EINTR)
                error = errno;
        }
    }
    if (::close(to) != 0 && error == 0) error = errno;
    if (error != 0) fail(error);
}

void AtomicFile::close() {
    // Some file systems report a full disk only when the file is closed.
    if (std::fclose(std::exchange(file_, nullptr)) != 0) fail(errno);
}

void AtomicFile::commit() {
    errno = 0;
    if (std::fflush(file_) != 0 || std::ferror(file_) != 0) fail(errno);
    if (place_.stream) {
        copy_to_stream();
        return close();
    }
    keep_mode();
    if (temporary_.empty()) {
        const std::string nameless = name_of(file_);
        const auto link = [&](const fs::path& name) {
            return ::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
        };
        // Copying the name may fail for lack of memory, so it comes before a file exists that must be
        // removed.
        if (fs::path name = place_.file; link(name)) {
            temporary_ = std::move(name);  // removed if closing fails
            close();
            temporary_.clear();
            return;
        }
        // A link cannot replace a file, so the new file first gets a temporary name and is then renamed to
        // the target.
        for (int attempt = 0; temporary_.empty(); ++attempt) {
            if (errno != EEXIST || attempt == kNameAttempts) fail(errno);
            if (fs::path name = new_name(); link(name)) temporary_ = std::move(name);
        }
    }
    close();
    std::error_code error;
    fs::rename(temporary_, place_.file, error);
    if (error) fail(error.value());
    temporary_.clear();
}

}  // namespace nicol
