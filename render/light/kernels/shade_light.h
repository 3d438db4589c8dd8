// Lamps in shades (ShadeConstants), as their opening shows them; in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// The radiance of the wall of a shade at a height from the opening.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_of_wall(const ShadeConstants& shade, ValueOf<L> height) {
    const auto place = limited<L>(height * L::all((ShadeConstants::kNodes - 1) / shade.depth), 0,
                                  ShadeConstants::kNodes - 1);
    Vec3Of<L> radiance{L::all(0), L::all(0), L::all(0)};
    for (int i = 0; i < ShadeConstants::kNodes; ++i) {
        const auto weight =
            L::larger(L::all(0), L::all(1) - L::size(place - L::all(static_cast<float>(i))));
        radiance = radiance + all_of<L>(shade.wall[i]) * weight;
    }
    return radiance;
}

/// The height at which a ray, followed backwards from the opening, meets the wall: the positive
/// root of a z^2 + b z + c with c <= 0. `slope`: how far it moves sideways for each z.
template <class L>
CAROM_KERNEL ValueOf<L> height_on_wall(const ShadeConstants& shade, const Vec3Of<L>& from,
                                       const Vec3Of<L>& slope) {
    const Vec3Of<L> squares = all_of<L>(shade.squares);
    const auto a = dot(slope, slope) - squares.z;
    const auto b = L::all(2) * dot(from, slope) - squares.y;
    const auto c = L::smaller(L::all(0), dot(from, from) - squares.x);
    const auto root = L::root(L::larger(L::all(0), b * b - L::all(4) * a * c));
    return L::all(-2) * c / L::larger(b + root, L::all(1e-12f));
}

/// What a ray sees that passes the opening of a shade at `position` (outside of it: nothing) and
/// came along the unit `direction`, which points out of it.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_in_shade(const AreaLightConstants& light, const Vec3Of<L>& position,
                                         const Vec3Of<L>& direction) {
    using V = ValueOf<L>;
    const ShadeConstants& shade = light.shade;
    const Vec3<V> normal = all_of<L>(light.normal);
    const V cosine = L::larger(dot(direction, normal), L::all(1e-4f));
    const Vec3<V> slope = normal - direction * (L::all(1) / cosine);
    const Vec3<V> from = position - all_of<L>(light.centre);
    const Vec3<V> on_ceiling = from + slope * L::all(shade.depth);
    const V beside = dot(on_ceiling, on_ceiling);
    Vec3<V> seen = select<L>(L::is_at_most(beside, L::all(shade.disk2)), all_of<L>(shade.disk),
                             all_of<L>(shade.ceiling));
    const auto is_on_wall = L::is_less(L::all(shade.edge2), beside);
    if (!L::none(is_on_wall)) {
        const V height = height_on_wall<L>(shade, from, slope);
        seen = select<L>(is_on_wall, radiance_of_wall<L>(shade, height), seen);
    }
    const auto is_open = L::is_at_most(dot(from, from), L::all(shade.squares.x * kOpeningMargin));
    return seen * L::select(is_open, L::all(1), L::all(0));
}

/// The opening of a shade. Some samples are uniform over the opal disk, which is brightest, and the
/// others over the opening; the density is that of both together.
template <class L>
struct ShadeLightOf {
    using V = ValueOf<L>;
    const AreaLightConstants& light;

    /// A point of the unit disk, by the disk's share of the samples or by the opening's.
    struct Place {
        MaskOf<L> is_on_disk;
        Vec2<V> place;
    };
    [[nodiscard]] CAROM_KERNEL Place choose(const Vec2<V>& u) const {
        const float chance = light.shade.disk_chance;
        const auto is_on_disk = L::is_less(u.x, L::all(chance));
        const V low = L::select(is_on_disk, L::all(0), L::all(chance));
        const V width = L::select(is_on_disk, L::all(chance), L::all(1 - chance));
        const V x = limited<L>((u.x - low) / width, 0, kOneMinusEpsilon);
        return {is_on_disk, sample_disk<L>({x, u.y})};
    }
    /// A point at this depth behind the opening.
    [[nodiscard]] CAROM_KERNEL Vec3<V> point_at(const Vec2<V>& place, V radius, V depth) const {
        const V scale = radius * L::all(1 / light.radius);
        return all_of<L>(light.centre) + all_of<L>(light.edge_u) * (place.x * scale) +
               all_of<L>(light.edge_v) * (place.y * scale) - all_of<L>(light.normal) * depth;
    }
    [[nodiscard]] CAROM_KERNEL V height_of(const Vec3<V>& point) const {
        return dot(point - all_of<L>(light.centre), all_of<L>(light.normal));
    }

