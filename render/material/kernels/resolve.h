// The surface that a material gives at a point (Material::resolve), in lanes. Included as
// render/lanes/kernels/vectors.h is.

template <class L>
struct ResolvedOf {
    // On the viewer's side.
    Vec3Of<L> geometric_normal, normal;
    Vec3Of<L> base;
    MaskOf<L> from_behind;
};

template <class L>
CAROM_KERNEL Vec3Of<L> flipped(MaskOf<L> flips, const Vec3Of<L>& v) {
    return {L::select(flips, L::opposite_sign(v.x), v.x),
            L::select(flips, L::opposite_sign(v.y), v.y),
            L::select(flips, L::opposite_sign(v.z), v.z)};
}

/// All lanes have the same material. `wo`: towards the viewer.
template <class L>
CAROM_KERNEL ResolvedOf<L> resolve_surface(const TextureData& texture, float bump,
                                           const TexturePointOf<L>& point,
                                           const Vec3Of<L>& shading_normal, const Vec3Of<L>& wo) {
    ResolvedOf<L> surface;
    surface.from_behind = L::is_less(dot(point.geometric_normal, wo), L::all(0));
    surface.geometric_normal = flipped<L>(surface.from_behind, point.geometric_normal);
    Vec3Of<L> normal = flipped<L>(surface.from_behind, shading_normal);
    Vec3Of<L> colour;
    if (bump > 0) {
        const TextureReliefOf<L> relief = relief_of<L>(texture, point);
        const Vec3Of<L> shift = relief.normal_shift * L::all(bump);
        colour = relief.colour;
        normal = unit<L>(normal + shift - normal * dot(normal, shift));
    } else {
        colour = colour_of<L>(texture, point);
    }
    surface.base = {limited<L>(colour.x, 0, 1), limited<L>(colour.y, 0, 1),
                    limited<L>(colour.z, 0, 1)};
    // The smooth or bumped normal may face away from the viewer.
    const auto faces_away = L::is_at_most(dot(normal, wo), L::all(0));
    surface.normal = select<L>(faces_away, surface.geometric_normal, normal);
    return surface;
}
