// SPDX-License-Identifier: MIT
// The error that ends a program, and its message.
#pragma once

#include <stdexcept>
#include <string>

/// Error that ends the program with exit code 2; the message is one line.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Returns a message as one line for scripts, because paths and drivers' messages may contain line feeds.
inline std::string one_line(const char* message) {
    std::string line;
    for (const char* p = message; *p; ++p) {
        const char c = *p == '\n' ? ' ' : *p;
        if (c != ' ' || line.empty() || line.back() != ' ') line += c;
    }
    return line;
}
