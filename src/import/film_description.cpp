// SPDX-License-Identifier: MIT
#include "import/film_description.hpp"

namespace nicol {
namespace {

// Returns the texture of with_film_thickness(). That of an image is one texture for all equal images.
TexturePtr thickness_of(const MaterialMaker& maker, const TextureSpecification& of) {
    if (of.kind != TextureSpecification::Kind::image) return film_texture(maker.textures.number(of));
    TextureSpecification image = of;
    image.factor *= kFilmRange;
    image.offset = kFilmRange * image.offset + kThinnestFilm;
    return maker.textures.number(image);
}

}  // namespace

MaterialPtr with_film(const MaterialMaker& maker, const FilmDescription& description,
                      const std::function<MaterialPtr(const FilmParameters&)>& make) {
    const FilmParameters film = film_in(description.film, maker.channels);
    if (description.thickness == nullptr) return make(film);
    return with_film_thickness(make, film, description.least, thickness_of(maker, *description.thickness));
}

}  // namespace nicol
