// The surface that a material gives at a point, in lanes. Included as
// render/lanes/kernels/vectors.h is.

template <class L>
struct ResolvedOf {
    // On the viewer's side.
    Vec3Of<L> geometric_normal, normal;
    Vec3Of<L> base;
    MaskOf<L> from_behind;
    ValueOf<L> numbers[kTexturedNumbers];  // set if they vary; of roughness GGX's alpha
};

template <class L>
CAROM_KERNEL Vec3Of<L> flipped(MaskOf<L> flips, const Vec3Of<L>& v) {
    return {L::select(flips, L::opposite_sign(v.x), v.x),
            L::select(flips, L::opposite_sign(v.y), v.y),
            L::select(flips, L::opposite_sign(v.z), v.z)};
}

/// GGX's alpha of a roughness where `variance` of the normals is added to it: the slopes of
/// Beckmann's facets, which GGX's resemble, have a variance of alpha^2 / 2 in each direction.
template <class L>
CAROM_KERNEL ValueOf<L> widened_alpha(ValueOf<L> roughness, ValueOf<L> variance) {
    const auto square = roughness * roughness;
    const auto alpha = L::smaller(L::root(square * square + variance), L::all(1));
    return L::select(L::is_less(alpha, L::all(kSmoothAlpha)), L::all(0), alpha);
}

/// A number of a material, as layers have it, that does not vary.
template <class L>
CAROM_KERNEL ValueOf<L> constant_number(const MaterialTextures& textures, int number) {
    const auto value = L::all(textures.numbers[number].at_zero);
    const bool is_roughness = number == kRoughness || number == kCoatRoughness;
    return is_roughness ? widened_alpha<L>(value, L::all(0)) : value;
}

/// The relief of textures that are not pictures: from their heights half a pixel away.
template <class L>
CAROM_KERNEL Vec3Of<L> shift_by_differences(const List<TextureData>& list,
                                            const MaterialTextures& textures,
                                            const TexturePointOf<L>& point,
                                            TextureValueOf<L>* values) {
    const ReliefParameters& relief = textures.relief;
    const auto height_at = [&](const TexturePointOf<L>& place) CAROM_KERNEL_ATTRIBUTE {
        evaluate<L>(list, textures, relief.first, relief.last, place, values);
        return number_of<L>(relief.height, values) * L::all(relief.strength);
    };
    const auto here = height_at(point);
    const auto along_side = [&](const Vec2Of<L>& side,
                                const Vec3Of<L>& way) CAROM_KERNEL_ATTRIBUTE {
        const auto rise = height_at(point.moved(side, way)) - here;
        // Over half of the way; its square is of the order of a pixel's.
        return way * (L::all(-2) * rise / L::larger(dot(way, way), L::all(1e-20f)));
    };
    return along_side(point.along, point.way_along) + along_side(point.across, point.way_across);
}

/// What the textures of a material say about a surface.
template <class L>
struct TexturedSurfaceOf {
    Vec3Of<L> base, normal_shift;
    ValueOf<L> numbers[kTexturedNumbers];
};

template <class L>
CAROM_KERNEL_OUTLINED TexturedSurfaceOf<L> resolve_textures(const List<TextureData>& list,
                                                            const MaterialTextures& textures,
                                                            const TexturePointOf<L>& point) {
    const auto zero = L::all(0);
    TextureValueOf<L> values[MaterialTextures::kMost];
    evaluate<L>(list, textures, 0, textures.of_surface, point, values);
    TextureReliefOf<L> relief{{zero, zero, zero}, {zero, zero, zero}, zero};
    const TextureData& base = list[textures.first + textures.base];
    switch (textures.relief.kind) {
        case ReliefParameters::Kind::own:
            relief = relief_of_cloth<L>(base, point);
            relief.normal_shift = relief.normal_shift * L::all(textures.relief.strength);
            break;
        case ReliefParameters::Kind::slopes:
            relief = relief_of_slopes<L>(list[textures.first + textures.relief.texture], point,
                                         values[textures.relief.texture].colour,
                                         textures.relief.strength);
            break;
        case ReliefParameters::Kind::differences:
            relief.normal_shift = shift_by_differences<L>(list, textures, point, values);
            break;
        case ReliefParameters::Kind::none:
            break;
    }
    TexturedSurfaceOf<L> surface;
    surface.base = values[textures.base].colour;
    surface.normal_shift = relief.normal_shift;
    for (int k = 0; k < kTexturedNumbers; ++k) {
        auto number = limited<L>(number_of<L>(textures.numbers[k], values), 0, 1);
        if (k == kRoughness || k == kCoatRoughness) {
            number = widened_alpha<L>(number, relief.variance);
        }
        surface.numbers[k] = number;
    }
    return surface;
}

/// Fibres of a nap lean towards x of the cloth: from there one sees their tips, from the other end
/// their sides. `wo`: towards the viewer.
template <class L>
CAROM_KERNEL ValueOf<L> nap_brightness(const ClothParameters& cloth, const TexturePointOf<L>& point,
                                       const Vec3Of<L>& wo) {
    const auto against = point.in_object(wo).x;
    return L::all(1) + L::all(cloth.brightness_along_nap) * against;
}

/// All lanes have the same material.
template <class L>
CAROM_KERNEL ResolvedOf<L> resolve_surface(const List<TextureData>& list,
                                           const MaterialTextures& textures,
                                           const TexturePointOf<L>& point,
                                           const Vec3Of<L>& geometric_normal,
                                           const Vec3Of<L>& shading_normal, const Vec3Of<L>& wo) {
    const auto zero = L::all(0);
    ResolvedOf<L> surface;
    surface.from_behind = L::is_less(dot(geometric_normal, wo), zero);
    surface.geometric_normal = flipped<L>(surface.from_behind, geometric_normal);
    Vec3Of<L> normal = flipped<L>(surface.from_behind, shading_normal);
    Vec3Of<L> shift{zero, zero, zero};
    const TextureData& base = list[textures.first + textures.base];
    if (!textures.only_base) {
        const TexturedSurfaceOf<L> textured = resolve_textures<L>(list, textures, point);
        surface.base = textured.base;
        shift = textured.normal_shift;
        for (int k = 0; k < kTexturedNumbers; ++k) {
            surface.numbers[k] = textured.numbers[k];
        }
    } else if (textures.relief.kind == ReliefParameters::Kind::own) {
        const TextureReliefOf<L> relief = relief_of_cloth<L>(base, point);
        surface.base = relief.colour;
        shift = relief.normal_shift * L::all(textures.relief.strength);
    } else if (base.kind == TextureKind::plain) {
        surface.base = all_of<L>(base.plain);
    } else {
        surface.base = value_of<L>(base, point, nullptr).colour;
    }
    if (base.kind == TextureKind::cloth && base.cloth.brightness_along_nap != 0) {
        surface.base = surface.base * nap_brightness<L>(base.cloth, point, wo);
    }
    if (textures.relief.kind != ReliefParameters::Kind::none) {
        shift = flipped<L>(surface.from_behind, shift);
        normal = unit<L>(normal + shift - normal * dot(normal, shift));
    }
    surface.base = {limited<L>(surface.base.x, 0, 1), limited<L>(surface.base.y, 0, 1),
                    limited<L>(surface.base.z, 0, 1)};
    // The smooth or bumped normal may face away from the viewer.
    const auto faces_away = L::is_at_most(dot(normal, wo), zero);
    surface.normal = select<L>(faces_away, surface.geometric_normal, normal);
    return surface;
}
