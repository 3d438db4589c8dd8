// Weights of neighbours by the likeness of the patches around them: non-local means. Included as
// render/lanes/kernels/vectors.h is.

/// The sum over the channels of
///   ((u_p - u_q)^2 - (V_p + min(V_q, V_p))) / (e + k^2 (V_p + V_q))
/// for pixels p, neighbours q, colours u, their variances V and the bandwidth k (Rousselle, Knaus
/// and Zwicker 2012, "Adaptive rendering with non-local means filtering", equation 4).
template <class L>
CAROM_KERNEL void measure_distances(const DistanceRow& row, int x) {
    using V = ValueOf<L>;
    constexpr float kLeastVariance = 1e-10f;
    const V bandwidth2 = L::load(row.bandwidth2 + x);
    V excess[3];
    V scale[3];
    for (int c = 0; c < 3; ++c) {
        const V difference = L::load(row.colour[c] + x) - L::load(row.other_colour[c] + x);
        const V v = L::load(row.variance[c] + x);
        const V other = L::load(row.other_variance[c] + x);
        excess[c] = difference * difference - (v + L::smaller(other, v));
        scale[c] = L::all(kLeastVariance) + bandwidth2 * (v + other);
    }
    // With one division; the scales' product is at least 1e-30 and at most 1e31.
    const V both = scale[0] * scale[1];
    const V of_both = excess[0] * scale[1] + excess[1] * scale[0];
    const V total = of_both * scale[2] + excess[2] * both;
    L::store(total / (both * scale[2]), row.distance + x);
}

/// e^-x for x in [0, 80], relative error under 4e-7: a power of 2 and the Taylor polynomial of the
/// rest, which is at most ln(2) / 2. Many times faster than exponential_of, which a weight need not
/// be as exact as.
template <class L>
CAROM_KERNEL ValueOf<L> exponential_of_negative(ValueOf<L> x) {
    using V = ValueOf<L>;
    const V to_whole = L::all(0x1.8p23f);  // a float of this size has no fraction
    const V shifted = to_whole - x * L::all(1.44269504f);
    const V power = shifted - to_whole;
    const V rest = L::all(0) - x - power * L::all(0.693147181f);
    V series = L::all(1.f / 120) + rest * L::all(1.f / 720);
    series = L::all(1.f / 24) + rest * series;
    series = L::all(1.f / 6) + rest * series;
    series = L::all(0.5f) + rest * series;
    series = L::all(1) + rest * series;
    series = L::all(1) + rest * series;
    // The lowest bits of `shifted` are the power of 2.
    const auto exponent = L::to_word(L::bits_of(shifted) + L::all_int(127));
    return series * L::from_bits(L::from_word(L::template shifted_left<23>(exponent)));
}

/// The distances of the pixels of a patch that lie in one column.
template <class L>
CAROM_KERNEL ValueOf<L> column_of_patch(const WeightRow& row, int x) {
    return L::load(row.distance[0] + x) + L::load(row.distance[1] + x) +
           L::load(row.distance[2] + x);
}

/// exp(-max(0, d)), where d is the mean over the patch and the channels.
template <class L>
CAROM_KERNEL void weigh(const WeightRow& row, int x) {
    using V = ValueOf<L>;
    constexpr float kFarthest = 20;  // a weight of 2e-9
    constexpr float kSide = 2 * kPatch + 1;
    static_assert(kPatch == 1);
    const V zero = L::all(0);
    const V patch = column_of_patch<L>(row, x) + column_of_patch<L>(row, x + 1) +
                    column_of_patch<L>(row, x + 2);
    const V distance = L::larger(zero, patch * L::all(1 / (3 * kSide * kSide)));
    const V weight = exponential_of_negative<L>(L::smaller(distance, L::all(kFarthest)));
    const V neighbour = L::to_value(L::from(row.neighbour + x));
    const auto exists = L::both(L::is_at_most(zero, neighbour),
                                L::is_less(neighbour, L::all(static_cast<float>(row.width))));
    const auto counts = L::both(exists, L::is_less(distance, L::all(kFarthest)));
    const int chunk = x / kChunk;
    L::store(L::select(counts, weight, zero),
             row.weight + std::ptrdiff_t{chunk} * kNeighbours * kChunk + x % kChunk);
}
