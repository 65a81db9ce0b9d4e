// SPDX-License-Identifier: MIT
#include "reference/render_reference.hpp"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <limits>
#include <new>
#include <string>
#include <thread>
#include <utility>

#include "error.hpp"
#include "image/color.hpp"
#include "progress.hpp"
#include "reference/camera_rays.hpp"
#include "reference/filter_sampler.hpp"
#include "reference/low_discrepancy.hpp"
#include "reference/pixel_estimate.hpp"

namespace nicol {
namespace {

constexpr int kTileSide = 8;
// Number of samples between two calls of the progress callback.
constexpr int kSamplesPerReport = 512;

void check(const ReferenceOptions& options) {
    if (options.samples < 1 || options.samples > kMaxReferenceSamples) {
        throw Error(ErrorCode::invalid_argument, "samples is " + std::to_string(options.samples) +
                                                     "; it must lie in 1 to " +
                                                     std::to_string(kMaxReferenceSamples));
    }
    if ((options.aovs & aov_variance) != 0 && options.samples < 2) {
        throw Error(ErrorCode::invalid_argument, "samples is 1; the variance among aovs takes 2 or more");
    }
    if (options.max_depth < 1) {
        throw Error(ErrorCode::invalid_argument,
                    "max_depth is " + std::to_string(options.max_depth) + "; it must be 1 or more");
    }
    if (options.max_depth > kDirectLightDepth && !options.shadows) {
        throw Error(
            ErrorCode::invalid_argument,
            "shadows is off, but max_depth is more than 2: surfaces that light passes do not reflect it "
            "to each other; turn shadows on or set max_depth to 2");
    }
    if (options.workers.threads < 0) {
        throw Error(ErrorCode::invalid_argument, "threads is " + std::to_string(options.workers.threads) +
                                                     "; it must be 0 (one a core) or more");
    }
}

Stokes luminance(std::span<const Stokes> rgb) {
    Stokes sum(0.0);
    for (std::size_t c = 0; c < rgb.size(); ++c) sum += static_cast<double>(kLuminance[c]) * rgb[c];
    return sum;
}

/// Counter of samples on all threads. The thread that made it reports the count.
class SharedProgress {
public:
    SharedProgress(const Progress::Callback& callback, double total) : progress_(callback), total_(total) {}

    /// Adds samples to the count. Throws Error(cancelled).
    void add(std::uint64_t samples) {
        const std::uint64_t done = done_ += samples;
        if (std::this_thread::get_id() == caller_)
            progress_.report("trace", static_cast<double>(done) / total_);
    }

private:
    Progress progress_;
    double total_;
    std::thread::id caller_ = std::this_thread::get_id();
    std::atomic<std::uint64_t> done_ = 0;
};

class Tracer {
public:
    Tracer(const TracedScene& scene, const PathTracer& paths, const CameraRays& rays,
           const ReferenceOptions& options, SharedProgress& progress, tbb::task_group_context& group,
           const Viewpoint& view, StokesImage& image, Aovs& aovs)
        : scene_(scene),
          paths_(paths),
          rays_(rays),
          options_(options),
          progress_(progress),
          group_(group),
          view_(view),
          image_(image),
          aovs_(aovs),
          filter_(options.filter) {}

