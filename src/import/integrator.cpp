// SPDX-License-Identifier: MIT
// <integrator>: Mitsuba's, of which only AOVs, hide_emitters and max_depth have an effect.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "image/aovs.hpp"
#include "import/plugin.hpp"
#include "import/readers.hpp"
#include "import/text.hpp"
#include "scene/path_depth.hpp"

namespace nicol::scene {
namespace {

constexpr int kMostIntegrators = 16;

struct Type {
    std::string_view name;
    bool holds_others;
    bool reflects_often;
    std::uint32_t aovs = 0;
};
constexpr std::array<Type, 9> kTypes = {{{"stokes", true, false},
                                         {"moment", true, false},
                                         {"aov", true, false},
                                         {"direct", false, false},
                                         {"depth", false, false, aov_depth},
                                         {"path", false, true},
                                         {"volpath", false, true},
                                         {"volpathmis", false, true},
                                         {"ptracer", false, true}}};

struct AovType {
    std::string_view name;
    std::uint32_t bit;  // 0: not made
};
constexpr std::array<AovType, 13> kAovTypes = {{{"depth", aov_depth},
                                                {"position", aov_positions},
                                                {"sh_normal", aov_normals},
                                                {"shape_index", aov_instances},
                                                {"albedo", 0},
                                                {"uv", 0},
                                                {"geo_normal", 0},
                                                {"dp_du", 0},
                                                {"dp_dv", 0},
                                                {"duv_dx", 0},
                                                {"duv_dy", 0},
                                                {"prim_index", 0},
                                                {"boundary_test", 0}}};

/// Returns the AOVs that "name:type, name:type" asks for. The channels keep the names of the AOVs.
std::uint32_t read_aovs(Plugin& plugin, pugi::xml_node node, Notices& notices) {
    std::uint32_t aovs = 0;
    const std::string list = plugin.string("aovs", "");
    std::array<bool, kAovTypes.size()> asked{};
    for (std::string_view rest = list; !trimmed(rest).empty();) {
        const std::string_view one = trimmed(rest.substr(0, rest.find(',')));
        rest.remove_prefix(std::min(rest.size(), rest.find(',')));
        if (!rest.empty()) rest.remove_prefix(1);
        const std::size_t colon = one.find(':');
        const auto type = std::ranges::find(
            kAovTypes, colon == one.npos ? one : trimmed(one.substr(colon + 1)), &AovType::name);
        if (colon == one.npos || type == kAovTypes.end())
            plugin.fail("aovs", "holds " + in_quotes(one) + "; expected name:type with a type of: " +
                                    joined(kAovTypes, &AovType::name));
        aovs |= type->bit;
        asked[static_cast<std::size_t>(type - kAovTypes.begin())] = true;
    }
    std::vector<std::string_view> missing;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (asked[i] && kAovTypes[i].bit == 0) missing.push_back(kAovTypes[i].name);
    if (!missing.empty())
        notices.add(node, "AOVs that are not made: " + joined(missing) +
                              "; there are depth, position, sh_normal and shape_index");
    return aovs;
}

/// Returns the max_depth of an integrator. Mitsuba's 0, a black image, is read as 1.
int read_depth(Plugin& plugin) {
    const double depth = plugin.number("max_depth", -1.0);
    if (depth < 0.0 || depth >= kUnlimitedDepth) return kUnlimitedDepth;
    return std::max(1, static_cast<int>(depth));
}

/// `left`: how many integrators may be read, itself counted. This ends circles of <ref>s.
void read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices,
                     IntegratorDescription& integrator, int& left) {
    if (left-- == 0)
        document.fail(node, "more than " + std::to_string(kMostIntegrators) +
                                " integrators inside each other; does one refer to itself?");
    Plugin plugin(document, node);
    const auto type = std::ranges::find(kTypes, std::string_view(plugin.type()), &Type::name);
    if (type == kTypes.end())
        plugin.fail_type(joined(kTypes, &Type::name), "light is followed to Stokes vectors");
    const int max_depth = type->reflects_often ? read_depth(plugin) : kDirectLightDepth;
    integrator.aovs |= type->aovs;
    if (plugin.type() == "aov")
        integrator.aovs |= read_aovs(plugin, node, notices);
    else
        notices.add_unfollowed(node, "integrator " + in_quotes(plugin.type()) +
                                         (max_depth > kDirectLightDepth ? " (but for max_depth)" : ""));
    integrator.hide_emitters |= plugin.boolean("hide_emitters", false);
    const auto others = type->holds_others ? plugin.objects({"integrator"}) : plugin.objects({});
    // An integrator that holds others has their depth.
    if (others.empty()) integrator.max_depth = std::max(integrator.max_depth, max_depth);
    for (const NestedObject& inner : others) read_integrator(document, inner.node, notices, integrator, left);
}

}  // namespace

IntegratorDescription read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    int left = kMostIntegrators;
    IntegratorDescription integrator;
    read_integrator(document, node, notices, integrator, left);
    return integrator;
}

}  // namespace nicol::scene
