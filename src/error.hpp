// SPDX-License-Identifier: MIT
// The exception of the C++ API: a code for programs and a message for people.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace nicol {

/// Error codes. Their values are those of nicol_result in the C ABI and never change their meaning.
enum class ErrorCode : std::int32_t {
    invalid_argument = 1,  ///< a value, size or pointer outside its documented range
    invalid_handle = 2,    ///< a handle of the wrong kind, released, or of another context
    out_of_memory = 3,
    file_not_found = 4,  ///< file that cannot be opened for reading
    invalid_file = 5,    ///< file that opens, but whose content is truncated, malformed or out of range
    write_failed = 6,    ///< output that could not be written
    unsupported = 7,     ///< well-formed request that this build cannot fulfil
    no_backend = 8,      ///< no OpenGL context could be created
    cancelled = 9,       ///< request of a callback to stop
    opengl = 10,         ///< failure of the driver after the context was created
    internal = 11,       ///< defect in Nicol
    not_current = 12,    ///< host's OpenGL context that is not current on the calling thread
    timeout = 13,        ///< end of the time limit of a wait
    busy = 14,           ///< too many requests are waiting already
};

/// Exception of the C++ API. Its message names the file, line, field or argument and says what would be
/// right.
class Error : public std::runtime_error {
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

}  // namespace nicol
