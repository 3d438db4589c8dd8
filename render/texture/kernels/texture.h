// Colours and reliefs of textures of every kind in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// What textures read of a SurfacePoint.
template <class L>
struct TexturePointOf {
    Vec3Of<L> object_position;
    Vec3Of<L> geometric_normal;
    Vec2Of<L> uv;
    ValueOf<L> uv_per_metre;
    Vec2Of<L> uv_metres;
};

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
CAROM_KERNEL Vec3Of<L> image_colour(const ImageParameters& image, const TexturePointOf<L>& point,
                                    ValueOf<L> footprint) {
    Vec2Of<L> at = point.uv;
    auto scale = point.uv_per_metre;
    if (image.by_size) {
        at = {at.x * point.uv_metres.x, at.y * point.uv_metres.y};
        scale = L::all(1);
    }
    const auto cosine = L::all(image.turn.x);
    const auto sine = L::all(image.turn.y);
    const auto x = (cosine * at.x + sine * at.y) * L::all(image.repeats.x) - L::all(image.offset.x);
    const auto y = (cosine * at.y - sine * at.x) * L::all(image.repeats.y) - L::all(image.offset.y);
    const auto most = L::larger(L::size(L::all(image.repeats.x)), L::size(L::all(image.repeats.y)));
    return look_up_image<L>(image.picture, {x, L::all(1) - y}, footprint * most * scale);
}

/// The colour of a texture, not yet limited to [0, 1]. `footprint`: width of a pixel, m.
template <class L>
CAROM_KERNEL Vec3Of<L> colour_of(const TextureData& texture, const TexturePointOf<L>& point,
                                 ValueOf<L> footprint) {
    const Vec3Of<L>& place = point.object_position;
    switch (texture.kind) {
        case TextureKind::image:
            return image_colour<L>(texture.image, point, footprint);
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
                                          const TexturePointOf<L>& point, ValueOf<L> footprint) {
    const FacedAxisOf<L> axis = facing_axis<L>(point.geometric_normal);
    const ClothValueOf<L> value =
        cloth_value<L>(texture.cloth, flat_place<L>(point.object_position, axis), footprint);
    const auto flat = lay_flat<L>(value.slope, axis);
    return {value.colour,
            {L::opposite_sign(flat.x), L::opposite_sign(flat.y), L::opposite_sign(flat.z)}};
}
