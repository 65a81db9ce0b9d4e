// SPDX-License-Identifier: MIT
#include "reference/path_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "material/conductor.hpp"
#include "material/reflectance.hpp"
#include "material/spatial_variation.hpp"
#include "shading/boundary_split.hpp"
#include "shading/normal_variation.hpp"
#include "shading/rough_boundary.hpp"

namespace nicol {
namespace {

// No light comes from this direction.
constexpr glm::dvec3 kNoDirection(0.0);

}  // namespace

void PathWorkspace::absorb(const SmoothBoundary* along, double distance) {
    if (along == nullptr) return;
    for (std::size_t c = 0; c < incident.size(); ++c)
        incident[c] *= transmitted_by(along, static_cast<int>(c), distance);
}

PathVertex::PathVertex(const SurfaceHit& hit, const Frame& received, PathWorkspace& workspace)
    : hit_(hit), workspace_(workspace), boundary_(hit.side.material->smooth_boundary()) {
    if (boundary_ != nullptr) passing_.emplace(*boundary_, hit.towards_viewer);
    const Mueller into_received =
        frame_rotation(angle_between(hit.frame * theta_phi_frame(hit.towards_viewer), received));
    for (Mueller& throughput : workspace.throughput) throughput = throughput * into_received;
    weigh_layers();
}

void PathVertex::weigh_layers() const {
    const std::size_t layers = hit_.side.layers.size();
    workspace_.weights.assign(layers, glm::vec3(1));
    workspace_.shares.assign(layers, 1);
    const SpatialVariation* const variation = hit_.side.material->variation();
    if (variation == nullptr) return;
    variation->weights(hit_.point, workspace_.weights);
    double sum = 0;
    for (std::size_t l = 0; l < layers; ++l) {
        const glm::vec3& weight = workspace_.weights[l];
        workspace_.shares[l] =
            static_cast<double>(std::abs(weight.x) + std::abs(weight.y) + std::abs(weight.z));
        sum += workspace_.shares[l];
    }
    for (double& share : workspace_.shares) share = sum > 0 ? share / sum : 1 / static_cast<double>(layers);
}

glm::dvec3 PathVertex::in_world(const glm::dvec3& towards_light) const {
    return glm::normalize(hit_.frame * towards_light);
}

Frame PathVertex::incident_frame(const glm::dvec3& towards_light) const {
    return hit_.frame * theta_phi_frame(-towards_light);
}

Ray PathVertex::ray(const glm::dvec3& towards_light) const {
    return leaving(hit_.position, hit_.geometric_normal, in_world(towards_light), hit_.ray_offset);
}

bool PathVertex::lit_from(const glm::dvec3& towards_light) const {
    if (towards_light == kNoDirection) return false;
    const bool above = glm::dot(in_world(towards_light), hit_.unturned) > 0;
    if (boundary_ != nullptr && !(towards_light.z > 0)) return towards_light.z < 0 && !above;
    return towards_light.z > 0 && above;
}

const SmoothBoundary* PathVertex::body_towards(const glm::dvec3& towards_light) const {
    if (boundary_ == nullptr || boundary_->behind == SmoothBoundary::Behind::slab) return workspace_.body;
    return towards_light.z < 0 ? boundary_ : nullptr;
}

void PathVertex::absorb(const glm::dvec3& towards_light, double distance) const {
    workspace_.absorb(body_towards(towards_light), distance);
}

double PathVertex::dimming(const glm::dvec3& towards_light) const {
    if (!hit_.dimmed) return 1;
    return static_cast<double>(
        terminator_shadowing(static_cast<float>(glm::dot(hit_.unturned, hit_.frame[2])),
                             static_cast<float>(glm::dot(hit_.unturned, in_world(towards_light)))));
}

// The first coordinate chooses the layer, and its remainder samples the layer.
glm::dvec3 PathVertex::sample(const glm::dvec2& point) const {
    const std::vector<double>& shares = workspace_.shares;
    double x = point.x;
    // A sample on the other side of the surface than it is meant for carries no light; pdf() has no part of
    // it.
    const auto only_if = [&](bool crosses_surface, const glm::dvec3& towards_light) {
        return crosses(towards_light) == crosses_surface ? towards_light : kNoDirection;
    };
    if (passing_) {
        const double share = passing_->transmitted_share();
        if (x < share) return only_if(true, passing_->sample_transmitted({x / share, point.y}));
        x = std::min((x - share) / (1 - share), 1 - 1e-16);
        if (hit_.towards_viewer.z < 0) return only_if(false, passing_->sample_reflected({x, point.y}));
    }
    std::size_t chosen = 0;
    while (chosen + 1 < shares.size() && x >= shares[chosen]) x -= shares[chosen++];
    // A remainder from rounding may reach a layer that has no share.
    while (chosen > 0 && shares[chosen] == 0) --chosen;
    const double within = std::min(x / shares[chosen], 1 - 1e-16);
    const glm::dvec3 out = hit_.side.layers[chosen].sampler->sample(hit_.towards_viewer, {within, point.y});
    return passing_ ? only_if(false, out) : out;
}

double PathVertex::pdf(const glm::dvec3& towards_light) const {
    double sum = 0;
    const std::vector<double>& shares = workspace_.shares;
    if (passing_ && crosses(towards_light))
        return passing_->transmitted_share() * passing_->transmitted_pdf(towards_light);
    if (passing_ && towards_light.z < 0)
        return (1 - passing_->transmitted_share()) * passing_->reflected_pdf(towards_light);
    for (std::size_t l = 0; l < shares.size(); ++l)
        if (shares[l] > 0)
            sum += shares[l] * hit_.side.layers[l].sampler->pdf(hit_.towards_viewer, towards_light);
    return passing_ ? (1 - passing_->transmitted_share()) * sum : sum;
}

void PathVertex::evaluate(const glm::dvec3& towards_light, bool sized) const {
    const auto channels = static_cast<int>(workspace_.scattering.size());
    const double factor = dimming(towards_light) * towards_light.z;
    std::ranges::fill(workspace_.scattering, Mueller());
    if (boundary_ != nullptr && (towards_light.z < 0 || hit_.towards_viewer.z < 0))
        return add_boundary(towards_light);
    for (std::size_t l = 0; l < hit_.side.layers.size(); ++l) {
        if (workspace_.shares[l] == 0) continue;
        const Material& material = *hit_.side.layers[l].material;
        workspace_.terms.resize(static_cast<std::size_t>(material.terms()));
        material.evaluate_terms(towards_light, hit_.towards_viewer, workspace_.terms);
        for (int t = 0; t < material.terms(); ++t) {
            if (!sized && material.smooth(t)) continue;
            const Mueller& term = workspace_.terms[static_cast<std::size_t>(t)];
            for (int c = 0; c < channels; ++c) {
                // Colour textures require three channels. With other numbers of channels all three weights
                // of a layer are equal.
                const double of_layer = workspace_.weights[l][channels == 3 ? c : 0];
                const double of_term = material.weight(t, material.channels() == 1 ? 0 : c);
                Mueller& sum = workspace_.scattering[static_cast<std::size_t>(c)];
                sum = sum + factor * of_layer * of_term * term;
            }
        }
    }
}

void PathVertex::add_boundary(const glm::dvec3& towards_light) const {
    const auto in_channel = [&](int c) {
        return std::abs(towards_light.z) *
               rough_scattering(*boundary_, towards_light, hit_.towards_viewer, c);
    };
    Mueller m = in_channel(0);
    const std::vector<double>& factors =
        crosses(towards_light) ? boundary_->transmittance : boundary_->reflectance;
    for (std::size_t c = 0; c < workspace_.scattering.size(); ++c) {
        const int channel = static_cast<int>(c);
        if (boundary_->film && channel > 0) m = in_channel(channel);
        workspace_.scattering[c] = of_channel(factors, channel) * m;
    }
}

void PathVertex::add_reflected(const glm::dvec3& towards_light, double pdf, bool sized,
                               std::span<Stokes> sum) const {
    if (!(pdf > 0)) return;
    evaluate(towards_light, sized);
    for (std::size_t c = 0; c < sum.size(); ++c) {
        const Stokes reflected = workspace_.scattering[c] * workspace_.incident[c] / pdf;
        sum[c] += workspace_.throughput[c] * reflected;
    }
}

bool PathVertex::mirrors() const {
    return is_mirror(*hit_.side.material);
}

void PathVertex::extend_mirrored() const {
    evaluate(mirrored(), true);
    const double scale = kMirrorScale * hit_.towards_viewer.z;  // evaluate() multiplies by the other cosine
    for (std::size_t c = 0; c < workspace_.throughput.size(); ++c)
        workspace_.throughput[c] = workspace_.throughput[c] * (scale * workspace_.scattering[c]);
}

double PathVertex::extend(const glm::dvec3& towards_light, double pdf) const {
    evaluate(towards_light, true);
    for (std::size_t c = 0; c < workspace_.throughput.size(); ++c)
        workspace_.throughput[c] = workspace_.throughput[c] * (1 / pdf * workspace_.scattering[c]);
    workspace_.body = body_towards(towards_light);
    if (boundary_ == nullptr || boundary_->behind == SmoothBoundary::Behind::slab || !crosses(towards_light))
        return 1;
    const double eta = boundary_->eta;
    return towards_light.z < 0 ? 1 / (eta * eta) : eta * eta;
}

}  // namespace nicol
