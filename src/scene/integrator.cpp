// SPDX-License-Identifier: MIT
// <integrator>: Mitsuba's, of which none is followed.
#include <algorithm>
#include <array>

#include "scene/plugin.hpp"
#include "scene/readers.hpp"

namespace nicol::scene {
namespace {

constexpr int kMostIntegrators = 16;

struct Type {
    std::string_view name;
    bool holds_others;
    bool reflects_often;
};
constexpr std::array<Type, 8> kTypes = {{{"stokes", true, false},
                                         {"moment", true, false},
                                         {"aov", true, false},
                                         {"direct", false, false},
                                         {"depth", false, false},
                                         {"path", false, true},
                                         {"volpath", false, true},
                                         {"volpathmis", false, true}}};

/// `left`: how many integrators may be read, itself counted. This ends circles of <ref>s.
void read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices, int& left) {
    if (left-- == 0)
        document.fail(node, "more than " + std::to_string(kMostIntegrators) +
                                " integrators inside each other; does one refer to itself?");
    Plugin plugin(document, node);
    const auto type = std::ranges::find(kTypes, std::string_view(plugin.type()), &Type::name);
    if (type == kTypes.end()) {
        std::string names;
        for (const Type& known : kTypes) names.append(names.empty() ? "" : ", ").append(known.name);
        plugin.fail_type(names, "light is reflected once, to Stokes vectors");
    }
    notices.add_unfollowed(node, "integrator " + in_quotes(plugin.type()) +
                                     (type->reflects_often ? " (light is reflected once)" : ""));
    if (plugin.boolean("hide_emitters", false))
        notices.add(node, "hide_emitters: the environment and surfaces that shine are seen");
    if (!type->holds_others) return static_cast<void>(plugin.objects({}));
    for (const NestedObject& inner : plugin.objects({"integrator"}))
        read_integrator(document, inner.node, notices, left);
}

}  // namespace

void read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    int left = kMostIntegrators;
    read_integrator(document, node, notices, left);
}

}  // namespace nicol::scene
