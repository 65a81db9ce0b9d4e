// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;

// Returns the text of a time in seconds: "8 s", "1:05".
std::string text_of(double seconds) {
    const auto whole = static_cast<long>(std::min(std::ceil(seconds), 359999.0));
    if (whole < 60) return std::to_string(whole) + " s";
    const std::string rest = std::to_string(whole % 60);
    return std::to_string(whole / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1), start_(Clock::now()) {}

ProgressBar::~ProgressBar() {
    clear();
}

std::int32_t ProgressBar::update(void* user, const char* verb, double fraction) {
    auto& bar = *static_cast<ProgressBar*>(user);
    if (!bar.terminal_) return 1;
    const Clock::time_point now = Clock::now();
    const double part = std::clamp(fraction, 0.0, 1.0);
    if (bar.verb_ != verb || part < bar.verb_from_) {
        bar.verb_ = verb;
        bar.verb_start_ = now;
        bar.verb_from_ = part;
    }
    if (now - bar.start_ < std::chrono::seconds(1)) return 1;
    constexpr int width = 40;
    const auto full = static_cast<std::size_t>(part * width);
    const std::string line = std::string(full, '#') + std::string(width - full, '.');
    std::fprintf(stderr, "\r\033[K[%s] %3.0f %% %s", line.c_str(), part * 100, verb);
    // A smaller part says little about the rest.
    constexpr double enough = 0.05;
    const double done = part - bar.verb_from_;
    const double seconds = std::chrono::duration<double>(now - bar.verb_start_).count();
    if (done > enough) std::fprintf(stderr, ", %s left", text_of(seconds * (1 - part) / done).c_str());
    std::fflush(stderr);
    bar.shown_ = true;
    return 1;
}

void ProgressBar::clear() {
    if (shown_) std::fputs("\r\033[K", stderr);
    shown_ = false;
}
