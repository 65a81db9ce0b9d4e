// SPDX-License-Identifier: MIT
// Fuzzer of the sensors in JSON files and in PNG files of mosaics.
#include <cstdlib>

#include "memory_file.hpp"
#include "sensor/sensor_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static nicol::fuzz::MemoryFile memory;
    const std::filesystem::path file = memory.hold(nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const std::string text = nicol::sensor_json(nicol::read_sensor(file, {}));
        if (nicol::sensor_json(nicol::parse_sensor(file, text, {})) != text) std::abort();
    });
    return 0;
}
