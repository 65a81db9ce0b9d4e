// SPDX-License-Identifier: MIT
// Render options by what an image is for.
#include "boundary.hpp"
#include "initialiser.hpp"

using namespace nicol::capi;

nicol_result nicol_render_options_set_quality(nicol_render_options* options, nicol_quality quality) {
    return guarded([&] {
        nicol_render_options out =
            read_struct(options, nicol_render_options NICOL_RENDER_OPTIONS_INIT, "options");
        const nicol_render_options realtime = NICOL_RENDER_OPTIONS_INIT;
        out.tolerance = realtime.tolerance;
        out.pixel_samples = realtime.pixel_samples;
        out.bake_directions = realtime.bake_directions;
        out.refine_tolerance = realtime.refine_tolerance;
        out.light_samples = realtime.light_samples;
        out.bsdf_samples = realtime.bsdf_samples;
        switch (quality) {
            case NICOL_QUALITY_REALTIME:
                break;
            case NICOL_QUALITY_PREVIEW:
                out.pixel_samples = 8;
                break;
            case NICOL_QUALITY_FINAL:
                out.tolerance = 0.01;
                out.pixel_samples = 64;
                out.refine_tolerance = 0.01;
                break;
            default:
                nicol::refuse("quality is " + std::to_string(quality) +
                              "; it must be NICOL_QUALITY_REALTIME, _PREVIEW or _FINAL");
        }
        write_struct(options, out, "options");
    });
}

NICOL_INITIALISER(nicol_render_options, NICOL_RENDER_OPTIONS_INIT)
