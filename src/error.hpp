// SPDX-License-Identifier: MIT
// What went wrong: a code for programs, a message for people.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace nicol {

/// The values are those of nicol_result in the C ABI and never change their meaning.
enum class ErrorCode : std::int32_t {
    invalid_argument = 1,  ///< a value, size or pointer outside its documented range
    invalid_handle = 2,    ///< a handle of the wrong kind, released, or of another context
    out_of_memory = 3,
    file_not_found = 4,  ///< cannot be opened for reading
    invalid_file = 5,    ///< opened, but its content is truncated, malformed or out of range
    write_failed = 6,    ///< an output could not be written
    unsupported = 7,     ///< well-formed, but not something this build can do
    no_backend = 8,      ///< no OpenGL context could be made
    cancelled = 9,       ///< a callback asked to stop
    opengl = 10,         ///< the driver failed after the context was made
    internal = 11,       ///< a defect in Nicol
    not_current = 12,    ///< the host's OpenGL context is not current on the calling thread
    timeout = 13,        ///< the time given for waiting is over
    busy = 14,           ///< too much waits already
};

/// Thrown by the C++ API. The message names the file, line, field or argument and says what would be right.
class Error : public std::runtime_error {
public:
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

}  // namespace nicol
