// SPDX-License-Identifier: MIT
// Response tables of a scene's materials.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>

#include "material/response_cache.hpp"
#include "methods/transfer_input.hpp"
#include "stage/workers.hpp"

namespace nicol {

class ResponseTables {
public:
    using Map = std::map<MaterialPtr, ResponseTable>;

    /// Sets the cache folder of the tables, see load_or_build().
    void set_cache(std::filesystem::path folder, CacheNotice notice);

    /// Projects plain_materials() without the sampled terms. Keeps the tables of materials that the last call
    /// had as well. Returns the number of projected materials.
    std::size_t project(const TransferInput& input, SampledTerms sampled, const LightLayout& layout,
                        RenderRun& run);

    [[nodiscard]] const Versioned<Map>& tables() const noexcept { return tables_; }

private:
    std::filesystem::path folder_;
    CacheNotice notice_;
    // Inputs: sampled terms, channels, order, kind of the light.
    Stage<SampledTerms, int, int, LightKind> sizing_;
    Stage<Version, SampledTerms, int, int, LightKind> projecting_;
    Versioned<Map> tables_;
};

}  // namespace nicol
