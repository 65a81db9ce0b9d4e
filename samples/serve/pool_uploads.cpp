// SPDX-License-Identifier: MIT
// Uploaded scenes: their places beside the folder's scenes.
#include <algorithm>
#include <utility>

#include "pool.hpp"

/// Starts with the scenes of the folder and the uploaded ones, none of which is loaded.
void Pool::begin_scenes() {
    std::vector<std::string> ids = hello_.scenes;
    for (const Place& place : places_) ids.push_back(place.id);
    loads_.begin(ids);
}

bool Pool::is_loading(std::size_t scene) const {
    return std::ranges::any_of(slots_, [&](const auto& slot) { return slot->loading == scene; });
}

bool Pool::keep_upload(const Upload& upload) {
    const std::size_t first = hello_.scenes.size();
    const auto known = std::ranges::find(places_, upload.id, &Place::id);
    if (known != places_.end()) {
        touch(first + static_cast<std::size_t>(known - places_.begin()));
        return true;
    }
    std::optional<std::size_t> oldest;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const SceneLoads::Condition condition = loads_.condition(first + i);
        if (condition == SceneLoads::Condition::preparing || is_loading(first + i)) continue;
        if (!oldest || places_[i].asked < places_[*oldest].asked) oldest = i;
    }
    if (!oldest) return false;
    const std::size_t scene = first + *oldest;
    dispatcher_.retire_scene(static_cast<std::uint32_t>(scene));
    places_[*oldest] = {.id = upload.id, .content = pack(upload), .asked = ++asked_};
    loads_.put(scene, upload.id);
    go_on_all();
    return true;
}

void Pool::touch(std::size_t scene) {
    if (is_upload(scene)) places_[scene - hello_.scenes.size()].asked = ++asked_;
}
