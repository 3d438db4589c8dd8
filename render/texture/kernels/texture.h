// Colours and reliefs of textures of every kind in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// What textures read of a SurfacePoint.
template <class L>
struct TexturePointOf {
    Vec3Of<L> object_position;
    Vec3Of<L> geometric_normal;
    Vec2Of<L> uv;
    Vec2Of<L> uv_metres;
    ValueOf<L> footprint;     // width of a pixel on the surface, m; of the square of the same area
    Vec2Of<L> along, across;  // uv over the pixel, along the ray's projection and across it
};

/// `width`: of a pixel across the ray. `wo`: towards the viewer. `least`: of the cosine to the
/// normal that counts.
template <class L>
CAROM_KERNEL TexturePointOf<L> texture_point(const SurfacePointOf<L>& point, bool needs_uv,
                                             const Vec3Of<L>& wo, ValueOf<L> width,
                                             ValueOf<L> least) {
    const auto zero = L::all(0);
    const Vec3Of<L>& normal = point.geometric_normal;
    const auto towards = dot(normal, wo);
    const auto cosine = L::larger(L::size(towards), least);
    TexturePointOf<L> textured{point.object_position,   normal,       point.uv,    point.uv_metres,
                               width / L::root(cosine), {zero, zero}, {zero, zero}};
    if (needs_uv) {
        const Vec3Of<L> projected = wo - normal * towards;
        const auto length = L::root(dot(projected, projected));
        // Seen from straight above, any direction does: that in which u grows.
        const auto is_slanted = L::is_less(L::all(1e-4f), length);
        const auto steepest = L::root(dot(point.u_gradient, point.u_gradient));
        const auto has_u = L::is_less(zero, steepest);
        const Vec3Of<L> direction = select<L>(
            is_slanted, projected * (L::all(1) / L::select(is_slanted, length, L::all(1))),
            point.u_gradient * (L::all(1) / L::select(has_u, steepest, L::all(1))));
        const Vec3Of<L> beside = cross(normal, direction);
        const auto over = [&](const Vec3Of<L>& way, ValueOf<L> metres) CAROM_KERNEL_ATTRIBUTE {
            return Vec2Of<L>{dot(point.u_gradient, way) * metres,
                             dot(point.v_gradient, way) * metres};
        };
        textured.along = over(direction, width / cosine);
        textured.across = over(beside, width);
    }
    return textured;
}

/// The axis that a surface faces most: flat patterns are laid along the two others. Otherwise it
/// faces y.
template <class L>
struct FacedAxisOf {
    MaskOf<L> is_x, is_z;  // not both
};

template <class L>
CAROM_KERNEL FacedAxisOf<L> facing_axis(const Vec3Of<L>& normal) {
    const Vec3Of<L> a{L::size(normal.x), L::size(normal.y), L::size(normal.z)};
    const auto is_z = L::both(L::is_at_most(a.x, a.z), L::is_at_most(a.y, a.z));
    return {L::both(L::opposite(is_z), L::is_at_most(a.y, a.x)), is_z};
}

template <class L>
CAROM_KERNEL Vec2Of<L> flat_place(const Vec3Of<L>& p, const FacedAxisOf<L>& axis) {
    return {L::select(axis.is_x, p.y, p.x), L::select(axis.is_z, p.y, p.z)};
}

/// The inverse of flat_place, in the plane through the origin.
template <class L>
CAROM_KERNEL Vec3Of<L> lay_flat(const Vec2Of<L>& v, const FacedAxisOf<L>& axis) {
    const auto zero = L::all(0);
    return {L::select(axis.is_x, zero, v.x),
            L::select(axis.is_x, v.x, L::select(axis.is_z, v.y, zero)),
            L::select(axis.is_z, zero, v.y)};
}

template <class L>
CAROM_KERNEL Vec3Of<L> image_colour(const ImageParameters& image, const TexturePointOf<L>& point) {
    const auto scaled = [&](const Vec2Of<L>& uv) CAROM_KERNEL_ATTRIBUTE {
        return image.by_size ? Vec2Of<L>{uv.x * point.uv_metres.x, uv.y * point.uv_metres.y} : uv;
    };
    const auto cosine = L::all(image.turn.x);
    const auto sine = L::all(image.turn.y);
    // Rows of the picture run down.
    const auto in_picture = [&](const Vec2Of<L>& uv) CAROM_KERNEL_ATTRIBUTE {
        const Vec2Of<L> at = scaled(uv);
        return Vec2Of<L>{(cosine * at.x + sine * at.y) * L::all(image.repeats.x),
                         (sine * at.x - cosine * at.y) * L::all(image.repeats.y)};
    };
    const Vec2Of<L> place = in_picture(point.uv);
    return look_up_image<L>(image.picture, {{place.x - L::all(image.offset.x),
                                             L::all(1) + place.y + L::all(image.offset.y)},
                                            in_picture(point.along),
                                            in_picture(point.across)});
}

/// The colour of a texture, not yet limited to [0, 1].
template <class L>
CAROM_KERNEL Vec3Of<L> colour_of(const TextureData& texture, const TexturePointOf<L>& point) {
    const Vec3Of<L>& place = point.object_position;
    const auto footprint = point.footprint;
    switch (texture.kind) {
        case TextureKind::image:
            return image_colour<L>(texture.image, point);
        case TextureKind::ball:
            return ball_colour<L>(texture.ball, place, footprint);
        case TextureKind::cloth:
            return cloth_value<L>(texture.cloth,
                                  flat_place<L>(place, facing_axis<L>(point.geometric_normal)),
                                  footprint)
                .colour;
        case TextureKind::wood:
            return wood_colour<L>(texture.wood, place, footprint);
        case TextureKind::checker:
            return checker_colour<L>(texture.checker, place, point.geometric_normal, footprint);
        case TextureKind::plain:
            break;
    }
    return all_of<L>(texture.plain);
}

template <class L>
struct TextureReliefOf {
    Vec3Of<L> colour;
    Vec3Of<L> normal_shift;
};

/// `texture`: of a Texture that has relief.
template <class L>
CAROM_KERNEL TextureReliefOf<L> relief_of(const TextureData& texture,
                                          const TexturePointOf<L>& point) {
    const FacedAxisOf<L> axis = facing_axis<L>(point.geometric_normal);
    const ClothValueOf<L> value =
        cloth_value<L>(texture.cloth, flat_place<L>(point.object_position, axis), point.footprint);
    const auto flat = lay_flat<L>(value.slope, axis);
    return {value.colour,
            {L::opposite_sign(flat.x), L::opposite_sign(flat.y), L::opposite_sign(flat.z)}};
}
