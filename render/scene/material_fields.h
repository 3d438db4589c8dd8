// The fields of materials and textures, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "render/scene/material_description.h"

namespace carom::render {

constexpr auto fields_of(Describes<ImageTexture>) {
    using T = ImageTexture;
    return fields<T>(file_field("file", &T::file), field("scale", &T::scale),
                     field("is_linear", &T::is_linear), field("size", &T::size),
                     field("offset", &T::offset), field("rotation", &T::rotation),
                     field("background", &T::background));
}

constexpr auto fields_of(Describes<BallTexture>) {
    using T = BallTexture;
    return fields<T>(field("colour", &T::colour), field("white", &T::white),
                     field("striped", &T::striped), field("number", &T::number),
                     field("disc_radius", &T::disc_radius), field("spots", &T::spots));
}

constexpr auto fields_of(Describes<ClothTexture>) {
    using T = ClothTexture;
    return fields<T>(field("colour", &T::colour), field("thread", &T::thread),
                     field("variation", &T::variation));
}

constexpr auto fields_of(Describes<WoodTexture>) {
    using T = WoodTexture;
    return fields<T>(field("light", &T::light), field("dark", &T::dark), field("ring", &T::ring),
                     field("grain", &T::grain));
}

constexpr auto fields_of(Describes<CheckerTexture>) {
    using T = CheckerTexture;
    return fields<T>(field("even", &T::even), field("odd", &T::odd), field("size", &T::size));
}

constexpr auto fields_of(Describes<Coat>) {
    return fields<Coat>(field("weight", &Coat::weight), field("ior", &Coat::ior),
                        field("roughness", &Coat::roughness));
}

constexpr auto fields_of(Describes<StandardMaterial>) {
    using T = StandardMaterial;
    return fields<T>(field("base", &T::base), field("metal", &T::metal),
                     field("roughness", &T::roughness), field("specular", &T::specular),
                     field("transmission", &T::transmission), field("ior", &T::ior),
                     field("transmission_colour", &T::transmission_colour),
                     field("transmission_depth", &T::transmission_depth), field("sheen", &T::sheen),
                     field("sheen_colour", &T::sheen_colour), field("bump", &T::bump),
                     field("coat", &T::coat), field("emission", &T::emission));
}

constexpr auto fields_of(Describes<PhongMaterial>) {
    using T = PhongMaterial;
    return fields<T>(field("ambient", &T::ambient), field("diffuse", &T::diffuse),
                     field("specular", &T::specular), field("shininess", &T::shininess),
                     field("reflectance", &T::reflectance),
                     field("reflectance_spread", &T::reflectance_spread),
                     field("transmittance", &T::transmittance),
                     field("transmittance_spread", &T::transmittance_spread),
                     field("index", &T::index), field("emission", &T::emission));
}

constexpr auto fields_of(Describes<MaterialDescription>) {
    using T = MaterialDescription;
    return fields<T>(unhashed("name", &T::name, "only mattes show it: frame_key adds it for them"),
                     field("surface", &T::surface), field("phong", &T::phong));
}

}  // namespace carom::render
