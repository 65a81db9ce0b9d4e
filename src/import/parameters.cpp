// SPDX-License-Identifier: MIT
// Replaces $parameters.
#include "import/parameters.hpp"

#include <algorithm>
#include <stdexcept>

#include "error.hpp"
#include "import/xml_file.hpp"

namespace nicol::scene {
namespace {

constexpr std::size_t kMaxLength = 65536;

}  // namespace

Parameters::Parameters(const SceneParameters& overrides) {
    for (const auto& [name, text] : overrides) {
        if (name.empty() || name.find('$') != std::string::npos)
            throw Error(ErrorCode::invalid_argument,
                        "scene parameter " + in_quotes(name) + ": expected the name without the $");
        values_[name] = {text, false};
    }
}

void Parameters::add_default(const std::string& name, const std::string& value) {
    if (name.find('$') != std::string::npos || name.size() > kMaxNameLength)
        throw std::invalid_argument("the name " + in_quotes(name) +
                                    "; expected one without a $, of at most " +
                                    std::to_string(kMaxNameLength) + " characters");
    // The used mark of an override: a declared one is no misspelling.
    const auto [entry, is_new] = values_.try_emplace(name, Value{value, true});
    entry->second.used = true;
}

std::string Parameters::replaced(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t dollar = std::min(text.find('$', at), text.size());
        out.append(text.substr(at, dollar - at));
        if (dollar == text.size()) break;
        if (dollar > at && text[dollar - 1] == '\\') {
            out.back() = '$';
            at = dollar + 1;
            continue;
        }
        const std::string_view rest = text.substr(dollar + 1);
        const auto best = longest(rest);
        if (best == values_.end())
            throw std::out_of_range("undefined parameter in " + in_quotes(text) + "; defined are " + names());
        best->second.used = true;
        out.append(best->second.text);
        if (out.size() > kMaxLength)
            throw std::invalid_argument("a value longer than " + std::to_string(kMaxLength) +
                                        " characters once its parameters are replaced");
        at = dollar + 1 + best->first.size();
    }
    return out;
}

// A name has no $, so that this reads on to the next $ of the text at most.
Parameters::Values::iterator Parameters::longest(std::string_view text) {
    auto best = values_.end();
    for (std::size_t length = 1; length <= text.size(); ++length) {
        const std::string_view beginning = text.substr(0, length);
        const auto first = values_.lower_bound(beginning);
        if (first == values_.end() || !first->first.starts_with(beginning)) break;
        if (first->first.size() == length) best = first;
    }
    return best;
}

void Parameters::require_all_used(const std::string& file) const {
    for (const auto& [name, value] : values_)
        if (!value.used)
            throw Error(ErrorCode::invalid_argument, file + ": the file has no parameter " +
                                                         in_quotes("$" + name) + "; it has " + names());
}

std::string Parameters::names() const {
    constexpr std::size_t most = 300;
    std::string list;
    for (const auto& [name, value] : values_) {
        if (list.size() > most) return list + ", ...";
        if (value.used) list += (list.empty() ? "$" : ", $") + name;
    }
    return list.empty() ? "none" : list;
}

}  // namespace nicol::scene
