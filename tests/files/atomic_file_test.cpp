// SPDX-License-Identifier: MIT
#include "files/atomic_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <functional>
#include <string>
#include <thread>

#include "error.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
namespace fs = std::filesystem;

namespace {

void put(AtomicFile& file, std::string_view text) {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), file.handle()));
}

/// Writes a file and then its beginning again, as formats with a table in front do.
void write(const fs::path& target, std::string_view text = "new content") {
    AtomicFile file(target);
    put(file, std::string(text.size(), '-'));
    std::rewind(file.handle());
    put(file, text);
    file.commit();
}

mode_t mode_of(const fs::path& file) {
    struct stat status {};
    REQUIRE(::stat(file.c_str(), &status) == 0);
    return status.st_mode & 07777;
}

/// Returns the exit status of a child that runs `body`, or 128 plus the signal that ended it.
int in_child(const std::function<void()>& body) {
    const pid_t child = ::fork();
    if (child == 0) {
        body();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("an output goes to the file that its name leads to") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    folder.write("old", "old content");
    struct Case {
        const char* name;
        std::function<void()> make;
        const char* file;  // file that holds the content afterwards
    };
    const std::array cases{
        Case{"a new file", [] {}, "plain"},
        Case{"a link", [&] { fs::create_symlink(folder / "old", folder / "link"); }, "old"},
        Case{"a relative link", [&] { fs::create_symlink("../old", folder / "sub/link"); }, "old"},
        Case{"a link to a link",
             [&] {
                 fs::create_symlink("second", folder / "first");
                 fs::create_symlink("sub/third", folder / "second");
                 fs::create_symlink("../old", folder / "sub/third");
             },
             "old"},
        Case{"a link to nothing yet", [&] { fs::create_symlink("sub/new", folder / "dangling"); }, "sub/new"},
        Case{"a folder that is a link",
             [&] { fs::create_directory_symlink(folder / "sub", folder / "elsewhere"); }, "sub/inside"}};
    const std::array names{"plain", "link", "sub/link", "first", "dangling", "elsewhere/inside"};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        CAPTURE(std::string(cases[i].name));
        cases[i].make();
        const fs::path name = folder / names[i];
        const bool link = fs::is_symlink(name);
        write(name, cases[i].name);
        CHECK(fs::is_symlink(name) == link);
        CHECK_FALSE(fs::is_symlink(folder / cases[i].file));
        CHECK(file_bytes(folder / cases[i].file) == cases[i].name);
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
        CHECK(entry.path().extension() != ".tmp");
}

TEST_CASE("links in a circle and folders are errors, and stay") {
    const TemporaryFolder folder;
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    fs::create_directory(folder / "sub");
    fs::create_symlink("sub", folder / "to_sub");
    for (const char* name : {"a", "sub", "to_sub", "missing/file", "sub/"}) {
        CAPTURE(std::string(name));
        try {
            write(folder / name);
            FAIL("was written");
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::write_failed);
            CHECK(std::string(error.what()).find((folder / name).string() + ": ") == 0);
        }
    }
    CHECK(folder.names() == std::set<std::string>{"a", "b", "sub", "to_sub"});
}

TEST_CASE("a file keeps its mode, and a new one has that of the process") {
    const TemporaryFolder folder;
    for (const mode_t mode : {0600, 0640, 0755}) {
        const fs::path file = folder.write("old", "old content");
        REQUIRE(::chmod(file.c_str(), mode) == 0);
        write(file);
        CHECK(mode_of(file) == mode);
        CHECK(file_bytes(file) == "new content");
    }
    const mode_t mask = ::umask(027);
    write(folder / "new");
    ::umask(mask);
    CHECK(mode_of(folder / "new") == 0640);
}

TEST_CASE("devices and pipes are written to, and stay what they are") {
    const TemporaryFolder folder;
    SUBCASE("a pipe with a name") {
        const fs::path pipe = folder / "pipe";
        REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
        fs::create_symlink("pipe", folder / "link");
        std::string read;
        // The content exceeds the capacity of a pipe.
        const std::string content(300'000, 'x');
        std::thread reader([&] { read = file_bytes(pipe); });
        write(folder / "link", content);
        reader.join();
        CHECK(read == content);
        CHECK(fs::is_fifo(pipe));
    }
    SUBCASE("a device") {
        fs::create_symlink("/dev/null", folder / "null");
        write(folder / "null");
        CHECK(fs::is_symlink(folder / "null"));
        CHECK(fs::is_character_file("/dev/null"));
        fs::create_symlink("/dev/full", folder / "full");
        CHECK_THROWS_WITH_AS(write(folder / "full"), doctest::Contains("No space"), Error);
        CHECK(fs::is_character_file("/dev/full"));
    }
    SUBCASE("an open file, after what it holds") {
        const fs::path file = folder.write("open", "before ");
        const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
        REQUIRE(descriptor >= 0);
        const std::string number = std::to_string(descriptor);
        for (const std::string& name : {"/proc/self/fd/" + number, "/dev/fd/" + number,
                                        "/proc/" + std::to_string(::getpid()) + "/fd/" + number}) {
            fs::remove(folder / "link");
            fs::create_symlink(name, folder / "link");
            write(folder / "link", "and ");
        }
        ::close(descriptor);
        CHECK(file_bytes(file) == "before and and and ");
    }
    SUBCASE("a pipe that nobody reads is an error, not the process's end") {
        std::array<int, 2> ends{};
        REQUIRE(::pipe(ends.data()) == 0);
        ::close(ends[0]);
        CHECK_THROWS_WITH_AS(write("/proc/self/fd/" + std::to_string(ends[1])), doctest::Contains("pipe"),
                             Error);
        ::close(ends[1]);
    }
}

TEST_CASE("a writer that is killed or gives up leaves nothing behind") {
    const TemporaryFolder folder;
    folder.write("old", "old content");
    SUBCASE("killed") {
        CHECK(in_child([&] {
                  AtomicFile file(folder / "old");
                  put(file, "half");
                  std::fflush(file.handle());
                  ::kill(::getpid(), SIGKILL);
              }) == 128 + SIGKILL);
    }
    SUBCASE("gives up") {
        AtomicFile file(folder / "old");
        put(file, "half");
    }
    CHECK(folder.names() == std::set<std::string>{"old"});
    CHECK(file_bytes(folder / "old") == "old content");
}

TEST_CASE("a file beyond the process's limit is an error, and signals are as before") {
    const TemporaryFolder folder;
    CHECK(in_child([&] {
              const rlimit limit{.rlim_cur = 4096, .rlim_max = 4096};
              ::setrlimit(RLIMIT_FSIZE, &limit);
              // A signal that the program itself blocks stays pending.
              sigset_t held;
              sigemptyset(&held);
              sigaddset(&held, SIGPIPE);
              pthread_sigmask(SIG_BLOCK, &held, nullptr);
              ::raise(SIGPIPE);
              try {
                  write(folder / "large", std::string(100'000, 'x'));
                  ::_exit(1);
              } catch (const Error& error) {
                  if (error.code() != ErrorCode::write_failed) ::_exit(2);
              }
              sigset_t mask, pending;
              pthread_sigmask(SIG_BLOCK, nullptr, &mask);
              sigpending(&pending);
              if (sigismember(&mask, SIGXFSZ) != 0 || sigismember(&mask, SIGPIPE) == 0) ::_exit(3);
              if (sigismember(&pending, SIGXFSZ) != 0 || sigismember(&pending, SIGPIPE) == 0) ::_exit(4);
          }) == 0);
    CHECK(folder.names().empty());
}
