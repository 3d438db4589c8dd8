// Means over squares, variances and estimates of the error. Included once per instruction set.
#include "render/denoise/denoise_kernels.h"
#include "render/denoise/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

inline HWY_ATTR void square(const float* values, float* squares, int chunks) {
    for (int x = 0; x < chunks * kChunk; x += lane_count()) {
        const F value = load(values + x);
        store(product(value, value), squares + x);
    }
}

/// The sum over columns and then over rows, each in one order, so that a pixel's bits do not depend
/// on where a row begins.
inline HWY_ATTR void box_mean(const BoxRow& row) {
    const int side = 2 * row.radius + 1;
    float* sums = row.buffer + Plane::kMargin;
    for (int x = -kChunk; x < (row.chunks + 1) * kChunk; x += lane_count()) {
        F total = load(row.rows[0] + x);
        for (int k = 1; k < side; ++k) {
            total = sum(total, load(row.rows[k] + x));
        }
        store(total, sums + x);
    }
    const F scale = all(1.f / static_cast<float>(side * side));
    for (int x = 0; x < row.chunks * kChunk; x += lane_count()) {
        F total = load(sums + x - row.radius);
        for (int k = 1; k < side; ++k) {
            total = sum(total, load(sums + x - row.radius + k));
        }
        store(product(total, scale), row.mean + x);
    }
}

/// The squared differences say how large the variance is, but one of them says little of its pixel;
/// the known variance says where it is large, but it is wrong by a factor. A half has twice the
/// variance of the mean, which is the mean of (A - B)^2 / 4. At edges the known variance is much
/// larger than that of well-spread samples, and the weights would blur what is fine; therefore the
/// variance is at most the squared differences nearby.
inline HWY_ATTR void join_variance(const VarianceRow& row) {
    constexpr float kLeast = 1e-20f;
    for (int x = 0; x < row.chunks * kChunk; x += lane_count()) {
        F variance = load(row.level + x);
        if (row.shape != nullptr) {
            const F shape = load(row.shape + x);
            const F large = load(row.large_shape + x);
            variance =
                product(variance, quotient(sum(shape, all(kLeast)), sum(large, all(kLeast))));
        }
        variance = hn::Max(variance, product(all(0.5f), load(row.near_level + x)));
        variance = hn::Min(variance, load(row.most_level + x));
        store(sum(variance, variance), row.variance + x);
    }
}

/// With the relative noise s of the mean of both halves, the squared bandwidth of the weights is
/// 3.8 / (1 + 24 s). The noisier the colours, the more a neighbour may differ by chance, and the
/// larger are the edges of shadows that would be blurred; but 49 neighbours take off no more noise
/// than before. The ridge grows from 1e-5 to 1e-4, because features are noisier, too. Chosen on the
/// frames of docs/denoising.md with 2 to 32 samples.
inline HWY_ATTR void judge_noise(const NoiseRow& row) {
    const F one = all(1.f);
    for (int x = 0; x < row.chunks * kChunk; x += lane_count()) {
        F relative = all(0.f);  // variance of a half: twice that of the mean
        for (int c = 0; c < 3; ++c) {
            const F r = load(row.mean[c] + x);
            relative =
                sum(relative, quotient(load(row.variance[c] + x), sum(product(r, r), all(0.01f))));
        }
        const F noise = hn::Sqrt(product(relative, all(1.f / 6)));
        store(quotient(all(3.8f), sum(one, product(all(24.f), noise))), row.bandwidth2 + x);
        store(sum(all(1e-5f), product(all(9e-5f), hn::Min(one, product(all(5.f), noise)))),
              row.ridge + x);
    }
}

/// The error of the mean of the predictions a and b from the halves A and B is
///   ((a - B)^2 + (b - A)^2) / 2 - (A - B)^2 / 2 - (a - b)^2 / 4
/// in the mean over many pixels, because the noise of a half is independent of the other half; that
/// of the mean of A and B is (A - B)^2 / 4. Relative to r^2 + 0.01. In the first two terms a and b
/// are predictions that know nothing of B and A.
inline HWY_ATTR void estimate_errors(const ErrorRow& row) {
    const F half = all(0.5f);
    const F third = all(1.f / 3);
    for (int x = 0; x < row.chunks * kChunk; x += lane_count()) {
        F noisy = all(0.f);
        F filtered = all(0.f);
        F shift = all(0.f);
        for (int c = 0; c < 3; ++c) {
            const F mean = load(row.mean[c] + x);
            const F difference = load(row.difference[c] + x);  // (A - B) / 2
            const F a = load(row.from_a[c] + x);
            const F b = load(row.from_b[c] + x);
            const F r = product(half, sum(a, b));
            const F scale = quotient(third, sum(product(r, r), all(0.01f)));
            const F variance = product(difference, difference);
            const F a_to_b = minus(load(row.checked_a[c] + x), minus(mean, difference));
            const F b_to_a = minus(load(row.checked_b[c] + x), sum(mean, difference));
            const F between = product(half, minus(a, b));
            const F both = product(half, sum(product(a_to_b, a_to_b), product(b_to_a, b_to_a)));
            const F error = minus(minus(both, sum(variance, variance)), product(between, between));
            const F moved = minus(r, mean);
            shift = sum(shift, product(product(moved, moved), scale));
            noisy = sum(noisy, product(variance, scale));
            filtered = sum(filtered, product(error, scale));
        }
        store(noisy, row.noisy + x);
        store(filtered, row.filtered + x);
        store(minus(shift, noisy), row.shift + x);
    }
}

/// The mean of the predictions, moved back towards the noisy colour to within 2 + 100 s standard
/// deviations of its noise s, relative as in estimate_errors. A pixel of little noise at the edge
/// of much gets colours from beyond the edge; where the noise is large, the predictions are better
/// than any such limit. The noise is that of the pixel or of those around it, whichever is more;
/// around a plain pixel, only plain ones count, if they are most: those of a few may agree by
/// chance.
inline HWY_ATTR void limit(const LimitRow& row) {
    constexpr float kMost = 0.6f;
    for (int x = 0; x < row.chunks * kChunk; x += lane_count()) {
        const F mean = load(row.mean + x);
        const F share = load(row.plain_share + x);
        const F of_plain = quotient(load(row.plain_squared + x), hn::Max(share, all(kMost)));
        const auto counts =
            hn::And(hn::Gt(load(row.plain + x), all(0.f)), hn::Gt(share, all(kMost)));
        const F nearby = hn::IfThenElse(counts, of_plain, load(row.near_squared + x));
        const F variance = hn::Max(load(row.squared + x), nearby);
        const F noise = hn::Sqrt(quotient(variance, sum(product(mean, mean), all(0.01f))));
        const F most = product(sum(all(2.f), product(all(100.f), noise)), hn::Sqrt(variance));
        const F filtered = product(all(0.5f), sum(load(row.from_a + x), load(row.from_b + x)));
        const F limited = hn::Clamp(filtered, minus(mean, most), sum(mean, most));
        store(hn::Max(all(0.f), limited), row.limited + x);
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
