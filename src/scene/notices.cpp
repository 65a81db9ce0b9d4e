// SPDX-License-Identifier: MIT
// What is not followed.
#include "scene/plugin.hpp"
#include "scene/readers.hpp"

namespace nicol::scene {

void Notices::add_unfollowed(pugi::xml_node node, const std::string& what) {
    if (unfollowed_.empty()) first_place_ = document_.where(node);
    unfollowed_.push_back(what);
}

void Notices::add(pugi::xml_node node, const std::string& sentence) {
    sentences_.push_back(document_.where(node) + ": " + sentence + ".");
}

std::vector<std::string> Notices::take() {
    std::vector<std::string> all;
    if (!unfollowed_.empty()) {
        std::string list;
        for (const std::string& what : unfollowed_) list += (list.empty() ? "" : ", ") + what;
        all.push_back(first_place_ + ": not followed: " + list + ".");
    }
    all.insert(all.end(), sentences_.begin(), sentences_.end());
    return all;
}

void read_integrator(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    const Plugin plugin(document, node);
    if (plugin.type() == "path")
        notices.add_unfollowed(node, "integrator \"path\" (light is reflected once)");
    else if (plugin.type() == "stokes" || plugin.type() == "direct")
        notices.add_unfollowed(node, "integrator " + in_quotes(plugin.type()));
    else
        plugin.fail_type("stokes, direct, path", "light is reflected once, to Stokes vectors");
    // In practice a chain of two: XML limits the depth, a circle of <ref>s does not.
    if (plugin.type() != "stokes") return static_cast<void>(plugin.objects({}));
    for (const NestedObject& inner : plugin.single_objects({"integrator"})) {
        if (std::string_view(inner.node.attribute("type").value()) == "stokes")
            document.fail(inner.place, "an integrator \"stokes\" in another; expected direct or path");
        read_integrator(document, inner.node, notices);
    }
}

}  // namespace nicol::scene
