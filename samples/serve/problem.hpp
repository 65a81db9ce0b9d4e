// SPDX-License-Identifier: MIT
// Error answers: problem details as JSON (RFC 9457).
#pragma once

#include <stdexcept>
#include <string>

struct Problem {
    int status = 500;            ///< HTTP status
    std::string detail = {};     ///< one sentence for users
    std::string parameter = {};  ///< faulty parameter of the query, if any
    std::string range = {};      ///< valid values of the parameter
    int retry_after = 0;         ///< in seconds; 0: no such header
};

/// Exception that a request's check throws.
struct Refusal : std::runtime_error {
    explicit Refusal(Problem what) : std::runtime_error(what.detail), problem(std::move(what)) {}
    Problem problem;
};

/// Returns the standard reason phrase of a status, such as "Not Found" for 404.
const char* status_title(int status);

/// Returns a JSON object with type, title, status, detail, and, if set, parameter and range.
std::string problem_json(const Problem& problem);
