// SPDX-License-Identifier: MIT
// Errors of nicol.h with their code, from which the status of an answer follows.
#pragma once

#include <nicol.h>

#include "common/handles.hpp"

struct RenderError : Failure {
    explicit RenderError(nicol_result result) : Failure(nicol_last_error()), code(result) {}
    nicol_result code;
};

/// Throws RenderError unless the call succeeded.
inline void must(nicol_result result) {
    if (result != NICOL_OK) throw RenderError(result);
}
