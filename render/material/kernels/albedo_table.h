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
