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

    /// A <default>; without effect where the name has a value already. Throws std::invalid_argument for a
    /// name with a $ or of more than 256 characters.
    void add_default(const std::string& name, const std::string& value);
    /// `text` with every $name replaced. As in Mitsuba the longest name that fits is meant, so that
    /// "$folder/a.obj" works; \$ stands for a dollar. Throws std::out_of_range: unknown name;
    /// std::invalid_argument: a result longer than 64 KiB (defaults that double each other would fill the
    /// memory).
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
    /// The longest name that `text` begins with, or the end.
    [[nodiscard]] Values::iterator longest(std::string_view text);
    [[nodiscard]] std::string names() const;

    Values values_;
};

}  // namespace nicol::scene
