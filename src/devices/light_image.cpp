// SPDX-License-Identifier: MIT
#include "devices/light_image.hpp"

#include <tbb/combinable.h>

#include "devices/pixel_lights.hpp"
#include "draw/visibility_buffer.hpp"
#include "shading/channel_spans.hpp"

namespace nicol {

void find_light_image(const PixelInput& input, std::size_t first, std::size_t last, RenderRun& run,
                      std::vector<std::vector<glm::vec4>>& out) {
    const Stopwatch watch;
    out.resize(static_cast<std::size_t>(input.channels));
    for (auto& channel : out) channel.assign(last - first, glm::vec4(0));
    const std::vector<std::span<glm::vec4>> image(out.begin(), out.end());
    const PixelLights lights(input.local_lights->lighting(), input);
    const std::size_t pixels =
        static_cast<std::size_t>(input.hits.width()) * static_cast<std::size_t>(input.hits.height());
    tbb::combinable<LightingTally> tallies;
    run.workers.for_vertices(
        first, last, pixels, "shade", run.progress, [&](std::size_t begin, std::size_t end) {
            thread_local PixelPoints points;
            thread_local std::vector<float> coverage;
            thread_local PixelBatch batch;
            thread_local std::vector<glm::vec4> sums;
            coverage.resize(end - begin);
            points.list(input, begin, end, coverage);
            for (const std::vector<PixelPoint>* const list : {&points.whole, &points.parts}) {
                for (std::span<const PixelPoint> rest(*list); !rest.empty();
                     rest = rest.subspan(batch.points().size())) {
                    batch.take(input, rest);
                    if (!batch.reflects_lights()) continue;
                    sums.clear();
                    const std::vector<std::span<glm::vec4>> stokes =
                        channel_spans(sums, out.size(), batch.points().size());
                    tallies.local() += lights.add(batch, stokes);
                    lights.add_emission(batch, stokes);
                    batch.gather(stokes, input.most_components, first, image);
                }
            }
        });
    tallies.combine_each([&](const LightingTally& tally) { run.add(tally); });
    run.statistics.light_ms += watch.milliseconds();
}

}  // namespace nicol
