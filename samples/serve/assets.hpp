// SPDX-License-Identifier: MIT
// The files of the page, embedded at build time.
#pragma once

#include <span>
#include <string_view>

struct Asset {
    std::string_view path;  ///< path of the URL, such as "/page.js"; "/" is the page
    std::string_view type;
    std::string_view content;
};

std::span<const Asset> assets();