    void trace(const tbb::blocked_range2d<int>& tile) {
        PathWorkspace workspace;
        PixelEstimate estimate(options_.samples, image_.channels);
        std::vector<Stokes> sum(static_cast<std::size_t>(scene_.channels()));
        std::vector<Stokes> unweighted(sum.size());
        for (int y = tile.rows().begin(); y < tile.rows().end(); ++y) {
            for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                std::uint64_t hits = 0;
                if (!sample_pixel(x, y, sum, unweighted, estimate, hits, workspace)) return;
                for (int c = 0; c < image_.channels; ++c) {
                    const Stokes mean = estimate.mean(c);
                    const auto pixel = image_.at(c, y, x);
                    for (std::size_t p = 0; p < 4; ++p)
                        pixel[p] = static_cast<float>(mean[static_cast<glm::length_t>(p)]);
                }
                if (!aovs_.variance.empty()) record_variance(x, y, estimate);
                if (!aovs_.alpha.empty()) {
                    aovs_.alpha[pixel_at(x, y)] =
                        static_cast<float>(hits) / static_cast<float>(options_.samples);
                }
                constexpr std::uint32_t of_image = aov_variance | aov_alpha;
                if ((aovs_.mask() & ~of_image) != 0) record_surface(x, y);
            }
        }
        shadow_rays_ += workspace.shadow_rays;
    }

    [[nodiscard]] std::uint64_t shadow_rays() const { return shadow_rays_; }

private:
    /// Samples a pixel, and counts the samples with a surface. Returns false if the render has been stopped.
    bool sample_pixel(int x, int y, std::span<Stokes> sum, std::span<Stokes> unweighted,
                      PixelEstimate& estimate, std::uint64_t& hits, PathWorkspace& workspace) {
        // Every pixel has its own points, so the image does not depend on tiles or threads.
        const std::uint64_t pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x);
        const LowDiscrepancy points(mixed(mixed(options_.seed, 0), pixel));
        std::ranges::fill(sum, Stokes(0.0));
        for (int group = 0; group < estimate.groups(); ++group) {
            const int end = estimate.first(group + 1);
            for (int first = estimate.first(group); first < end; first += kSamplesPerReport) {
                const int last = std::min(first + kSamplesPerReport, end);
                for (int i = first; i < last; ++i)
                    hits += add_sample(x, y, points, i, sum, unweighted, workspace) ? 1 : 0;
                if (group_.is_group_execution_cancelled()) return false;
                progress_.add(static_cast<std::uint64_t>(last - first));
            }
            if (options_.luminance) {
                const Stokes grey[] = {luminance(sum)};
                estimate.record(group, grey);
            } else {
                estimate.record(group, sum);
            }
        }
        return true;
    }

    // Adds a sample. Returns whether its ray meets a surface.
    bool add_sample(int x, int y, const LowDiscrepancy& points, int i, std::span<Stokes> sum,
                    std::span<Stokes> unweighted, PathWorkspace& workspace) const {
        const auto index = static_cast<std::uint32_t>(i);
        const glm::dvec2 position = points.point(index, 0);
        if (options_.filter.kind == ReconstructionFilter::Kind::box) {
            const Ray ray = rays_.through(x + position.x, y + position.y);
            return paths_.add(ray, rays_.frame(ray), points, index, sum, workspace);
        }
        const glm::dvec2 centre(x + 0.5, y + 0.5);
        const auto [across, weight_x] = filter_.at(position.x, -centre.x, image_.width - centre.x);
        const auto [down, weight_y] = filter_.at(position.y, -centre.y, image_.height - centre.y);
        const Ray ray = rays_.through(centre.x + across, centre.y + down);
        std::ranges::fill(unweighted, Stokes(0.0));
        const bool hit = paths_.add(ray, rays_.frame(ray), points, index, unweighted, workspace);
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += weight_x * weight_y * unweighted[c];
        return hit;
    }

