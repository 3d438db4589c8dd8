// Look-up of albedos (albedo_table.h) in lanes. Included as render/lanes/kernels/vectors.h is.

/// `first`: of the table's numbers among several tables.
template <class L>
CAROM_KERNEL ValueOf<L> albedo_at(const float* tables, IntOf<L> first, ValueOf<L> cosine) {
    const auto place = L::root(limited<L>(cosine, 0, 1)) * L::all(kAlbedoNodes - 1);
    const auto node = L::smaller_int(L::to_int(place), L::all_int(kAlbedoNodes - 2));
    const auto fraction = place - L::to_value(node);
    const auto around = L::gather_pair(tables, first + node);
    return around.first + (around.second - around.first) * fraction;
}

/// The two of the tables of a kind, for kAlbedoSlices roughnesses, between which a surface is.
template <class L>
struct TableSlicesOf {
    IntOf<L> first, next;  // of a table's numbers
    ValueOf<L> fraction;   // of the second one
};

/// Likewise between the tables of two roughnesses. `slices`: of the surface, if `varies`; otherwise
/// `first`.
template <class L>
CAROM_KERNEL ValueOf<L> albedo_at(const float* tables, IntOf<L> first, bool varies,
                                  const TableSlicesOf<L>& slices, ValueOf<L> cosine) {
    if (!varies) {
        return albedo_at<L>(tables, first, cosine);
    }
    const auto smoother = albedo_at<L>(tables, slices.first, cosine);
    return smoother + (albedo_at<L>(tables, slices.next, cosine) - smoother) * slices.fraction;
}

/// The tables around a roughness of GGX's alpha. `first`: of the material's numbers; `slices`: as
/// many tables as it has of a kind, 1 or kAlbedoSlices.
template <class L>
CAROM_KERNEL TableSlicesOf<L> table_slices(IntOf<L> first, ValueOf<L> slices, ValueOf<L> alpha) {
    const auto last = slices - L::all(1);
    const auto place = L::smaller(L::root(alpha) * last, last);
    const auto below = L::rounded_down(place);
    const auto number = L::to_int(below);
    const auto next = L::to_int(L::smaller(below + L::all(1), last));
    return {first + L::product(number, kAlbedoNodes), first + L::product(next, kAlbedoNodes),
            place - below};
}
