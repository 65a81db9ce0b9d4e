// SPDX-License-Identifier: MIT
// The orders of light above order_low, for every vertex.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "material/response_cache.hpp"
#include "render/render.hpp"
#include "render/transfer_input.hpp"
#include "specular/high_order.hpp"
#include "specular/high_order_light.hpp"
#include "specular/high_order_visibility.hpp"

namespace nicol {

/// Distant light to a high order, in its own axes: filtering commutes with turning, so a turn costs nothing.
struct DistantLight {
    const PshVector& coefficients;  ///< of order `high`, scaled
    std::uint64_t revision;         ///< counts the changes of the coefficients
    glm::dmat3 to_world;
    int low;
    int high;  ///< above low
    bool polarized;
};

class HighOrderTransfer {
public:
    /// Where to keep what takes long to fit; an empty folder: nowhere.
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// For the input of a method that runs before update() and may compute what update() with `input` would:
    /// null where that has all it needs.
    [[nodiscard]] AwaitedVisibility* await(const TransferInput& input, int low);
    /// project: filters the light and fits the materials, as far as changes make it necessary.
    void update(const TransferInput& input, const DistantLight& light, HighOrders form, Workers& workers,
                Progress& progress, Statistics& statistics);
    /// shade, where high orders are looked up at pixels: what the vertices with visible[v] != 0 see of what
    /// they reflect to the viewer, into fractions(). Only after update() with the same input.
    void see(const TransferInput& input, const Viewpoint& view, std::span<const std::uint8_t> visible,
             Workers& workers, Progress& progress);
    /// shade: adds to the vertices with visible[v] != 0. Only after update() with the same input.
    void shade(const TransferInput& input, const DistantLight& light, const Viewpoint& view,
               std::span<const std::uint8_t> visible, Workers& workers, Progress& progress,
               VertexStokes& out);
    void count(Statistics& statistics) const;

    /// A material and what it makes of the light.
    struct Part {
        HighOrderFactors factors;
        std::optional<LobeMap> convolved;  ///< of the published form
        bool filtered = false;             ///< the maps are there
        HighOrderMaps maps;
    };
    [[nodiscard]] const std::map<MaterialPtr, Part>& parts() const noexcept { return parts_; }
    /// Counts the changes of parts().
    [[nodiscard]] std::uint64_t parts_revision() const noexcept { return parts_revision_; }
    /// Of twice the order that high orders begin above; empty where nothing casts shadows.
    [[nodiscard]] const VisibilityBlocks& visibility() const noexcept { return visibility_; }
    /// Counts the changes of visibility().
    [[nodiscard]] std::uint64_t visibility_count() const noexcept { return visibility_count_; }
    /// Of the last see(), of the lobe about the mirror direction and of the hemisphere; empty where nothing
    /// casts shadows.
    [[nodiscard]] std::span<const glm::vec2> fractions() const noexcept { return fractions_; }
    /// Of the lobe that the first of them is of, radians.
    [[nodiscard]] double lobe_width(const MaterialPtr& material) const {
        return kLobeWidths[static_cast<std::size_t>(parts_.at(material).factors.centre())];
    }

private:
    // What the parts belong to.
    struct Key {
        HighOrders form = HighOrders::none;
        int low = -1;
        int high = -1;
        int channels = 0;
        bool polarized = false;
        bool operator==(const Key&) const = default;
    };

    void fit(const TransferInput& input, const Key& key, Workers& workers, Progress& progress,
             Statistics& statistics);
    void filter(const DistantLight& light, Workers& workers);
    /// Whether visibility has to be expanded, and whether what there is of it helps.
    [[nodiscard]] bool is_current(const TransferInput& input, int order) const;
    [[nodiscard]] bool follows(const TransferInput& input, int order) const;
    void expand_visibility(const TransferInput& input, int order, bool follows, Workers& workers,
                           Progress& progress);

    std::filesystem::path folder_;
    CacheNotice notice_;
    Key key_;
    std::map<MaterialPtr, Part> parts_;
    std::map<MaterialPtr, std::vector<ConvolutionKernel>> kernels_;
    std::optional<HighOrderLight> light_;
    std::uint64_t parts_revision_ = 0;
    std::uint64_t filtered_ = 0;  // revision of the light that the maps are of
    std::uint64_t fitted_ = 0;    // revision of the materials

    VisibilityBlocks visibility_;
    std::optional<AwaitedVisibility> awaited_;
    int visibility_order_ = -1;  // that it was made for, also where it is empty
    std::uint64_t visibility_count_ = 0;
    std::uint64_t visibility_revision_ = 0;
    std::uint64_t visibility_geometry_ = 0;
    std::vector<glm::vec2> fractions_;
};

}  // namespace nicol
