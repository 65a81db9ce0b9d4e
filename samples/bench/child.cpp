// SPDX-License-Identifier: MIT
#include "child.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

namespace {

// "ok" and the numbers, or "no" and the message.
std::string answer(const std::function<std::vector<double>()>& measure) {
    try {
        std::string text = "ok";
        for (const double value : measure()) text += ' ' + std::to_string(value);
        return text;
    } catch (const std::exception& error) {
        return std::string("no") + error.what();
    }
}

std::string read_all(int file) {
    std::string text;
    char block[4096];
    for (ssize_t got = 0; (got = ::read(file, block, sizeof block)) > 0;)
        text.append(block, static_cast<std::size_t>(got));
    return text;
}

void write_all(int file, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t wrote = ::write(file, text.data() + done, text.size() - done);
        if (wrote <= 0) return;
        done += static_cast<std::size_t>(wrote);
    }
}

}  // namespace

std::vector<double> in_child(const std::function<std::vector<double>()>& measure) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot start a process");
    if (child == 0) {
        write_all(ends[1], answer(measure));
        ::_exit(0);
    }
    ::close(ends[1]);
    const std::string text = read_all(ends[0]);
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    if (text.size() < 2 || text.substr(0, 2) != "ok")
        throw std::runtime_error(text.size() < 2 ? "a measuring process died" : text.substr(2));
    std::vector<double> numbers;
    const char* at = text.c_str() + 2;
    while (*at == ' ') {
        char* end = nullptr;
        numbers.push_back(std::strtod(at, &end));
        at = end;
    }
    return numbers;
}
