// SPDX-License-Identifier: MIT
#include "guest.hpp"

#include "entry_points.hpp"

namespace {

std::uint32_t make_texture(const EglContext& egl) {
    constexpr std::uint32_t texture_2d = 0x0DE1, rgba32f = 0x8814;
    constexpr auto size = static_cast<std::int32_t>(EntryPoints::size());
    const auto make = reinterpret_cast<void (*)(std::uint32_t, std::int32_t, std::uint32_t*)>(
        egl.function("glCreateTextures"));
    const auto store =
        reinterpret_cast<void (*)(std::uint32_t, std::int32_t, std::uint32_t, std::int32_t, std::int32_t)>(
            egl.function("glTextureStorage2D"));
    std::uint32_t name = 0;
    make(texture_2d, 1, &name);
    store(name, 1, rgba32f, size, size);
    return name;
}

nicol_context_options without_cache(std::uint32_t threads) {
    auto options = nicol::defaults(nicol_context_options_init);
    options.threads = threads;
    options.cache_folder = "";
    return options;
}

}  // namespace

Guest Guest::own(nicol_backend backend, std::uint32_t threads) {
    auto options = without_cache(threads);
    options.backend = backend;
    return {.egl = nullptr, .context = create<Context>(nicol_context_create, &options)};
}

Guest Guest::in_host(std::uint32_t threads) {
    Guest made{.egl = std::make_unique<EglContext>(), .context = {}};
    made.texture = make_texture(*made.egl);
    auto host = nicol::defaults(nicol_host_init);
    host.user = made.egl.get();
    host.get_proc_address = [](void* user, const char* name) {
        return static_cast<EglContext*>(user)->function(name);
    };
    host.is_current = [](void* user) { return std::int32_t{static_cast<EglContext*>(user)->is_current()}; };
    const auto options = without_cache(threads);
    made.context = create<Context>(nicol_context_create_host, &host, &options);
    return made;
}
