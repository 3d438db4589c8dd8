// Means over squares, variances and estimates of the error. Included as
// render/lanes/kernels/vectors.h is.

template <class L>
CAROM_KERNEL void square(const SquareRow& row, int x) {
    const auto value = L::load(row.values + x);
    L::store(value * value, row.squares + x);
}

/// The sums over the columns of a square. These and mean_of_sums() add in one order, so that a
/// pixel's bits do not depend on where a row begins.
template <class L>
CAROM_KERNEL void sum_columns(const BoxRow& row, int x) {
    auto total = L::load(row.rows[0] + x);
    for (int k = 1; k <= 2 * row.radius; ++k) {
        total = total + L::load(row.rows[k] + x);
    }
    L::store(total, row.sums + x);
}

/// The mean over a square, from the sums over its columns.
template <class L>
CAROM_KERNEL void mean_of_sums(const BoxRow& row, int x) {
    const int side = 2 * row.radius + 1;
    const float* const sums = row.sums + x - row.radius;
    auto total = L::load(sums);
    for (int k = 1; k < side; ++k) {
        total = total + L::load(sums + k);
    }
    L::store(total * L::all(1.f / static_cast<float>(side * side)), row.mean + x);
}

/// The squared differences say how large the variance is, but one of them says little of its pixel;
/// the known variance says where it is large, but it is wrong by a factor. A half has twice the
/// variance of the mean, which is the mean of (A - B)^2 / 4. At edges the known variance is much
/// larger than that of well-spread samples, and the weights would blur what is fine; therefore the
/// variance is at most the squared differences nearby.
template <class L>
CAROM_KERNEL void join_variance(const VarianceRow& row, int x) {
    constexpr float kLeast = 1e-20f;
    auto variance = L::load(row.level + x);
    if (row.shape != nullptr) {
        const auto shape = L::load(row.shape + x) + L::all(kLeast);
        variance = variance * (shape / (L::load(row.large_shape + x) + L::all(kLeast)));
    }
    variance = L::larger(variance, L::all(0.5f) * L::load(row.near_level + x));
    variance = L::smaller(variance, L::load(row.most_level + x));
    L::store(variance + variance, row.variance + x);
}

/// With the relative noise s of the mean of both halves, the squared bandwidth of the weights is
/// 3.8 / (1 + 24 s). The noisier the colours, the more a neighbour may differ by chance, and the
/// larger are the edges of shadows that would be blurred; but 49 neighbours take off no more noise
/// than before. The ridge grows from 1e-5 to 1e-4, because features are noisier, too. Chosen on the
/// frames of docs/denoising.md with 2 to 32 samples.
template <class L>
CAROM_KERNEL void judge_noise(const NoiseRow& row, int x) {
    const auto one = L::all(1);
    auto relative = L::all(0);  // variance of a half: twice that of the mean
    for (int c = 0; c < 3; ++c) {
        const auto r = L::load(row.mean[c] + x);
        relative = relative + L::load(row.variance[c] + x) / (r * r + L::all(0.01f));
    }
    const auto noise = L::root(relative * L::all(1.f / 6));
    L::store(L::all(3.8f) / (one + L::all(24) * noise), row.bandwidth2 + x);
    L::store(L::all(1e-5f) + L::all(9e-5f) * L::smaller(one, L::all(5) * noise), row.ridge + x);
}

/// The error of the mean of the predictions a and b from the halves A and B is
///   ((a - B)^2 + (b - A)^2) / 2 - (A - B)^2 / 2 - (a - b)^2 / 4
/// in the mean over many pixels, because the noise of a half is independent of the other half; that
/// of the mean of A and B is (A - B)^2 / 4. Relative to r^2 + 0.01. In the first two terms a and b
/// are predictions that know nothing of B and A.
template <class L>
CAROM_KERNEL void estimate_errors(const ErrorRow& row, int x) {
    using V = ValueOf<L>;
    const V one_half = L::all(0.5f);
    V noisy = L::all(0);
    V filtered = L::all(0);
    V shift = L::all(0);
    for (int c = 0; c < 3; ++c) {
        const V mean = L::load(row.mean[c] + x);
        const V difference = L::load(row.difference[c] + x);  // (A - B) / 2
        const V a = L::load(row.from_a[c] + x);
        const V b = L::load(row.from_b[c] + x);
        const V r = one_half * (a + b);
        const V scale = L::all(1.f / 3) / (r * r + L::all(0.01f));
        const V variance = difference * difference;
        const V a_to_b = L::load(row.checked_a[c] + x) - (mean - difference);
        const V b_to_a = L::load(row.checked_b[c] + x) - (mean + difference);
        const V between = one_half * (a - b);
        const V both = one_half * (a_to_b * a_to_b + b_to_a * b_to_a);
        const V error = both - (variance + variance) - between * between;
        const V moved = r - mean;
        shift = shift + moved * moved * scale;
        noisy = noisy + variance * scale;
        filtered = filtered + error * scale;
    }
    L::store(noisy, row.noisy + x);
    L::store(filtered, row.filtered + x);
    L::store(shift - noisy, row.shift + x);
}

/// The mean of the predictions, moved back towards the noisy colour to within 2 + 100 s standard
/// deviations of its noise s, relative as in estimate_errors. A pixel of little noise at the edge
/// of much gets colours from beyond the edge; where the noise is large, the predictions are better
/// than any such limit. The noise is that of the pixel or of those around it, whichever is more;
/// around a plain pixel, only plain ones count, if they are most: those of a few may agree by
/// chance.
template <class L>
CAROM_KERNEL void limit(const LimitRow& row, int x) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V enough = L::all(0.6f);
    const V mean = L::load(row.mean + x);
    const V share = L::load(row.plain_share + x);
    const V of_plain = L::load(row.plain_squared + x) / L::larger(share, enough);
    const auto counts =
        L::both(L::is_less(zero, L::load(row.plain + x)), L::is_less(enough, share));
    const V nearby = L::select(counts, of_plain, L::load(row.near_squared + x));
    const V variance = L::larger(L::load(row.squared + x), nearby);
    const V noise = L::root(variance / (mean * mean + L::all(0.01f)));
    const V most = (L::all(2) + L::all(100) * noise) * L::root(variance);
    const V filtered = L::all(0.5f) * (L::load(row.from_a + x) + L::load(row.from_b + x));
    const V limited = L::smaller(L::larger(mean - most, filtered), mean + most);
    L::store(L::larger(zero, limited), row.limited + x);
}
