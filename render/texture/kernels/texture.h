// Colours and reliefs of textures of every kind in lanes. Included as
// render/lanes/kernels/vectors.h is.

#include "render/texture/kernels/ball_paint.h"
#include "render/texture/kernels/checker.h"
#include "render/texture/kernels/cloth.h"
#include "render/texture/kernels/smudges.h"
#include "render/texture/kernels/wood.h"

/// What textures read of a SurfacePoint. The last ones are set as far as they are needed.
template <class L>
struct TexturePointOf {
    Vec3Of<L> object_position;
    Vec3Of<L> geometric_normal;  // in the object's axes, if these are needed
    Vec2Of<L> uv;
    Vec2Of<L> uv_metres;
    ValueOf<L> footprint;     // width of a pixel on the surface, m; of the square of the same area
    Vec2Of<L> along, across;  // uv over the pixel, along the ray's projection and across it
    Vec3Of<L> way_along, way_across;  // the pixel's sides in the world, m
    Vec3Of<L> u_gradient, v_gradient;
    Vec3Of<L> x_axis, y_axis, z_axis;
    bool has_axes;  // otherwise they are the world's

    [[nodiscard]] CAROM_KERNEL Vec3Of<L> in_object(const Vec3Of<L>& v) const {
        if (!has_axes) {
            return v;
        }
        return {dot(x_axis, v), dot(y_axis, v), dot(z_axis, v)};
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> in_world(const Vec3Of<L>& v) const {
        if (!has_axes) {
            return v;
        }
        return x_axis * v.x + y_axis * v.y + z_axis * v.z;
    }
    /// Half a pixel further.
    [[nodiscard]] CAROM_KERNEL TexturePointOf moved(const Vec2Of<L>& side,
                                                    const Vec3Of<L>& way) const {
        const auto part = L::all(0.5f);
        TexturePointOf point = *this;
        point.uv = {uv.x + side.x * part, uv.y + side.y * part};
        point.object_position = object_position + in_object(way) * part;
        return point;
    }
};

/// `width`: of a pixel across the ray. `wo`: towards the viewer. `least`: of the cosine to the
/// normal that counts.
template <class L>
CAROM_KERNEL TexturePointOf<L> texture_point(const SurfacePointOf<L>& point,
                                             const TextureNeeds& needs, const Vec3Of<L>& wo,
                                             ValueOf<L> width, ValueOf<L> least) {
    const auto zero = L::all(0);
    const Vec3Of<L>& normal = point.geometric_normal;
    const auto towards = dot(normal, wo);
    const auto cosine = L::larger(L::size(towards), least);
    TexturePointOf<L> textured;
    textured.object_position = point.object_position;
    textured.geometric_normal = normal;
    textured.uv = point.uv;
    textured.uv_metres = point.uv_metres;
    textured.footprint = width / L::root(cosine);
    textured.along = textured.across = {zero, zero};
    textured.has_axes = needs.axes;
    if (needs.axes) {
        textured.x_axis = point.x_axis;
        textured.y_axis = point.y_axis;
        textured.z_axis = point.z_axis;
        textured.geometric_normal = textured.in_object(normal);
    }
    if (!needs.uv && !needs.sides) {
        return textured;
    }
    const Vec3Of<L> projected = wo - normal * towards;
    const auto length = L::root(dot(projected, projected));
    // Seen from straight above, any direction does: that in which u grows.
    const auto is_slanted = L::is_less(L::all(1e-4f), length);
    Vec3Of<L> any;
    if (needs.uv) {
        const auto steepest = L::root(dot(point.u_gradient, point.u_gradient));
        const auto has_u = L::is_less(zero, steepest);
        any = point.u_gradient * (L::all(1) / L::select(has_u, steepest, L::all(1)));
    } else {
        any = basis_around<L>(normal).x;
    }
    const Vec3Of<L> direction = select<L>(
        is_slanted, projected * (L::all(1) / L::select(is_slanted, length, L::all(1))), any);
    const Vec3Of<L> beside = cross(normal, direction);
    const auto over = [&](const Vec3Of<L>& way, ValueOf<L> metres) CAROM_KERNEL_ATTRIBUTE {
        return Vec2Of<L>{dot(point.u_gradient, way) * metres, dot(point.v_gradient, way) * metres};
    };
    if (needs.uv) {
        textured.along = over(direction, width / cosine);
        textured.across = over(beside, width);
        textured.u_gradient = point.u_gradient;
        textured.v_gradient = point.v_gradient;
    }
    if (needs.sides) {
        textured.way_along = direction * (width / cosine);
        textured.way_across = beside * width;
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

/// The plane in which a texture lies: the place on it, how that changes over the pixel, and its
/// gradients in the world.
template <class L>
struct TexturePlaneOf {
    Vec2Of<L> at;
    Vec2Of<L> metres;  // length of 1 in both directions, m
    Vec2Of<L> along, across;
    Vec3Of<L> x_gradient, y_gradient;  // 1/m
};

/// `placement`: not of a pattern in the object's own axes.
template <class L>
CAROM_KERNEL TexturePlaneOf<L> plane_of(const PlacementParameters& placement,
                                        const TexturePointOf<L>& point) {
    const auto one = L::all(1);
    const auto zero = L::all(0);
    if (placement.mapping == Mapping::own || placement.mapping == Mapping::uv) {
        return {point.uv,     point.uv_metres,  point.along,
                point.across, point.u_gradient, point.v_gradient};
    }
    const Vec3Of<L>& place = point.object_position;
    TexturePlaneOf<L> plane;
    plane.metres = {one, one};
    // The gradients in the object's axes.
    Vec3Of<L> right = all_of<L>(placement.right);
    Vec3Of<L> up = all_of<L>(placement.up);
    if (placement.mapping == Mapping::spherical) {
        const auto radius = L::root(L::larger(dot(place, place), L::all(1e-20f)));
        const LongitudeGradientsOf<L> gradients(place * (one / radius), radius);
        right = gradients.u;
        up = gradients.v;
        plane.at = longitude_latitude<L>(place);
        plane.metres = {L::all(kTurn) * radius, L::all(0.5f * kTurn) * radius};
    } else {
        if (placement.mapping == Mapping::box) {
            const FacedAxisOf<L> axis = facing_axis<L>(point.geometric_normal);
            right = lay_flat<L>({one, zero}, axis);
            up = lay_flat<L>({zero, one}, axis);
        }
        plane.at = {dot(right, place), dot(up, place)};
    }
    plane.x_gradient = point.in_world(right);
    plane.y_gradient = point.in_world(up);
    const auto over = [&](const Vec3Of<L>& way) CAROM_KERNEL_ATTRIBUTE {
        return Vec2Of<L>{dot(plane.x_gradient, way), dot(plane.y_gradient, way)};
    };
    plane.along = over(point.way_along);
    plane.across = over(point.way_across);
    return plane;
}

/// A place turned with a texture. `turn`: as PlacementParameters has it.
template <class L>
CAROM_KERNEL Vec2Of<L> turned_back(const V2f& turn, ValueOf<L> x, ValueOf<L> y) {
    const auto cosine = L::all(turn.x);
    const auto sine = L::all(turn.y);
    return {cosine * x + sine * y, cosine * y - sine * x};
}

/// A picture over a pixel, and the gradients of its own two coordinates, which grow to the right
/// and upwards by 1 over the picture.
template <class L>
struct PictureViewOf {
    PixelOf<L> pixel;
    Vec3Of<L> x_gradient, y_gradient;
};

template <class L>
CAROM_KERNEL PictureViewOf<L> view_of_picture(const TextureData& texture,
                                              const TexturePointOf<L>& point) {
    const ImageParameters& image = texture.image;
    const PlacementParameters& placement = texture.placement;
    const TexturePlaneOf<L> plane = plane_of<L>(placement, point);
    // Rows of the picture run down.
    const auto in_picture = [&](const Vec2Of<L>& v) CAROM_KERNEL_ATTRIBUTE {
        const auto x = image.by_size ? v.x * plane.metres.x : v.x;
        const auto y = image.by_size ? v.y * plane.metres.y : v.y;
        const auto cosine = L::all(placement.turn.x);
        const auto sine = L::all(placement.turn.y);
        return Vec2Of<L>{(cosine * x + sine * y) * L::all(image.repeats.x),
                         (sine * x - cosine * y) * L::all(image.repeats.y)};
    };
    const Vec2Of<L> place = in_picture(plane.at);
    PictureViewOf<L> view;
    view.pixel = {{place.x - L::all(image.offset.x), L::all(1) + place.y + L::all(image.offset.y)},
                  in_picture(plane.along),
                  in_picture(plane.across)};
    Vec3Of<L> x = plane.x_gradient;
    Vec3Of<L> y = plane.y_gradient;
    if (image.by_size) {
        x = x * plane.metres.x;
        y = y * plane.metres.y;
    }
    const auto cosine = L::all(placement.turn.x);
    const auto sine = L::all(placement.turn.y);
    view.x_gradient = (x * cosine + y * sine) * L::all(image.repeats.x);
    view.y_gradient = (y * cosine - x * sine) * L::all(image.repeats.y);
    return view;
}

template <class L>
CAROM_KERNEL TextureValueOf<L> image_value(const TextureData& texture,
                                           const TexturePointOf<L>& point) {
    const ImageParameters& image = texture.image;
    TextureValueOf<L> value =
        look_up_image<L>(image.picture, view_of_picture<L>(texture, point).pixel);
    if (image.picture.has_alpha) {
        if (image.is_bare) {
            const auto is_seen = L::is_less(L::all(1e-4f), value.alpha);
            const auto scale = L::all(1) / L::select(is_seen, value.alpha, L::all(1));
            value.colour = value.colour * scale;
        } else {
            value.colour = value.colour + all_of<L>(image.background) * (L::all(1) - value.alpha);
        }
    }
    value.colour = value.colour * all_of<L>(image.tint);
    return value;
}

/// Where a pattern in space or on a plane (its third coordinate is 0) is asked for.
template <class L>
struct PatternPlaceOf {
    Vec3Of<L> place, normal;
};

template <class L>
CAROM_KERNEL PatternPlaceOf<L> pattern_place(const PlacementParameters& placement,
                                             const TexturePointOf<L>& point) {
    PatternPlaceOf<L> at{point.object_position, point.geometric_normal};
    if (placement.mapping != Mapping::own) {
        const TexturePlaneOf<L> plane = plane_of<L>(placement, point);
        at.place = {plane.at.x * plane.metres.x, plane.at.y * plane.metres.y, L::all(0)};
        at.normal = {L::all(0), L::all(0), L::all(1)};
    }
    if (placement.turn.y != 0 || placement.turn.x < 0) {
        const Vec2Of<L> place = turned_back<L>(placement.turn, at.place.x, at.place.y);
        const Vec2Of<L> normal = turned_back<L>(placement.turn, at.normal.x, at.normal.y);
        at.place = {place.x, place.y, at.place.z};
        at.normal = {normal.x, normal.y, at.normal.z};
    }
    return at;
}

template <class L>
CAROM_KERNEL ClothValueOf<L> cloth_at(const TextureData& texture, const PatternPlaceOf<L>& at,
                                      const FacedAxisOf<L>& axis, ValueOf<L> footprint) {
    return cloth_value<L>(texture.cloth, flat_place<L>(at.place, axis), footprint);
}

/// What a channel of a texture's value gives; not `automatic`.
template <class L>
CAROM_KERNEL ValueOf<L> part_of(const TextureValueOf<L>& value, PictureChannel channel) {
    switch (channel) {
        case PictureChannel::red:
            return value.colour.x;
        case PictureChannel::green:
            return value.colour.y;
        case PictureChannel::blue:
            return value.colour.z;
        case PictureChannel::alpha:
            return value.alpha;
        default:
            return luminance_of<L>(value.colour);
    }
}

template <class L>
CAROM_KERNEL ValueOf<L> number_of(const NumberPick& pick, const TextureValueOf<L>* values) {
    if (pick.texture < 0) {
        return L::all(pick.at_zero);
    }
    const auto number = part_of<L>(values[pick.texture], pick.channel);
    return L::all(pick.at_zero) + number * L::all(pick.at_one - pick.at_zero);
}

/// The colour of a texture, not yet limited to [0, 1], and its alpha; of pictures of slopes what
/// relief_picture.h says. `values`: of the textures before it in its list.
template <class L>
CAROM_KERNEL_OUTLINED TextureValueOf<L> value_of(const TextureData& texture,
                                                 const TexturePointOf<L>& point,
                                                 const TextureValueOf<L>* values) {
    const auto footprint = point.footprint;
    TextureValueOf<L> value{all_of<L>(texture.plain), L::all(1)};
    switch (texture.kind) {
        case TextureKind::image:
        case TextureKind::normals:
        case TextureKind::heights:
            value = image_value<L>(texture, point);
            break;
        case TextureKind::ball:
            value.colour = ball_colour<L>(texture.ball, point.object_position, footprint);
            break;
        case TextureKind::cloth: {
            const PatternPlaceOf<L> at = pattern_place<L>(texture.placement, point);
            value.colour = cloth_at<L>(texture, at, facing_axis<L>(at.normal), footprint).colour;
            break;
        }
        case TextureKind::wood:
            value.colour = wood_colour<L>(
                texture.wood, pattern_place<L>(texture.placement, point).place, footprint);
            break;
        case TextureKind::checker: {
            const PatternPlaceOf<L> at = pattern_place<L>(texture.placement, point);
            value.colour = checker_colour<L>(texture.checker, at.place, at.normal, footprint);
            break;
        }
        case TextureKind::smudges: {
            const auto grey = smudges_value<L>(texture.smudges, point.object_position, footprint);
            value.colour = {grey, grey, grey};
            break;
        }
        case TextureKind::mix: {
            const auto by = limited<L>(number_of<L>(texture.mix.by, values), 0, 1);
            const TextureValueOf<L>& a = values[texture.mix.a];
            const TextureValueOf<L>& b = values[texture.mix.b];
            value = {a.colour + (b.colour - a.colour) * by, a.alpha + (b.alpha - a.alpha) * by};
            break;
        }
        case TextureKind::plain:
            break;
    }
    return value;
}

/// Evaluates the textures [first, last) of a material's list.
template <class L>
CAROM_KERNEL void evaluate(const List<TextureData>& list, const MaterialTextures& textures,
                           int first, int last, const TexturePointOf<L>& point,
                           TextureValueOf<L>* values) {
    for (int i = first; i < last; ++i) {
        values[i] = value_of<L>(list[textures.first + i], point, values);
    }
}

/// How a relief turns the normal: what is added to it, and the mean square of what a pixel cannot
/// show of that.
template <class L>
struct TextureReliefOf {
    Vec3Of<L> colour;  // of a cloth
    Vec3Of<L> normal_shift;
    ValueOf<L> variance;
};

/// Of a cloth's own relief, with its colour.
template <class L>
CAROM_KERNEL TextureReliefOf<L> relief_of_cloth(const TextureData& texture,
                                                const TexturePointOf<L>& point) {
    const PlacementParameters& placement = texture.placement;
    const PatternPlaceOf<L> at = pattern_place<L>(placement, point);
    const FacedAxisOf<L> axis = facing_axis<L>(at.normal);
    const ClothValueOf<L> value = cloth_at<L>(texture, at, axis, point.footprint);
    Vec3Of<L> flat = lay_flat<L>(value.slope, axis);
    const Vec2Of<L> back = turned_back<L>({placement.turn.x, -placement.turn.y}, flat.x, flat.y);
    flat = {back.x, back.y, flat.z};
    if (placement.mapping == Mapping::own) {
        flat = point.in_world(flat);
    } else {
        const TexturePlaneOf<L> plane = plane_of<L>(placement, point);
        flat = plane.x_gradient * (flat.x * plane.metres.x) +
               plane.y_gradient * (flat.y * plane.metres.y);
    }
    return {value.colour,
            {L::opposite_sign(flat.x), L::opposite_sign(flat.y), L::opposite_sign(flat.z)},
            L::all(0)};
}

/// Of a picture's slopes, whose value is known. What a pixel does not show of them becomes gloss
/// (Olano and Baker 2010, "LEAN mapping", for lobes that are alike in all directions).
template <class L>
CAROM_KERNEL TextureReliefOf<L> relief_of_slopes(const TextureData& texture,
                                                 const TexturePointOf<L>& point,
                                                 const Vec3Of<L>& slopes, float strength) {
    const PictureViewOf<L> view = view_of_picture<L>(texture, point);
    const auto zero = L::all(0);
    const auto length_of = [](const Vec3Of<L>& v) CAROM_KERNEL_ATTRIBUTE {
        return L::root(L::larger(dot(v, v), L::all(1e-30f)));
    };
    auto x = L::all(strength) / length_of(view.x_gradient);
    auto y = L::all(strength) / length_of(view.y_gradient);
    const auto size = length_of(view.x_gradient) * length_of(view.y_gradient);
    auto square = L::all(strength * strength);
    if (texture.kind == TextureKind::heights) {
        const float width = static_cast<float>(texture.image.picture.width);
        const float height = static_cast<float>(texture.image.picture.height);
        x = L::all(strength * width);
        y = L::all(strength * height);
        square = square * size * L::all(width * height);
    }
    const auto spread = L::larger(slopes.z - slopes.x * slopes.x - slopes.y * slopes.y, zero);
    // Between the texels of a picture that is magnified nothing is hidden.
    const Vec2Of<L>& along = view.pixel.along;
    const auto texels = L::size(along.x) * L::all(static_cast<float>(texture.image.picture.width)) +
                        L::size(along.y) * L::all(static_cast<float>(texture.image.picture.height));
    return {{zero, zero, zero},
            view.x_gradient * (slopes.x * x) + view.y_gradient * (slopes.y * y),
            spread * square * L::smaller(texels, L::all(1))};
}