    [[nodiscard]] std::size_t pixel_at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(aovs_.width) +
               static_cast<std::size_t>(x);
    }

    void record_variance(int x, int y, const PixelEstimate& estimate) {
        // Light of 1e30 has a variance that no float holds.
        constexpr double most = std::numeric_limits<float>::max();
        const std::size_t pixels = pixel_at(0, aovs_.height);
        for (int c = 0; c < image_.channels; ++c) {
            const Stokes variance = estimate.variance(c);
            const std::size_t at = 4 * (static_cast<std::size_t>(c) * pixels + pixel_at(x, y));
            for (std::size_t p = 0; p < 4; ++p) {
                const double value = variance[static_cast<glm::length_t>(p)];
                aovs_.variance[at + p] = static_cast<float>(std::min(value, most));
            }
        }
    }

    void record_surface(int x, int y) {
        const std::optional<TracedScene::Surfel> surfel =
            scene_.first_surface(rays_.through(x + 0.5, y + 0.5));
        if (!surfel) return;
        const std::size_t pixel = pixel_at(x, y);
        if (!aovs_.depth.empty()) {
            aovs_.depth[pixel] = static_cast<float>(glm::dot(view_.forward, surfel->position - view_.eye));
        }
        if (!aovs_.instances.empty()) aovs_.instances[pixel] = surfel->instance;
        const glm::dvec3 in_world = scene_.origin() + surfel->position;
        for (glm::length_t i = 0; i < 3; ++i) {
            const std::size_t at = 3 * pixel + static_cast<std::size_t>(i);
            if (!aovs_.normals.empty()) aovs_.normals[at] = static_cast<float>(surfel->normal[i]);
            if (!aovs_.positions.empty()) aovs_.positions[at] = static_cast<float>(in_world[i]);
        }
    }

    const TracedScene& scene_;
    const PathTracer& paths_;
    const CameraRays& rays_;
    const ReferenceOptions& options_;
    SharedProgress& progress_;
    tbb::task_group_context& group_;
    const Viewpoint& view_;
    StokesImage& image_;
    Aovs& aovs_;
    FilterSampler filter_;
    std::atomic<std::uint64_t> shadow_rays_ = 0;
};

StokesImage render(const Scene& scene, const Projection& projection, int width, int height,
                   const ReferenceOptions& options, ReferenceStatistics& statistics, Strategy strategy,
                   Aovs& aovs) {
    const Stopwatch build;
    const TracedScene traced(scene);
    const SceneLights lights(scene, traced, strategy, options.shadows);
    const PathTracer paths(traced, lights, options.max_depth);
    if (options.luminance && traced.channels() != 3) {
        throw Error(ErrorCode::invalid_argument, "the luminance is that of three channels");
    }
    StokesImage image(width, height, options.luminance ? 1 : traced.channels());
    aovs = Aovs(width, height, options.aovs, image.channels);
    statistics.triangles = traced.triangles();
    statistics.build_ms = build.milliseconds();

    const Stopwatch watch;
    const std::uint64_t samples = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
                                  static_cast<std::uint64_t>(options.samples);
    SharedProgress progress(options.progress, static_cast<double>(samples));
    tbb::task_group_context group;
    Projection from_origin = projection;
    from_origin.view.eye -= traced.origin();
    const CameraRays rays(from_origin, width, height);
    Tracer tracer(traced, paths, rays, options, progress, group, from_origin.view, image, aovs);
    tbb::parallel_for(
        tbb::blocked_range2d<int>(0, height, kTileSide, 0, width, kTileSide),
        [&](const tbb::blocked_range2d<int>& tile) { tracer.trace(tile); }, tbb::simple_partitioner(), group);
    statistics.camera_rays = samples;
    statistics.shadow_rays = tracer.shadow_rays();
    statistics.trace_ms = watch.milliseconds();
    return image;
}

}  // namespace

StokesImage render_reference(const Scene& scene, const Projection& projection, int width, int height,
                             const ReferenceOptions& options, ReferenceStatistics& statistics,
                             Strategy strategy, Aovs* aovs) {
    check(options);
    try {
        Aovs made;
        StokesImage image;
        WorkerPool(options.workers).run([&] {
            image = render(scene, projection, width, height, options, statistics, strategy, made);
        });
        if (aovs != nullptr) *aovs = std::move(made);
        return image;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::out_of_memory,
                    "not enough memory for the scene's triangles, its light and an image of " +
                        std::to_string(width) + " x " + std::to_string(height));
    }
}

}  // namespace nicol
