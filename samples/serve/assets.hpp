// SPDX-License-Identifier: MIT
// The files of the page, embedded when the program is built.
#pragma once

#include <span>
#include <string_view>

struct Asset {
    std::string_view path;  ///< of the URL: "/page.js"; "/" is the page itself
    std::string_view type;
    std::string_view content;
};

std::span<const Asset> assets();
