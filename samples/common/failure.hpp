// SPDX-License-Identifier: MIT
// What ends a program, and how it is told.
#pragma once

#include <stdexcept>
#include <string>

/// Ends the program with exit code 2; the message is one line.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Scripts count on one line; a path may hold a line feed, and a driver's message more.
inline std::string one_line(const char* message) {
    std::string line;
    for (const char* p = message; *p; ++p) {
        const char c = *p == '\n' ? ' ' : *p;
        if (c != ' ' || line.empty() || line.back() != ' ') line += c;
    }
    return line;
}
