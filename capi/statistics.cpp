// SPDX-License-Identifier: MIT
// Statistics of renders.
#include "handles.hpp"
#include "initialiser.hpp"

using namespace nicol;
using namespace nicol::capi;

nicol_result nicol_framebuffer_get_statistics(nicol_framebuffer framebuffer, nicol_statistics* statistics) {
    return guarded([&] {
        const nicol_framebuffer_impl& self = resolve(framebuffer);
        const Access access(self);
        const Statistics& s = self.content->statistics();
        nicol_statistics out = NICOL_STATISTICS_INIT;
        out.order = static_cast<uint32_t>(s.order);
        out.vertices = s.vertices;
        out.triangles = s.triangles;
        out.project_ms = s.project_ms;
        out.bake_ms = s.bake_ms;
        out.relight_ms = s.relight_ms;
        out.shade_ms = s.shade_ms;
        out.draw_ms = s.draw_ms;
        out.observe_ms = s.observe_ms;
        out.bake_trace_ms = s.bake_trace_ms;
        out.bake_rays = s.bake_rays;
        out.vertices_skipped = s.vertices_skipped;
        out.vertices_unoccluded = s.vertices_unoccluded;
        out.vertices_unphysical = s.vertices_unphysical;
        out.light_columns_skipped = s.light_columns_skipped;
        out.response_rows_skipped = s.response_rows_skipped;
        out.channels_shared = s.channels_shared;
        out.response_bytes = s.response_bytes;
        out.visibility_bytes = s.visibility_bytes;
        out.transfer_bytes = s.transfer_bytes;
        out.buffer_bytes = s.buffer_bytes;
        out.texture_bytes = s.texture_bytes;
        out.camera_rays = s.camera_rays;
        out.shadow_rays = s.shadow_rays;
        out.trace_ms = s.trace_ms;
        out.compute = s.compute ? 1 : 0;
        out.order_low = static_cast<uint32_t>(s.order_low);
        out.predicted_error = s.predicted_error;
        out.lights_projected = s.lights_projected;
        out.materials_projected = s.materials_projected;
        out.vertices_traced = s.vertices_traced;
        out.matrices_baked = s.matrices_baked;
        out.vertices_relit = s.vertices_relit;
        out.vertices_shaded = s.vertices_shaded;
        out.pixels_shaded = s.pixels_shaded;
        out.vertices_added = s.vertices_added;
        out.local_lights = s.local_lights;
        out.lights_split = s.lights_split;
        out.light_rays = s.light_rays;
        out.light_ms = s.light_ms;
        out.smooth_rays = s.smooth_rays;
        out.vertices_pending = s.vertices_pending;
        out.bounce_ms = s.bounce_ms;
        out.bounce_links = s.bounce_links;
        out.bounce_rounds = s.bounce_rounds;
        out.bounced_light = s.bounced_light;
        out.bounced_left = s.bounced_left;
        out.bake_rays_skipped = s.bake_rays_skipped;
        out.vertices_unbaked = s.vertices_unbaked;
        out.given_up = static_cast<uint32_t>(s.given_up);
        out.pixel_samples = static_cast<uint32_t>(s.pixel_samples);
        out.light_samples = static_cast<uint32_t>(s.light_samples);
        out.bsdf_samples = static_cast<uint32_t>(s.bsdf_samples);
        out.order_tolerance = s.order_tolerance;
        out.light_rays_skipped = s.light_rays_skipped;
        write_struct(statistics, out, "statistics");
    });
}

NICOL_INITIALISER(nicol_statistics, NICOL_STATISTICS_INIT)
