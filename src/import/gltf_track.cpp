// SPDX-License-Identifier: MIT
#include "import/gltf_track.hpp"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "import/gltf_accessor.hpp"

namespace nicol::scene {
namespace {

enum class Interpolation { step, linear, cubic };

// Place of a time among the times of a sampler.
struct Place {
    std::size_t before = 0, after = 0;  // keys
    double part = 0;                    // of the way from the one to the other
    double length = 0;                  // seconds between them
};

Place place_of(const GltfDocument& document, const GltfAccessor& times, double time, const std::string& where,
               const LoadBudget& budget) {
    if (times.components() != 1 || !times.is_real())
        document.fail(where, "input must have one float per key, the time in seconds");
    Place place;
    double last = 0;
    for (std::size_t i = 0; i < times.count(); ++i) {
        budget.step();
        const double at = times.number(i, 0);
        if (!std::isfinite(at) || at < 0 || (i > 0 && at <= last))
            document.fail(where, "input must ascend from 0 or more; number " + std::to_string(i) +
                                     " (0-based) does not");
        if (at <= time) place = {.before = i, .after = i};
        if (at > time && i > 0 && place.before == i - 1 && last <= time)
            place = {.before = i - 1, .after = i, .part = (time - last) / (at - last), .length = at - last};
        last = at;
    }
    return place;
}

Interpolation interpolation_of(const GltfDocument& document, const std::string& name,
                               const std::string& where) {
    if (name.empty() || name == "LINEAR") return Interpolation::linear;
    if (name == "STEP") return Interpolation::step;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    document.fail(where, "interpolation is \"" + name + R"("; expected "LINEAR", "STEP" or "CUBICSPLINE")");
}

// Returns the quaternion of four numbers x, y, z, w with unit length.
glm::dquat rotation_of(const GltfDocument& document, const std::vector<double>& xyzw,
                       const std::string& where) {
    const glm::dquat q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    if (!(glm::length(q) > 0)) document.fail(where, "output has a rotation of length 0");
    return glm::normalize(q);
}

}  // namespace

std::vector<double> gltf_track_value(const GltfDocument& document, const tinygltf::AnimationSampler& sampler,
                                     double time, std::size_t size, bool rotation, const std::string& where,
                                     const LoadBudget& budget) {
    const GltfAccessor times(document, sampler.input, where + ": input");
    const GltfAccessor values(document, sampler.output, where + ": output");
    const Interpolation interpolation = interpolation_of(document, sampler.interpolation, where);
    // A cubic key is three values: the tangent before it, the value and the tangent after it.
    const std::size_t parts = interpolation == Interpolation::cubic ? 3 : 1;
    const std::size_t numbers = values.count() * values.components();
    if (size == 0) size = numbers / (times.count() * parts);
    if (size == 0 || numbers != times.count() * parts * size)
        document.fail(where, "output has " + std::to_string(numbers) + " numbers for " +
                                 std::to_string(times.count()) + " keys; expected " +
                                 std::to_string(parts * size) + " per key");
    const auto value = [&](std::size_t key, std::size_t part) {
        std::vector<double> out;
        for (std::size_t i = 0; i < size; ++i) {
            budget.step();
            const std::size_t number = (key * parts + part) * size + i;
            out.push_back(values.number(number / values.components(), number % values.components()));
            if (!std::isfinite(out.back()))
                document.fail(where, "output has a number that is not finite, of key " + std::to_string(key));
        }
        return out;
    };
    const Place place = place_of(document, times, time, where, budget);
    std::vector<double> out = value(place.before, parts / 2);
    if (place.before != place.after && interpolation != Interpolation::step) {
        const std::vector<double> next = value(place.after, parts / 2);
        const double t = place.part;
        if (interpolation == Interpolation::cubic) {
            const std::vector<double> leaving = value(place.before, 2), arriving = value(place.after, 0);
            const double t2 = t * t, t3 = t2 * t;
            for (std::size_t i = 0; i < size; ++i)
                out[i] = (2 * t3 - 3 * t2 + 1) * out[i] + place.length * (t3 - 2 * t2 + t) * leaving[i] +
                         (3 * t2 - 2 * t3) * next[i] + place.length * (t3 - t2) * arriving[i];
        } else if (rotation) {
            // glm takes the shorter way.
            const glm::dquat q =
                glm::slerp(rotation_of(document, out, where), rotation_of(document, next, where), t);
            out = {q.x, q.y, q.z, q.w};
        } else {
            for (std::size_t i = 0; i < size; ++i) out[i] += t * (next[i] - out[i]);
        }
    }
    if (rotation) {
        const glm::dquat q = rotation_of(document, out, where);
        out = {q.x, q.y, q.z, q.w};
    }
    return out;
}

}  // namespace nicol::scene
