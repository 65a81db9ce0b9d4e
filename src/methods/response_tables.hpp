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

    /// Choice of materials and of their terms.
    struct Choice {
        SampledTerms without = SampledTerms::none;  ///< terms that are left out
        enum class Terms { all, not_smooth, not_followed };
        /// Other terms. not_smooth: without those that replace smooth surfaces, for materials whose lobes no
        /// rays follow. not_followed: without the followed ones either, for the materials that
        /// TransferInput::follows() names.
        Terms terms = Terms::all;
        bool operator==(const Choice&) const = default;
        /// Returns whether a term of a material without variation is chosen.
        [[nodiscard]] bool has(const Material& material, int term) const;
    };

    /// Projects plain_materials(), or those of the choice. Keeps the tables of materials that the last call
    /// had as well. Returns the number of projected materials.
    std::size_t project(const TransferInput& input, const Choice& choice, const LightLayout& layout,
                        RenderRun& run);

    [[nodiscard]] const Versioned<Map>& tables() const noexcept { return tables_; }

private:
    std::filesystem::path folder_;
    CacheNotice notice_;
    // Inputs: choice, channels, order, kind of the light.
    Stage<Choice, int, int, LightKind> sizing_;
    // Inputs: materials, whether rays follow lobes, and those of sizing_.
    Stage<Version, bool, Choice, int, int, LightKind> projecting_;
    Versioned<Map> tables_;
};

}  // namespace nicol
