// SPDX-License-Identifier: MIT
// Description of the service at /openapi.json.
#pragma once

#include <string>

#include "options.hpp"

/// Returns OpenAPI 3.1 as JSON, with the limits of these options.
std::string openapi(const Options& options);