    [[nodiscard]] CAROM_KERNEL LightSampleOf<L> sample(const Vec3<V>& point,
                                                       const Vec2<V>& u) const {
        const ShadeConstants& shade = light.shade;
        const Place chosen = choose(u);
        const V zero = L::all(0);
        const Vec3<V> target =
            point_at(chosen.place,
                     L::select(chosen.is_on_disk, L::all(shade.disk_radius), L::all(light.radius)),
                     L::select(chosen.is_on_disk, L::all(shade.depth), zero));
        const Vec3<V> direction = unit<L>(target - point);
        const V cosine = L::opposite_sign(dot(direction, all_of<L>(light.normal)));
        const V height = height_of(point);
        auto valid = L::both(L::is_less(zero, cosine), L::is_less(zero, height));
        const V distance = height / L::select(valid, cosine, L::all(1));
        const Vec3<V> on_opening = point + direction * distance;
        const Vec3<V> beside = on_opening - all_of<L>(light.centre);
        valid = L::both(
            valid, L::is_at_most(dot(beside, beside), L::all(shade.squares.x * kOpeningMargin)));
        const V density = L::select(valid, pdf(point, direction, distance), L::all(1));
        return {direction, distance, density,
                radiance_in_shade<L>(light, on_opening, opposite<L>(direction)), valid};
    }

    [[nodiscard]] CAROM_KERNEL V pdf(const Vec3<V>& point, const Vec3<V>& direction,
                                     V distance) const {
        const ShadeConstants& shade = light.shade;
        const V cosine = L::opposite_sign(dot(direction, all_of<L>(light.normal)));
        const auto faces = L::is_less(L::all(0), cosine);
        const V divisor = L::select(faces, cosine, L::all(1));
        const V to_disk = distance + L::all(shade.depth) / divisor;
        const Vec3<V> beside = point + direction * to_disk - all_of<L>(light.centre) +
                               all_of<L>(light.normal) * L::all(shade.depth);
        const auto hits_disk = L::is_at_most(dot(beside, beside), L::all(shade.disk2));
        const V of_disk = to_disk * to_disk * L::all(shade.disk_chance / (kPi * shade.disk2));
        const V of_opening = distance * distance * L::all((1 - shade.disk_chance) / light.area);
        const V density = (L::select(hits_disk, of_disk, L::all(0)) + of_opening) / divisor;
        return L::select(faces, density, L::all(0));
    }

    [[nodiscard]] CAROM_KERNEL V importance(const Vec3<V>& point, const Vec3<V>& normal) const {
        return FlatLightOf<L>{light}.importance(point, normal);
    }

    /// Points of the opening through which the receiver's centre sees the disk, or all.
    [[nodiscard]] CAROM_KERNEL LightPointOf<L> sample_point(const Vec3<V>& receiver,
                                                            V /*receiver_radius*/,
                                                            const Vec2<V>& u) const {
        const ShadeConstants& shade = light.shade;
        const Place chosen = choose(u);
        const Vec3<V> centre = all_of<L>(light.centre);
        const V height = L::larger(height_of(receiver), L::all(0.01f * light.radius));
        const V scale = height / (height + L::all(shade.depth));  // of the disk in the opening
        const Vec3<V> shift =
            (receiver + all_of<L>(light.normal) * (height - height_of(receiver)) - centre) *
                (L::all(1) - scale) -
            all_of<L>(light.normal) * (L::all(shade.depth) * scale);
        const V radius = L::all(shade.disk_radius) * scale;
        const Vec3<V> in_opening = point_at(chosen.place, L::all(light.radius), L::all(0));
        const Vec3<V> in_disk = point_at(chosen.place, radius, L::all(0)) + shift;
        const Vec3<V> position = select<L>(chosen.is_on_disk, in_disk, in_opening);
        const Vec3<V> beside = position - centre - shift;
        const auto shows_disk = L::is_at_most(dot(beside, beside), radius * radius);
        const V of_disk = L::all(shade.disk_chance / kPi) / (radius * radius);
        return {position, all_of<L>(light.normal),
                L::select(shows_disk, of_disk, L::all(0)) +
                    L::all((1 - shade.disk_chance) / light.area)};
    }
    [[nodiscard]] CAROM_KERNEL MaskOf<L> can_sample_point(V distance, V /*receiver_radius*/) const {
        return L::is_less(L::all(0), distance);
    }
    [[nodiscard]] CAROM_KERNEL V distance_along(const Vec3<V>& /*origin*/,
                                                const Vec3<V>& /*direction*/, V to_point) const {
        return to_point;
    }
};
