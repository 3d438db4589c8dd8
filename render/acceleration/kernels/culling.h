// Which rays need not be tested with triangles, in lanes. Included as
// render/lanes/kernels/vectors.h is, after render/triangle/kernels/common.h.

/// Whether rays start beyond a slab and do not return to it.
template <class L>
CAROM_KERNEL typename L::Mask leave_slab(const LeafSlab& slab,
                                         const kernels::Triple<typename L::Value>& origin,
                                         const kernels::Triple<typename L::Value>& direction) {
    const kernels::Triple<typename L::Value> normal{
        {L::all(slab.normal.x), L::all(slab.normal.y), L::all(slab.normal.z)}};
    const auto height = dot(normal, origin);
    const auto rise = dot(normal, direction);
    const auto zero = L::all(0);
    return L::either(L::both(L::is_less(L::all(slab.high), height), L::is_at_most(zero, rise)),
                     L::both(L::is_less(height, L::all(slab.low)), L::is_at_most(rise, zero)));
}

/// Whether rays pass above everything that the map shows. It must not be empty.
template <class L>
CAROM_KERNEL typename L::Mask pass_above(const Horizon& map,
                                         const kernels::Triple<typename L::Value>& origin,
                                         const kernels::Triple<typename L::Value>& direction) {
    const auto zero = L::all(0);
    const auto scale = L::all(map.cells_per_metre);
    const auto x = (origin.at[0] - L::all(map.x)) * scale;
    const auto y = (origin.at[1] - L::all(map.y)) * scale;
    const auto is_within = [&](typename L::Value place, int count) CAROM_KERNEL_ATTRIBUTE {
        return L::both(L::is_at_most(zero, place),
                       L::is_less(place, L::all(static_cast<float>(count))));
    };
    const auto is_inside = L::both(is_within(x, map.width), is_within(y, map.height));
    const auto column = L::to_int(L::select(is_inside, x, zero));
    const auto row = L::to_int(L::select(is_inside, y, zero));
    const auto cell = L::product(row, map.width) + column;
    const auto rise = direction.at[2];
    const auto way2 = direction.at[0] * direction.at[0] + direction.at[1] * direction.at[1];
    const auto is_steep = L::is_at_most(L::gather(map.slope2.data(), cell) * way2, rise * rise);
    const auto is_above = L::is_less(L::gather(map.top.data(), cell), origin.at[2]);
    return L::both(L::both(is_inside, is_above), L::both(L::is_at_most(zero, rise), is_steep));
}
