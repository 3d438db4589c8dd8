// Weighted linear regression of colours on features, for many pixels at once. Included once per
// instruction set.
#include <utility>

#include "render/denoise/denoise_kernels.h"
#include "render/denoise/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// The sums of the normal equations, by rows: row i holds the products of regressor i with the
/// regressors i, i + 1 ... and with the three colours. Regressor 0 is 1; regressor i is feature i -
/// 1 relative to its value at the pixel itself, so that features that do not vary are exactly 0.
template <int kFeatures>
struct NormalSums {
    static constexpr int kRegressors = kFeatures + 1;

    F at[kRegressors * (kRegressors + 1) / 2 + 3 * kRegressors];

    static constexpr int row_size(int row) { return kRegressors - row + 3; }
    static constexpr int row_begin(int row) {
        int begin = 0;
        for (int i = 0; i < row; ++i) {
            begin += row_size(i);
        }
        return begin;
    }
    F& matrix(int i, int j) { return at[row_begin(i) + j - i]; }  // i <= j
    F& right(int i, int channel) { return at[row_begin(i) + kRegressors - i + channel]; }
};

template <int... kIndex>
HWY_INLINE void add_products(F w, const F* values, F* sums, std::integer_sequence<int, kIndex...>) {
    ((sums[kIndex] = sum(sums[kIndex], product(w, values[kIndex]))), ...);
}

/// Adds a neighbour of weight `w` to one row. `values`: all regressors from 1 on, then the colours.
template <int kFeatures, int kRow>
HWY_INLINE void add_to_row(F w, const F* values, F* sums) {
    if constexpr (kRow == 0) {
        sums[0] = sum(sums[0], w);
        add_products(w, values, sums + 1, std::make_integer_sequence<int, kFeatures + 3>());
    } else {
        add_products(product(w, values[kRow - 1]), values + kRow - 1, sums,
                     std::make_integer_sequence<int, kFeatures - kRow + 4>());
    }
}

template <int kFeatures, int kFirst, int... kIndex>
HWY_INLINE void add_to_rows(F w, const F* values, F* sums, std::integer_sequence<int, kIndex...>) {
    using Sums = NormalSums<kFeatures>;
    (add_to_row<kFeatures, kFirst + kIndex>(
         w, values, sums + Sums::row_begin(kFirst + kIndex) - Sums::row_begin(kFirst)),
     ...);
}

template <int... kIndex>
HWY_INLINE void load_values(const float* const* from, std::ptrdiff_t offset, const F* subtracted,
                            F* values, std::integer_sequence<int, kIndex...>) {
    ((values[kIndex] = minus(load(from[kIndex] + offset), subtracted[kIndex])), ...);
}

template <int... kIndex>
HWY_INLINE void load_values(const float* const* from, std::ptrdiff_t offset, F* values,
                            std::integer_sequence<int, kIndex...>) {
    ((values[kIndex] = load(from[kIndex] + offset)), ...);
}

template <int... kIndex>
HWY_INLINE void store_sums(const F* from, F* to, std::integer_sequence<int, kIndex...>) {
    ((to[kIndex] = from[kIndex]), ...);
}

template <int... kIndex>
HWY_INLINE void clear(F* sums, std::integer_sequence<int, kIndex...>) {
    ((sums[kIndex] = all(0.f)), ...);
}

/// Sums the rows kFirst to kFirst + kCount - 1 over all neighbours. A call has few enough sums that
/// they stay in registers.
template <int kFeatures, int kFirst, int kCount>
HWY_INLINE void sum_rows(const RegressionChunk& chunk, int lane, NormalSums<kFeatures>& sums) {
    using Sums = NormalSums<kFeatures>;
    constexpr int kBegin = Sums::row_begin(kFirst);
    constexpr int kSize = Sums::row_begin(kFirst + kCount) - kBegin;
    constexpr int kFirstFeature = kFirst == 0 ? 0 : kFirst - 1;  // that is needed
    using Needed = std::make_integer_sequence<int, kFeatures - kFirstFeature>;
    F own[kFeatures + 1];
    F values[kFeatures + 3];
    F total[kSize];
    clear(total, std::make_integer_sequence<int, kSize>());
    load_values(chunk.feature + kFirstFeature, lane, own + kFirstFeature, Needed());
    for (int k = 0; k < chunk.neighbour_count; ++k) {
        const std::ptrdiff_t offset = chunk.neighbours[k] + lane;
        load_values(chunk.feature + kFirstFeature, offset, own + kFirstFeature,
                    values + kFirstFeature, Needed());
        load_values(chunk.colour, offset, values + kFeatures, std::make_integer_sequence<int, 3>());
        const F w = load(chunk.weight + std::ptrdiff_t{k} * kChunk + lane);
        add_to_rows<kFeatures, kFirst>(w, values, total, std::make_integer_sequence<int, kCount>());
    }
    store_sums(total, sums.at + kBegin, std::make_integer_sequence<int, kSize>());
}

