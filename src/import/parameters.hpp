// SPDX-License-Identifier: MIT
// The $parameters of a scene file.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "import/scene_description.hpp"

namespace nicol::scene {

/// Values by name: the caller's, and the file's <default>s where the caller gave none.
class Parameters {
public:
    explicit Parameters(const SceneParameters& overrides);

    /// Adds a <default>, which has no effect if the name has a value already. Throws std::invalid_argument
    /// for a name that contains a $ or has more than 256 characters.
    void add_default(const std::string& name, const std::string& value);
    /// Returns `text` with every $name replaced. The longest name that fits is meant, as in Mitsuba, so that
    /// "$folder/a.obj" works; \$ stands for a dollar. Throws std::out_of_range for an unknown name, and
    /// std::invalid_argument for a result longer than 64 KiB, because defaults that double each other would
    /// fill the memory.
    [[nodiscard]] std::string replaced(std::string_view text);
    /// Throws Error(invalid_argument) if an override was neither used nor declared by a <default>.
    void require_all_used(const std::string& file) const;

private:
    static constexpr std::size_t kMaxNameLength = 256;
    struct Value {
        std::string text;
        bool used = false;
    };
    using Values = std::map<std::string, Value, std::less<>>;
    /// Returns the longest name at the beginning of `text`, or the end.
    [[nodiscard]] Values::iterator longest(std::string_view text);
    [[nodiscard]] std::string names() const;

    Values values_;
};

}  // namespace nicol::scene
