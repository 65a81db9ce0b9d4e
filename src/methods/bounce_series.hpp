// SPDX-License-Identifier: MIT
// Bounces, by which light at vertices or receivers becomes light that arrives at receivers by links, and
// the sum of all bounces: a Neumann series.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "material/response_table.hpp"
#include "methods/linked_surfaces.hpp"
#include "methods/lobe_photons.hpp"
#include "shading/reflection_rows.hpp"
#include "stage/workers.hpp"
#include "transfer/arriving_irradiance.hpp"
#include "transfer/arriving_light.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/light_columns.hpp"

namespace nicol {

using BounceTables = std::map<MaterialPtr, ResponseTable>;

/// Rows of reflection at the ends of links.
struct BounceRows {
    const ReflectionRows& scalar;  ///< from s0 to s0
    const ReflectionRows& all;     ///< from all numbers of the layout to all components
};

/// Light of lamps that surfaces reflect to receivers.
struct ArrivingLamps {
    const LinkStokes& links;     ///< that arrives by links
    const LobePhotons& photons;  ///< that narrow lobes send
};

/// Bounces of one channel. Works on blocks of sixteen receivers; immutable, so that threads share it.
///
/// Light arrives by coarse links alone, or by all links: then s0 that surfaces reflect of s0 arrives by all
/// of them, and polarization, which is weak, by coarse ones.
class Bounce {
public:
    /// The arguments must outlive the object. tables: of plain_materials(), with the arrival's layout.
    Bounce(const WorldGeometry& geometry, const DirectionSet& directions, const LinkedSurfaces& surfaces,
           const BounceTables& tables, const ArrivingLight& arrival, const LightLayout& layout,
           std::size_t channel);

    /// Sets the lights that arrive at a block of receivers, by coarse links alone, to what surfaces reflect
    /// of light at the geometry's vertices, of the rows' components. out: all numbers of the layout.
    void reflect_vertices(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                          LightColumns& out) const;
    /// Does the same for bounced light, which the receivers have.
    void reflect_receivers(std::size_t block, const ReflectionRows& rows, const LightColumns& light,
                           LightColumns& out) const;
    /// Sets the lights that arrive at a block of receivers, by all links, to what surfaces reflect of light
    /// at vertices and of bounced light; null: there is none.
    void reflect_all(std::size_t block, const BounceRows& rows, const LightColumns& light,
                     const LightColumns* bounced, LightColumns& out) const;
    /// Sets the lights that arrive at a block of receivers, by all links, to the light of lamps and what
    /// surfaces reflect of bounced light; null: there is none. channels: one for each column.
    void gather(std::size_t block, const ArrivingLamps& lamps, std::span<const std::size_t> channels,
                const BounceRows& rows, const LightColumns* bounced, LightColumns& out) const;

private:
    /// photons: light that arrives without links, for the columns of `channels`; null: none.
    /// leave(batch, coarse, stokes): adds the Stokes vectors that leave along a batch's links, [link]
    /// [component][Lanes of columns]: all components of coarse links, s0 of others. only_coarse: whether
    /// light arrives by coarse links alone.
    template <class Leave>
    void arrive(std::size_t block, bool only_coarse, std::size_t components, LightColumns& out,
                const Leave& leave, const LobePhotons* photons = nullptr,
                std::span<const std::size_t> channels = {}) const;
    /// Light that arrives at a block of receivers.
    struct Arrived {
        std::size_t first;  ///< receiver
        std::span<const glm::vec3> normals;
        std::span<Lanes> irradiance;  ///< over pi, [receiver of the block][Lanes of columns]
        LightColumns& light;
    };
    /// Adds light from a direction to what arrives at a receiver, see ArrivingLight::add().
    void add(std::size_t direction, std::size_t receiver, const ArrivingLight::SolidAngles& solid_angles,
             std::size_t components, const Lanes* stokes, const Arrived& out) const;
    /// Adds photons to the light that arrives at a block of receivers.
    void add_photons(std::size_t block, const LobePhotons& photons, std::span<const std::size_t> channels,
                     std::size_t components, const Arrived& out) const;
    /// Adds what leaves along the links of a batch of light at vertices and of bounced light at receivers, of
    /// which one may be null.
    void add_reflected(const LinkedSurfaces::Batch& batch, const ReflectionRows& rows, bool only_coarse,
                       const LightColumns* light, const LightColumns* bounced, Lanes* stokes) const;
    /// Returns the rows of a batch of links, [link][component][number], which the thread's next call changes.
    [[nodiscard]] const VertexLight& find_rows(const LinkedSurfaces::Batch& batch,
                                               const ReflectionRows& rows) const;

    const WorldGeometry& geometry_;
    const DirectionSet& directions_;
    const LinkedSurfaces& surfaces_;
    const BounceTables& tables_;
    const ArrivingLight& arrival_;
    LightLayout layout_;
    LightLayout scalar_layout_;
    FrameRotation rotation_;
    FrameRotation scalar_rotation_;
    ArrivingIrradiance irradiance_;
    Viewpoint frames_ = link_frames();
    std::size_t channel_;
};

/// Conditions that end a series, and the step that it belongs to.
struct SeriesEnd {
    const char* verb;   ///< name of the step in reports of progress
    int bounces;        ///< largest number of bounces, at least 1
    double negligible;  ///< error that ends the series earlier, relative to the RMS of `all`
    double all;         ///< sum over receivers of the square of the direct light's mean over directions
};

/// Light of all bounces at receivers, in the columns of one channel.
struct BounceSeries {
    LightColumns light;
    int rounds = 0;            ///< bounces that were computed
    std::vector<double> left;  ///< sum over receivers of each column's estimated squared error, as `all`
};

/// Size of a series' lights.
struct SeriesSize {
    std::size_t numbers;  ///< numbers of the layout
    std::size_t columns;
};

/// Sets the light of the first bounce at a block of receivers.
using FirstBounce = std::function<void(std::size_t block, LightColumns& out)>;
/// Sets the light of all bounces at a block of receivers. sum: all bounces but the last; null: there is one
/// bounce.
using LastBounce = std::function<void(std::size_t block, const LightColumns* sum, LightColumns& out)>;

/// Sums the bounces. first: light that arrives by the first bounce and continues to bounce; not called if
/// there is one bounce. s0 bounces along coarse links until the end; the polarization of light survives one
/// more bounce, because a surface that reflects twice leaves little of it. `last` takes all links, over which
/// the noise of the others averages. In the end, bounces are a geometric series, whose ratio the last two
/// tell: its sum replaces the bounces that are left out.
[[nodiscard]] BounceSeries sum_bounces(const Bounce& bounce, const LinkedSurfaces& surfaces,
                                       const ReflectionRows& scalar, const FirstBounce& first,
                                       const LastBounce& last, const SeriesSize& size, const SeriesEnd& end,
                                       RenderRun& run);

}  // namespace nicol