template <int kFeatures>
HWY_INLINE void sum_all(const RegressionChunk& chunk, int lane, NormalSums<kFeatures>& sums) {
    if constexpr (kFeatures == 9) {
        sum_rows<kFeatures, 0, 2>(chunk, lane, sums);
        sum_rows<kFeatures, 2, 2>(chunk, lane, sums);
        sum_rows<kFeatures, 4, 3>(chunk, lane, sums);
        sum_rows<kFeatures, 7, 3>(chunk, lane, sums);
    } else if constexpr (kFeatures == 6) {
        sum_rows<kFeatures, 0, 2>(chunk, lane, sums);
        sum_rows<kFeatures, 2, 2>(chunk, lane, sums);
        sum_rows<kFeatures, 4, 3>(chunk, lane, sums);
    } else {
        sum_rows<kFeatures, 0, kFeatures + 1>(chunk, lane, sums);
    }
}

/// Eliminates the constant, then the features (LDL^T), and evaluates the fit at the exact features,
/// and at those without the samples of the other half.
/// The ridge keeps features that explain nothing from being used. A feature of large values, such
/// as a lamp's light, has one in proportion, so that rounding leaves every pivot positive.
template <int kFeatures>
HWY_INLINE void solve(const RegressionChunk& chunk, int lane, NormalSums<kFeatures>& sums) {
    const F ridge = load(chunk.ridge + lane);
    constexpr float kLeastPivot = 1e-6f;
    const F weight = sums.matrix(0, 0);
    F result[3];
    F checked[3];
    for (int c = 0; c < 3; ++c) {
        result[c] = checked[c] = quotient(sums.right(0, c), weight);
    }
    // Of the exact features relative to the neighbours' mean, and of those without the other half:
    // with the share s of both halves, these are (exact - s / 2 other) / (1 - s / 2).
    F place[kFeatures + 1];
    F without[kFeatures + 1];
    F least[kFeatures + 1];
    const F half_share = product(all(0.5f), load(chunk.share + lane));
    const F others = quotient(half_share, minus(all(1.f), half_share));
    for (int i = 1; i <= kFeatures; ++i) {
        const F exact = load(chunk.exact[i - 1] + lane);
        const F moved = minus(exact, load(chunk.feature[i - 1] + lane));
        place[i] = minus(moved, quotient(sums.matrix(0, i), weight));
        const F of_other = minus(exact, load(chunk.other_feature[i - 1] + lane));
        without[i] = sum(place[i], product(others, of_other));
    }
    for (int i = 1; i <= kFeatures; ++i) {
        const F size = sum(weight, sums.matrix(i, i));
        const F mean = quotient(sums.matrix(0, i), weight);
        for (int j = i; j <= kFeatures; ++j) {
            sums.matrix(i, j) = minus(sums.matrix(i, j), product(mean, sums.matrix(0, j)));
        }
        for (int c = 0; c < 3; ++c) {
            sums.right(i, c) = minus(sums.right(i, c), product(mean, sums.right(0, c)));
        }
        sums.matrix(i, i) = sum(sums.matrix(i, i), product(ridge, size));
        least[i] = product(all(kLeastPivot), size);
    }
    for (int i = 1; i <= kFeatures; ++i) {
        const F scale = quotient(all(1.f), hn::Max(sums.matrix(i, i), least[i]));
        for (int j = i + 1; j <= kFeatures; ++j) {
            const F factor = product(sums.matrix(i, j), scale);
            for (int k = j; k <= kFeatures; ++k) {
                sums.matrix(j, k) = minus(sums.matrix(j, k), product(factor, sums.matrix(i, k)));
            }
            for (int c = 0; c < 3; ++c) {
                sums.right(j, c) = minus(sums.right(j, c), product(factor, sums.right(i, c)));
            }
            place[j] = minus(place[j], product(factor, place[i]));
            without[j] = minus(without[j], product(factor, without[i]));
        }
        const F along = product(place[i], scale);
        const F along_without = product(without[i], scale);
        for (int c = 0; c < 3; ++c) {
            result[c] = sum(result[c], product(along, sums.right(i, c)));
            checked[c] = sum(checked[c], product(along_without, sums.right(i, c)));
        }
    }
    for (int c = 0; c < 3; ++c) {
        store(result[c], chunk.result[c] + lane);
        store(checked[c], chunk.checked[c] + lane);
    }
}

inline HWY_ATTR bool is_constant(const float* first_neighbour) {
    constexpr int kCount = kChunk + 2 * kWindow;
    const F value = all(*first_neighbour);
    const auto differs = [&](int at) HWY_ATTR { return hn::Ne(load(first_neighbour + at), value); };
    auto any = differs(kCount - lane_count());
    for (int at = 0; at < kCount - lane_count(); at += lane_count()) {
        any = hn::Or(any, differs(at));
    }
    return hn::AllFalse(FloatTag(), any);
}

template <int kFeatures>
HWY_ATTR void regress(const RegressionChunk& chunk) {
    for (int lane = 0; lane < kChunk; lane += lane_count()) {
        NormalSums<kFeatures> sums;
        sum_all<kFeatures>(chunk, lane, sums);
        solve<kFeatures>(chunk, lane, sums);
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
