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
void read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices,
                     IntegratorDescription& integrator, int& left) {
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
    const double max_depth = type->reflects_often ? plugin.number("max_depth", -1.0) : 2.0;
    const bool reflects_often = max_depth < 0.0 || max_depth > 2.0;
    integrator.reflects_often |= reflects_often;
    notices.add_unfollowed(node, "integrator " + in_quotes(plugin.type()) +
                                     (reflects_often ? " (light is reflected once)" : ""));
    integrator.hide_emitters |= plugin.boolean("hide_emitters", false);
    if (!type->holds_others) return static_cast<void>(plugin.objects({}));
    for (const NestedObject& inner : plugin.objects({"integrator"}))
        read_integrator(document, inner.node, notices, integrator, left);
}

}  // namespace

IntegratorDescription read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    int left = kMostIntegrators;
    IntegratorDescription integrator{.reflects_often = false};
    read_integrator(document, node, notices, integrator, left);
    return integrator;
}

}  // namespace nicol::scene
