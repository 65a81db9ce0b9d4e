// SPDX-License-Identifier: MIT
// Helpers for tests of jobs.
#pragma once

#include <atomic>

#include "capi/capi.hpp"
#include "capi/gate.hpp"

namespace capi_test {

// Returns options that make every render trace again.
inline nicol_render_options traced() {
    nicol_render_options options = plain_options();
    options.method = NICOL_METHOD_REFERENCE;
    options.samples = 2;
    options.disabled_optimisations = NICOL_OPTIMISATION_UNCHANGED;
    return options;
}

inline nicol_render_options gated(Gate& gate, nicol_method method = NICOL_METHOD_REFERENCE) {
    nicol_render_options options = traced();
    options.method = method;
    options.progress = Gate::callback;
    options.progress_user = &gate;
    return options;
}

inline nicol_job submit(const Stage& stage, const nicol_render_options& options = traced()) {
    return make(nicol_render_async, stage.scene, &stage.camera, &options, stage.framebuffer);
}

inline nicol_job_status poll(nicol_job job) {
    nicol_job_status status = NICOL_JOB_STATUS_INIT;
    OK(nicol_job_poll(job, &status));
    return status;
}

/// Adds an instance whose material sets `released` when it is destroyed.
inline void add_watched(const Stage& stage, std::atomic<bool>& released) {
    nicol_callback_material parameters = grey_function();
    parameters.user = &released;
    parameters.release = [](void* user) {
        auto& done = *static_cast<std::atomic<bool>*>(user);
        done = true;
        done.notify_all();
    };
    add(stage.scene, stage.mesh, Owned(make(nicol_material_create_callback, stage.context, &parameters)));
}

}  // namespace capi_test
