// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

ProgressBar::ProgressBar()
    : terminal_(isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar() {
    clear();
}

std::int32_t ProgressBar::update(void* user, const char* verb, double fraction) {
    auto& bar = *static_cast<ProgressBar*>(user);
    if (!bar.terminal_ || std::chrono::steady_clock::now() - bar.start_ < std::chrono::seconds(1)) return 1;
    constexpr int width = 40;
    const double part = std::clamp(fraction, 0.0, 1.0);
    const auto full = static_cast<std::size_t>(part * width);
    const std::string line = std::string(full, '#') + std::string(width - full, '.');
    std::fprintf(stderr, "\r\033[K[%s] %3.0f %% %s", line.c_str(), part * 100, verb);
    std::fflush(stderr);
    bar.shown_ = true;
    return 1;
}

void ProgressBar::clear() {
    if (shown_) std::fputs("\r\033[K", stderr);
    shown_ = false;
}
