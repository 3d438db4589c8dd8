// Which rays need not be tested with triangles, in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// Whether rays stay beyond a slab up to `end`: they start there and do not turn to it, or do not
/// reach it. `end` is finite.
template <class L>
CAROM_KERNEL MaskOf<L> stay_beyond(const LeafSlab& slab, const Vec3Of<L>& origin,
                                   const Vec3Of<L>& direction, ValueOf<L> end) {
    const Vec3Of<L> normal = all_of<L>(slab.normal);
    const auto height = dot(normal, origin);
    const auto rise = dot(normal, direction);
    const auto zero = L::all(0);
    const auto low = L::all(slab.low);
    const auto high = L::all(slab.high);
    // For the rounding of a hit's distance, which may pass for one before the end.
    const auto reach =
        L::size(origin.x) + L::size(origin.y) + L::size(origin.z) + L::all(slab.size);
    const auto margin = reach * L::all(slab.rounding);
    const auto height_of_end = height + rise * end;
    const auto stays_above =
        L::either(L::is_at_most(zero, rise), L::is_less(high + margin, height_of_end));
    const auto stays_below =
        L::either(L::is_at_most(rise, zero), L::is_less(height_of_end, low - margin));
    return L::either(L::both(L::is_less(high, height), stays_above),
                     L::both(L::is_less(height, low), stays_below));
}

/// Whether rays pass above everything that the map shows. It must not be empty.
template <class L>
CAROM_KERNEL MaskOf<L> pass_above(const HorizonTables& map, const Vec3Of<L>& origin,
                                  const Vec3Of<L>& direction) {
    const auto zero = L::all(0);
    const auto scale = L::all(map.cells_per_metre);
    const auto x = (origin.x - L::all(map.x)) * scale;
    const auto y = (origin.y - L::all(map.y)) * scale;
    const auto is_within = [&](ValueOf<L> place, int count) CAROM_KERNEL_ATTRIBUTE {
        return L::both(L::is_at_most(zero, place),
                       L::is_less(place, L::all(static_cast<float>(count))));
    };
    const auto is_inside = L::both(is_within(x, map.width), is_within(y, map.height));
    const auto column = L::to_int(L::select(is_inside, x, zero));
    const auto row = L::to_int(L::select(is_inside, y, zero));
    const auto cell = L::product(row, map.width) + column;
    const auto rise = direction.z;
    const auto way2 = direction.x * direction.x + direction.y * direction.y;
    const auto is_steep = L::is_at_most(L::gather(map.slope2, cell) * way2, rise * rise);
    const auto is_above = L::is_less(L::gather(map.top, cell), origin.z);
    return L::both(L::both(is_inside, is_above), L::both(L::is_at_most(zero, rise), is_steep));
}
