// SPDX-License-Identifier: MIT
#include "methods/response_tables.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "material/shared_terms.hpp"
#include "methods/projected_materials.hpp"
#include "surfaces/plain_materials.hpp"

namespace nicol {
namespace {

using Choice = ResponseTables::Choice;

std::vector<MaterialPtr> chosen_materials(const TransferInput& input, Choice::Terms terms) {
    const std::vector<VertexRange>& all = input.geometry.ranges;
    if (terms == Choice::Terms::all) return plain_materials(all);
    std::vector<VertexRange> ranges;
    std::ranges::copy_if(all, std::back_inserter(ranges), [&](const VertexRange& range) {
        return input.follows(*range.material) == (terms == Choice::Terms::not_followed);
    });
    return plain_materials(ranges);
}

}  // namespace

bool ResponseTables::Choice::has(const Material& material, int term) const {
    if (is_sampled(material, term, without)) return false;
    if (terms == Terms::all) return true;
    return !material.smooth(term) && (terms == Terms::not_smooth || !is_followed(material, term, without));
}

void ResponseTables::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

std::size_t ResponseTables::project(const TransferInput& input, const Choice& choice,
                                    const LightLayout& layout, RenderRun& run) {
    std::size_t projected = 0;
    const int order = layout.order();
    projecting_.run(input.materials, input.follows_lobes, choice, input.channels, order, layout.kind(), [&] {
        const Stopwatch watch;
        Map& known = tables_.change();
        sizing_.run(choice, input.channels, order, layout.kind(), [&] { known.clear(); });
        Map tables;
        const std::vector<MaterialPtr> materials = chosen_materials(input, choice.terms);
        std::vector<MaterialPtr> fresh, chosen;
        for (const MaterialPtr& material : materials) {
            if (auto kept = known.extract(material)) {
                tables.insert(std::move(kept));
                continue;
            }
            fresh.push_back(material);
            chosen.push_back(some_terms(material, [&](int term) { return choice.has(*material, term); }));
        }
        KnownByTerms<ResponseTable::KnownRows> rows(chosen);
        std::vector<std::optional<ResponseTable>> made(fresh.size());
        project_each(chosen, materials.size(), run, [&](std::size_t i) {
            made[i] =
                load_or_build(*chosen[i], layout, input.channels, folder_, notice_, rows.of(*chosen[i]));
        });
        for (std::size_t i = 0; i < fresh.size(); ++i) tables.emplace(fresh[i], *std::move(made[i]));
        projected = fresh.size();
        known = std::move(tables);
        run.statistics.project_ms += watch.milliseconds();
    });
    return projected;
}

}  // namespace nicol
