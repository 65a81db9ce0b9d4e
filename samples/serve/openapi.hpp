// SPDX-License-Identifier: MIT
// The description of the service at /openapi.json.
#pragma once

#include <string>

#include "options.hpp"

/// OpenAPI 3.1 as JSON, with the limits that hold here.
std::string openapi(const Options& options);
