// SPDX-License-Identifier: MIT
// nicol-bench: what Nicol takes, as ratios within one run.
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "harmonics.hpp"
#include "nicol.h"

namespace {

constexpr const char* usage =
    "usage: nicol-bench harmonics [--seconds S] [--csv FILE] [--json FILE]\n"
    "  harmonics   transforms, rotation and projection of polarized spherical harmonics\n"
    "  --seconds   of measurement for each line of the table, default 1\n"
    "  --csv, --json   write the table there as well\n";

struct Options {
    double seconds = 1;
    std::string csv;
    std::string json;
};

bool parse(int count, char** arguments, Options& options) {
    for (int i = 2; i < count; ++i) {
        if (i + 1 >= count) return false;
        const std::string name = arguments[i];
        const std::string value = arguments[++i];
        if (name == "--seconds") {
            char* end = nullptr;
            options.seconds = std::strtod(value.c_str(), &end);
            if (*end != '\0' || !(options.seconds > 0 && options.seconds <= 3600)) return false;
        } else if (name == "--csv") {
            options.csv = value;
        } else if (name == "--json") {
            options.json = value;
        } else {
            return false;
        }
    }
    return true;
}

template <class Write>
bool write_file(const std::string& path, Write write) {
    if (path.empty()) return true;
    std::ofstream out(path);
    write(out);
    out.close();
    if (out) return true;
    std::cerr << "nicol-bench: " << path << " cannot be written\n";
    return false;
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    if (count < 2 || std::strcmp(arguments[1], "harmonics") != 0 || !parse(count, arguments, options)) {
        std::cerr << usage;
        return 2;
    }
    try {
        const Report report = bench_harmonics(options.seconds);
        report.print(std::cout);
        const bool written = write_file(options.csv, [&](std::ostream& out) { report.write_csv(out); }) &&
                             write_file(options.json, [&](std::ostream& out) { report.write_json(out); });
        return written ? 0 : 2;
    } catch (const std::exception& error) {
        std::cerr << "nicol-bench: " << error.what() << '\n';
        return 2;
    }
}
