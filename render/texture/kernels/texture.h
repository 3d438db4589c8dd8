// Colours and reliefs of textures of every kind in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// What textures read of a SurfacePoint.
template <class L>
struct TexturePointOf {
    Three<typename L::Value> object_position;
    Three<typename L::Value> geometric_normal;
    Two<typename L::Value> uv;
    typename L::Value uv_per_metre;
    Two<typename L::Value> uv_metres;
};

/// The axis that a surface faces most: flat patterns are laid along the two others. Otherwise it
/// faces y.
template <class L>
struct FacedAxisOf {
    typename L::Mask is_x, is_z;  // not both
};

template <class L>
CAROM_KERNEL FacedAxisOf<L> facing_axis(const Three<typename L::Value>& normal) {
    const Three<typename L::Value> a{L::size(normal.x), L::size(normal.y), L::size(normal.z)};
    const auto is_z = L::both(L::is_at_most(a.x, a.z), L::is_at_most(a.y, a.z));
    return {L::both(L::opposite(is_z), L::is_at_most(a.y, a.x)), is_z};
}

template <class L>
CAROM_KERNEL Two<typename L::Value> flat_place(const Three<typename L::Value>& p,
                                               const FacedAxisOf<L>& axis) {
    return {L::select(axis.is_x, p.y, p.x), L::select(axis.is_z, p.y, p.z)};
}

/// The inverse of flat_place, in the plane through the origin.
template <class L>
CAROM_KERNEL Three<typename L::Value> lay_flat(const Two<typename L::Value>& v,
                                               const FacedAxisOf<L>& axis) {
    const auto zero = L::all(0);
    return {L::select(axis.is_x, zero, v.x),
            L::select(axis.is_x, v.x, L::select(axis.is_z, v.y, zero)),
            L::select(axis.is_z, zero, v.y)};
}

template <class L>
CAROM_KERNEL Three<typename L::Value> colour_at(const Imath::V3f& colour,
                                                const TexturePointOf<L>& /*point*/,
                                                typename L::Value /*footprint*/) {
    return all_of<L>(colour);
}

template <class L>
CAROM_KERNEL Three<typename L::Value> colour_at(const ImageParameters& image,
                                                const TexturePointOf<L>& point,
                                                typename L::Value footprint) {
    Two<typename L::Value> at = point.uv;
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

template <class L>
CAROM_KERNEL Three<typename L::Value> colour_at(const BallParameters& ball,
                                                const TexturePointOf<L>& point,
                                                typename L::Value footprint) {
    return ball_colour<L>(ball, point.object_position, footprint);
}

template <class L>
CAROM_KERNEL Three<typename L::Value> colour_at(const ClothParameters& cloth,
                                                const TexturePointOf<L>& point,
                                                typename L::Value footprint) {
    const FacedAxisOf<L> axis = facing_axis<L>(point.geometric_normal);
    return cloth_value<L>(cloth, flat_place<L>(point.object_position, axis), footprint).colour;
}

template <class L>
CAROM_KERNEL Three<typename L::Value> colour_at(const WoodParameters& wood,
                                                const TexturePointOf<L>& point,
                                                typename L::Value footprint) {
    return wood_colour<L>(wood, point.object_position, footprint);
}

template <class L>
CAROM_KERNEL Three<typename L::Value> colour_at(const CheckerParameters& checker,
                                                const TexturePointOf<L>& point,
                                                typename L::Value footprint) {
    return checker_colour<L>(checker, point.object_position, point.geometric_normal, footprint);
}

/// See Texture::colour. Without std::visit, whose functions have no attributes of an instruction
/// set. `kKind`: the first kind to try.
template <class L, std::size_t kKind = 0>
CAROM_KERNEL Three<typename L::Value> colour_of(const TextureData& texture,
                                                const TexturePointOf<L>& point,
                                                typename L::Value footprint) {
    if constexpr (kKind + 1 < std::variant_size_v<TextureData>) {
        if (texture.index() != kKind) {
            return colour_of<L, kKind + 1>(texture, point, footprint);
        }
    }
    return colour_at<L>(*std::get_if<kKind>(&texture), point, footprint);
}

template <class L>
struct TextureReliefOf {
    Three<typename L::Value> colour;
    Three<typename L::Value> normal_shift;
};

/// See Texture::relief. `texture`: of a Texture that has relief.
template <class L>
CAROM_KERNEL TextureReliefOf<L> relief_of(const TextureData& texture,
                                          const TexturePointOf<L>& point,
                                          typename L::Value footprint) {
    const ClothParameters* cloth = std::get_if<ClothParameters>(&texture);
    CAROM_ASSERT(cloth != nullptr);
    const FacedAxisOf<L> axis = facing_axis<L>(point.geometric_normal);
    const ClothValueOf<L> value =
        cloth_value<L>(*cloth, flat_place<L>(point.object_position, axis), footprint);
    const auto flat = lay_flat<L>(value.slope, axis);
    return {value.colour,
            {L::opposite_sign(flat.x), L::opposite_sign(flat.y), L::opposite_sign(flat.z)}};
}
