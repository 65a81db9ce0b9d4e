// SPDX-License-Identifier: MIT
// Fuzzer of the sensors in JSON files and in PNG files of mosaics.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

#include "memory_file.hpp"
#include "sensor/sensor_file.hpp"

namespace {

/// A file in memory with a path, for a reader that takes only a path. One object serves all inputs.
class MemoryFile {
public:
    MemoryFile()
        : file_(memfd_create("input", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(file_)) {}
    ~MemoryFile() { ::close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::filesystem::path& hold(std::string_view bytes) {
        if (::ftruncate(file_, 0) != 0 ||
            ::pwrite(file_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
            std::abort();
        return path_;
    }

private:
    int file_;
    std::filesystem::path path_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static MemoryFile memory;
    const std::filesystem::path file = memory.hold(nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const std::string text = nicol::sensor_json(nicol::read_sensor(file, {}));
        if (nicol::sensor_json(nicol::parse_sensor(file, text, {})) != text) std::abort();
    });
    return 0;
}
