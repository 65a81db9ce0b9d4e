// SPDX-License-Identifier: MIT
#include "handles.hpp"

#include <bit>
#include <cstdint>
#include <unordered_map>

#include "initialiser.hpp"

namespace nicol::capi {
namespace registry {
namespace {

struct Entry {
    HandleKind kind;
    void* object;
};

struct Registry {
    std::mutex mutex;
    std::unordered_map<std::uintptr_t, Entry> alive;
    std::uintptr_t next = 1;
};

// Returns the registry, which is never destroyed, because a host may release its handles after the library's
// static objects.
Registry& all() {
    static auto* registry = new Registry;
    return *registry;
}

const char* name(HandleKind kind) {
    switch (kind) {
        case HandleKind::context:
            return "nicol_context";
        case HandleKind::environment:
            return "nicol_environment";
        case HandleKind::texture:
            return "nicol_texture";
        case HandleKind::material:
            return "nicol_material";
        case HandleKind::mesh:
            return "nicol_mesh";
        case HandleKind::scene:
            return "nicol_scene";
        case HandleKind::framebuffer:
            return "nicol_framebuffer";
        case HandleKind::job:
            return "nicol_job";
        case HandleKind::psh_transform:
            return "nicol_psh_transform";
    }
    return "handle";
}

// Returns a handle's entry. Requires the mutex.
const Entry& find(const void* handle, HandleKind kind) {
    const auto found = all().alive.find(reinterpret_cast<std::uintptr_t>(handle));
    if (found != all().alive.end() && found->second.kind == kind) return found->second;
    const std::string wanted = std::string("a ") + name(kind);
    if (handle == nullptr) throw Error(ErrorCode::invalid_handle, "NULL was passed for " + wanted);
    if (found == all().alive.end()) {
        throw Error(ErrorCode::invalid_handle,
                    "a handle that was released or never created was passed for " + wanted);
    }
    throw Error(ErrorCode::invalid_handle,
                std::string("a ") + name(found->second.kind) + " was passed for " + wanted);
}

}  // namespace

void* add(void* object, HandleKind kind) {
    const std::lock_guard lock(all().mutex);
    const std::uintptr_t handle = all().next++;
    all().alive.emplace(handle, Entry{kind, object});
    return std::bit_cast<void*>(handle);
}

Held hold(const void* handle, HandleKind kind) {
    std::unique_lock lock(all().mutex);
    void* object = find(handle, kind).object;
    return {std::move(lock), object};
}

void forget(const void* handle) noexcept {
    all().alive.erase(reinterpret_cast<std::uintptr_t>(handle));
}

}  // namespace registry

std::vector<double> spectrum(const nicol_spectrum& values, double fallback, std::size_t fallback_channels,
                             const char* name) {
    if (values.count == 0) {
        std::vector<double> filled(fallback_channels, fallback);
        return filled;
    }
    if (values.count > NICOL_MAX_CHANNELS) {
        refuse(std::string(name) + ".count is " + std::to_string(values.count) + "; it must lie in 0 to " +
               std::to_string(NICOL_MAX_CHANNELS));
    }
    return {values.values, values.values + values.count};
}

glm::dmat4 matrix(const double* rows) {
    glm::dmat4 m;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) m[column][row] = rows[4 * row + column];
    }
    return m;
}

void write_matrix(const glm::dmat4& m, double* rows) {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) rows[4 * row + column] = m[column][row];
    }
}

void write_ids(const std::vector<std::uint32_t>& all, std::uint32_t* ids, std::uint64_t count,
               const char* what) {
    if (count != all.size())
        refuse("count is " + std::to_string(count) + "; the scene has " + std::to_string(all.size()) + " " +
               what);
    if (count > 0) require(ids, "ids");
    std::ranges::copy(all, ids);
}

}  // namespace nicol::capi

NICOL_INITIALISER(nicol_spectrum, NICOL_SPECTRUM_INIT)
