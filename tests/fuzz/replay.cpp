// SPDX-License-Identifier: MIT
// A main program that runs a fuzzer's inputs from files and folders, for any compiler.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

void run(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    // The buffer is exactly as long as the file, so that a sanitizer detects reads beyond it.
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    std::cout << file.string() << std::endl;  // the last printed file is the failing one
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** arguments) {
    for (const std::filesystem::path given : std::vector<std::string>(arguments + 1, arguments + count)) {
        if (!std::filesystem::is_directory(given)) {
            run(given);
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(given)) run(entry.path());
    }
}
