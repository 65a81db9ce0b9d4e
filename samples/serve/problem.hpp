// SPDX-License-Identifier: MIT
// Error answers: problem details as JSON (RFC 9457).
#pragma once

#include <stdexcept>
#include <string>

struct Problem {
    int status = 500;            ///< of HTTP
    std::string detail = {};     ///< one sentence for people
    std::string parameter = {};  ///< of the query, where one is at fault
    std::string range = {};      ///< what it may be
    int retry_after = 0;         ///< seconds; 0: no such header
};

/// Thrown while a request is checked.
struct Refusal : std::runtime_error {
    explicit Refusal(Problem what) : std::runtime_error(what.detail), problem(std::move(what)) {}
    Problem problem;
};

/// The standard's words for a status, "Not Found" for 404.
const char* status_title(int status);

/// A JSON object with type, title, status and detail, and parameter and range where there are any.
std::string problem_json(const Problem& problem);
