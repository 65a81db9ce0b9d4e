// SPDX-License-Identifier: MIT
// Surfaces at the samples of an image.
#include "render/renderer.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {

void Renderer::update_buffers(const RefinedSurfaces& surfaces, int channels) {
    uploading_.run(surfaces.version(), surfaces.material_version(), channels, [&] {
        context_->run([&] {
            buffers_.update(surfaces.geometry(), surfaces.version(), channels);
            alpha_masks_.update(surfaces.geometry(), surfaces.version(), surfaces.material_version(),
                                buffers_);
        });
    });
}

void Renderer::find_hits(const Projection& projection, const RenderOptions& options,
                         VisibilityBuffer::Kept kept, const ImageShape& image, Statistics& statistics) {
    const RefinedSurfaces& surfaces = pipeline_.surfaces();
    const Projection of_surfaces = in_axes(projection, surfaces.to_world());
    const HitRequest request{.surfaces = surfaces,
                             .projection = of_surfaces,
                             .width = image.width,
                             .height = image.height,
                             .offsets = sample_pattern(options.pixel_samples),
                             .kept = kept};
    // An image that is one of many of a picture covers a part of each pixel.
    const double images = 1 / (projection.sample_size * projection.sample_size);
    const bool traced = context_->info().software && kept == VisibilityBuffer::Kept::on_host &&
                        rays_cost_less(request, images);
    if (!traced) update_buffers(surfaces, image.channels);
    if ((options.disabled_optimisations & skip_unchanged) != 0) finding_.reset();
    // Materials with another alpha mask or other sides give the surfaces another version, and nothing else of
    // materials affects hits.
    finding_.run(surfaces.version(), of_surfaces.world_to_clip, options.pixel_samples,
                 {image.width, image.height}, kept, traced, [&] {
                     if (!traced) {
                         traced_hits_.clear();
                         drawn_hits_.find(request, hits_);
                         return;
                     }
                     drawn_hits_.clear();
                     traced_hits_.find(request, hits_);
                     statistics.camera_rays += request.offsets.size() *
                                               static_cast<std::uint64_t>(request.width) *
                                               static_cast<std::uint64_t>(request.height);
                 });
}

void Renderer::clear_hits() {
    finding_.reset();
    hits_.clear();
    drawn_hits_.clear();
    traced_hits_.clear();
}

}  // namespace nicol
