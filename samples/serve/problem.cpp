// SPDX-License-Identifier: MIT
#include "problem.hpp"

#include "json.hpp"

const char* status_title(int status) {
    switch (status) {
        case 400:
            return "Bad Request";
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 408:
            return "Request Timeout";
        case 413:
            return "Content Too Large";
        case 415:
            return "Unsupported Media Type";
        case 416:
            return "Range Not Satisfiable";
        case 417:
            return "Expectation Failed";
        case 421:
            return "Misdirected Request";
        case 429:
            return "Too Many Requests";
        case 431:
            return "Request Header Fields Too Large";
        case 501:
            return "Not Implemented";
        case 503:
            return "Service Unavailable";
        case 504:
            return "Gateway Timeout";
        default:
            return "Internal Server Error";
    }
}

std::string problem_json(const Problem& problem) {
    std::string text = "{\"type\":\"about:blank\",\"title\":" + json_string(status_title(problem.status)) +
                       ",\"status\":" + std::to_string(problem.status) +
                       ",\"detail\":" + json_string(problem.detail);
    if (!problem.parameter.empty()) text += ",\"parameter\":" + json_string(problem.parameter);
    if (!problem.range.empty()) text += ",\"range\":" + json_string(problem.range);
    return text + "}\n";
}
