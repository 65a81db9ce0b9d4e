// SPDX-License-Identifier: MIT
#include "sandbox.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "common/failure.hpp"

namespace fs = std::filesystem;

namespace {

// Constants of newer kernels, because the kernel's header may be older than the kernel.
constexpr std::uint64_t kTruncate = 1u << 14u, kIoctl = 1u << 15u;
constexpr std::uint64_t kBindTcp = 1u << 0u, kConnectTcp = 1u << 1u;
struct RulesetAttributes {
    std::uint64_t files, network;
};

constexpr std::uint64_t kReadFile = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t kRead = kReadFile | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kWriteFile = LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;
constexpr std::uint64_t kWrite = kRead | kWriteFile | LANDLOCK_ACCESS_FS_MAKE_REG |
                                 LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                 LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REFER;
constexpr std::uint64_t kDevice = kRead | kWriteFile | kIoctl;
/// Rights of rules on files; folders may have all rights.
constexpr std::uint64_t kOfFiles = kReadFile | kWriteFile | kIoctl;

/// Paths that libraries and OpenGL's drivers read; missing ones are skipped.
constexpr std::array kSystem = {
    "/usr",          "/lib",         "/lib64",      "/opt",          "/etc/ld.so.cache", "/etc/glvnd",
    "/etc/egl",      "/etc/drirc",   "/etc/nvidia", "/sys",          "/proc/self",       "/proc/cpuinfo",
    "/proc/meminfo", "/proc/driver", "/proc/stat",  "/proc/devices", "/proc/modules"};
constexpr std::array kDevices = {"/dev/null", "/dev/zero", "/dev/urandom", "/dev/dri", "/dev/kfd"};

/// Returns the version of Landlock, 0 without Landlock.
int version() {
    const long found = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return found > 0 ? static_cast<int>(found) : 0;
}

/// Returns all rights that this version of Landlock can restrict.
RulesetAttributes all_rights() {
    const int known = version();
    const unsigned files = known >= 5 ? 16 : known >= 3 ? 15 : known >= 2 ? 14 : 13;
    return {.files = (std::uint64_t{1} << files) - 1, .network = known >= 4 ? kBindTcp | kConnectTcp : 0};
}

[[noreturn]] void fail(const std::string& what) {
    throw Failure(what + ": " + std::strerror(errno) + "; --no-sandbox goes without");
}

class Ruleset {
public:
    Ruleset() : rights_(all_rights()) {
        const std::size_t size = rights_.network != 0 ? sizeof rights_ : sizeof rights_.files;
        set_ = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &rights_, size, 0));
        if (set_ < 0) fail("the worker cannot be confined");
    }
    ~Ruleset() { ::close(set_); }
    Ruleset(const Ruleset&) = delete;
    Ruleset& operator=(const Ruleset&) = delete;

    /// Adds a rule. Does nothing if there is no such path.
    void allow(const std::string& path, std::uint64_t rights) {
        const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
        if (file < 0) return;
        struct stat kind {};
        const bool folder = ::fstat(file, &kind) == 0 && S_ISDIR(kind.st_mode);
        landlock_path_beneath_attr rule{};
        rule.allowed_access = rights & rights_.files & (folder ? ~std::uint64_t{0} : kOfFiles);
        rule.parent_fd = file;
        const bool added = ::syscall(SYS_landlock_add_rule, set_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
        ::close(file);
        if (!added) fail(path + ": the worker cannot be confined to it");
    }

    void enforce() {
        if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
            ::syscall(SYS_landlock_restrict_self, set_, 0) != 0)
            fail("the worker cannot be confined");
    }

private:
    RulesetAttributes rights_;
    int set_ = -1;
};

}  // namespace

bool can_confine() {
    return version() > 0;
}

void confine(const Options& options) {
    if (!can_confine()) return;
    Ruleset rules;
    rules.allow(options.scenes, kRead);
    for (const std::string& folder : options.readable) rules.allow(folder, kRead);
    for (const char* path : kSystem) rules.allow(path, kRead);
    for (const char* path : kDevices) rules.allow(path, kDevice);
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator("/dev", ignored))
        if (entry.path().filename().string().starts_with("nvidia")) rules.allow(entry.path(), kDevice);
    const char* const named = std::getenv("NICOL_CACHE");
    const std::string cache = !options.cache.empty() ? options.cache : named != nullptr ? named : "";
    if (!cache.empty()) {
        // The folder must exist before a rule can name it.
        fs::create_directories(cache, ignored);
        rules.allow(cache, kWrite);
        // OpenGL's drivers store compiled shaders in this folder, because they cannot write to others from
        // now on.
        setenv("XDG_CACHE_HOME", fs::absolute(cache, ignored).c_str(), 1);
    }
    rules.enforce();
}
