// SPDX-License-Identifier: MIT
// Projection of several materials at once.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <span>
#include <vector>

#include "material/shared_terms.hpp"
#include "stage/workers.hpp"

namespace nicol {

/// Calls project(i) once for each of some materials, several at a time, because the integrals of one material
/// leave threads idle between their steps. Calls for materials with equal terms follow each other, so that
/// they may share what is known. Reports progress as a fraction of `all`. Throws Error(cancelled) and what
/// project() throws.
template <class Project>
void project_each(std::span<const MaterialPtr> materials, std::size_t all, RenderRun& run,
                  const Project& project) {
    constexpr std::size_t at_a_time = 8;  // groups between two reports
    const std::vector<std::vector<std::size_t>> groups = groups_by_terms(materials);
    std::size_t done = all - materials.size();
    for (std::size_t first = 0; first < groups.size(); first += at_a_time) {
        const std::size_t last = std::min(first + at_a_time, groups.size());
        run.progress.report("project", static_cast<double>(done) / static_cast<double>(all));
        // An exception that leaves the loop cancels the loops within other groups, which then end early and
        // would leave tables of a part, also in the cache.
        std::vector<std::exception_ptr> failures(last - first);
        run.workers.run([&] {
            tbb::parallel_for(first, last, [&](std::size_t group) {
                try {
                    for (const std::size_t i : groups[group]) project(i);
                } catch (...) {
                    failures[group - first] = std::current_exception();
                }
            });
        });
        for (const std::exception_ptr& failure : failures)
            if (failure) std::rethrow_exception(failure);
        for (std::size_t group = first; group < last; ++group) done += groups[group].size();
    }
}

}  // namespace nicol
