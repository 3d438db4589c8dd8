// The paint of texture_data.h in lanes. Included as render/lanes/kernels/vectors.h is.

/// Lengths in ball radii.
struct BallLook {
    static constexpr float kSpotRadius = 0.105f;
    static constexpr float kFinest = 1e-4f;  // narrowest edge
};

/// a where t is 0, b where it is 1.
template <class V>
CAROM_KERNEL Vec3<V> mixed(const Vec3<V>& a, const Vec3<V>& b,
                           const typename Vec3<V>::BaseType& t) {
    return a + (b - a) * t;
}

/// Coverage by the inside of a circle around an axis. As seen from the axis, the circle has the
/// chord radius `radius` and the point the distance `distance`. Both are sines of angles; dividing
/// by the cosine turns them into lengths along the surface.
template <class L>
CAROM_KERNEL ValueOf<L> inside_circle(ValueOf<L> distance, float radius, ValueOf<L> width) {
    const auto cosine = L::root(L::all(1.0f - radius * radius));
    return smooth_step<L>((L::all(radius) - distance) / cosine, width);
}

template <class L>
CAROM_KERNEL Vec3Of<L> with_number(const BallParameters& ball, const Vec3Of<L>& below,
                                   const Vec3Of<L>& direction, ValueOf<L> width) {
    const auto zero = L::all(0);
    const auto distance = L::root(direction.y * direction.y + direction.z * direction.z);
    const auto disc = inside_circle<L>(distance, ball.disc_radius, width);
    const auto is_on_disc = L::is_less(zero, disc);
    if (L::none(is_on_disc)) {
        return below;
    }
    // Seen from +x the right-hand side is +y. The number on the opposite side stands on its head
    // (WPA, Tournament Table & Equipment Specifications), so that its right-hand side is +y too.
    const auto up =
        L::select(L::is_at_most(zero, direction.x), direction.z, L::opposite_sign(direction.z));
    const auto scale = L::all(0.5f / ball.disc_radius);
    const auto middle = L::all(0.5f);
    const auto coverage = look_up_coverage<L>(
        ball.number, {middle + direction.y * scale, middle - up * scale}, width * scale);
    const Vec3Of<L> ink{L::all(0.012f), L::all(0.012f), L::all(0.013f)};
    const auto painted = mixed(below, mixed(all_of<L>(ball.white), ink, coverage), disc);
    return select<L>(is_on_disc, painted, below);
}

template <class L>
CAROM_KERNEL Vec3Of<L> with_spots(const Vec3Of<L>& below, const Vec3Of<L>& direction,
                                  ValueOf<L> width) {
    const auto along =
        largest<L>({L::size(direction.x), L::size(direction.y), L::size(direction.z)});
    const auto distance = L::root(L::larger(L::all(1) - along * along, L::all(0)));
    const Vec3Of<L> spot{L::all(0.52f), L::all(0.02f), L::all(0.018f)};
    return mixed(below, spot, inside_circle<L>(distance, BallLook::kSpotRadius, width));
}

/// `position`: in the ball's own axes, not 0; `footprint`: width of a pixel there, m.
template <class L>
CAROM_KERNEL Vec3Of<L> ball_colour(const BallParameters& ball, const Vec3Of<L>& position,
                                   ValueOf<L> footprint) {
    const auto radius = L::root(dot(position, position));
    const Vec3Of<L> direction{position.x / radius, position.y / radius, position.z / radius};
    const auto width = limited<L>(footprint / radius, BallLook::kFinest, 2);
    Vec3Of<L> result = all_of<L>(ball.colour);
    if (ball.is_striped) {
        const auto band = inside_circle<L>(L::size(direction.z), ball.band_half_width, width);
        result = mixed(all_of<L>(ball.white), result, band);
    }
    if (ball.number.texels.exists()) {
        result = with_number<L>(ball, result, direction, width);
    }
    if (ball.has_spots) {
        result = with_spots<L>(result, direction, width);
    }
    return result;
}
