// SPDX-License-Identifier: MIT
#include "render/kept_projection.hpp"

namespace nicol {

PshVector KeptProjection::project(const EnvironmentPtr& environment, int order) {
    if (!environment) return {order, 1};
    if (environment != environment_ || order > light_.order()) {
        environment_.reset();
        light_ = environment->project(order);
        environment_ = environment;
    }
    return with_order(light_, order);
}

}  // namespace nicol
