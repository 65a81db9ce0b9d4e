// SPDX-License-Identifier: MIT
// Helpers for tests of jobs.
#pragma once

#include <atomic>

#include "capi/capi.hpp"

namespace capi_test {

/// A progress callback that blocks its job until the gate is opened.
class Gate {
public:
    static std::int32_t callback(void* user, const char*, double) {
        auto& gate = *static_cast<Gate*>(user);
        gate.entered_ = true;
        gate.entered_.notify_all();
        gate.answer_.wait(closed);
        return gate.answer_;
    }
    void wait_until_entered() { entered_.wait(false); }
    void open(std::int32_t answer = 1) {
        answer_ = answer;
        answer_.notify_all();
    }

private:
    static constexpr std::int32_t closed = -1;
    std::atomic<bool> entered_ = false;
    std::atomic<std::int32_t> answer_ = closed;
};

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
