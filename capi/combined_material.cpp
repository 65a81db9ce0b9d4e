// SPDX-License-Identifier: MIT
// Materials that are made of other ones.
#include "assets.hpp"
#include "material/mixture.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

// Makes a material of another one: make(base, context).
template <class Make>
nicol_result create_of(nicol_context context, nicol_material base, nicol_material* material, Make&& make,
                       const char* function = __builtin_FUNCTION()) {
    return guarded(
        [&] {
            require(material, "material");
            const nicol_context_impl session = resolve(context);
            const nicol_material_impl of = resolve(base);
            require_same_context(session, of);
            *material = make_handle<nicol_material_impl>(session.session, make(of.content, session));
        },
        function);
}

// Makes a material of another one and a texture: combine(base, texture).
template <class Combine>
nicol_result create_textured(nicol_context context, nicol_material base, nicol_texture texture,
                             nicol_material* material, Combine&& combine,
                             const char* function = __builtin_FUNCTION()) {
    return create_of(
        context, base, material,
        [&](const MaterialPtr& of, const nicol_context_impl& session) {
            const nicol_texture_impl by = resolve(texture);
            require_same_context(session, by);
            return combine(of, by.content);
        },
        function);
}

}  // namespace

nicol_result nicol_material_create_twosided(nicol_context context, nicol_material front,
                                            nicol_material* material) {
    return create_of(context, front, material,
                     [](const MaterialPtr& of, const nicol_context_impl&) { return twosided(of); });
}

nicol_result nicol_material_create_scaled(nicol_context context, nicol_material base, nicol_texture scale,
                                          nicol_material* material) {
    return create_textured(context, base, scale, material, scaled);
}

nicol_result nicol_material_create_blend(nicol_context context, nicol_material first, nicol_material second,
                                         nicol_texture weight, nicol_material* material) {
    return create_textured(context, first, weight, material, [&](const MaterialPtr& a, const TexturePtr& t) {
        const nicol_material_impl other = resolve(second);
        require_same_context(resolve(context), other);
        return blend(a, other.content, t);
    });
}

nicol_result nicol_material_create_normal_map(nicol_context context, nicol_material base,
                                              nicol_texture normals, uint32_t mirrored_y,
                                              nicol_material* material) {
    return create_textured(context, base, normals, material, [&](MaterialPtr of, TexturePtr by) {
        return normal_mapped(std::move(of), std::move(by),
                             {.mirrored_y = switch_from(mirrored_y, "mirrored_y")});
    });
}

nicol_result nicol_material_create_bump_map(nicol_context context, nicol_material base, nicol_texture heights,
                                            double scale, nicol_material* material) {
    return create_textured(context, base, heights, material, [&](MaterialPtr of, TexturePtr by) {
        return bump_mapped(std::move(of), std::move(by), scale);
    });
}

nicol_result nicol_material_create_rotated(nicol_context context, nicol_material base,
                                           nicol_texture directions, double angle, nicol_material* material) {
    return create_of(context, base, material, [&](const MaterialPtr& of, const nicol_context_impl& session) {
        return rotated(of, texture_of(directions, session), angle);
    });
}

nicol_result nicol_material_create_mask(nicol_context context, nicol_material base, nicol_texture opacity,
                                        nicol_material* material) {
    return create_textured(context, base, opacity, material, [](MaterialPtr of, TexturePtr by) {
        return masked(std::move(of), std::move(by));
    });
}
