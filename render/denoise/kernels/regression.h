// Weighted linear regression of colours on features, for many pixels at once. Included as
// render/lanes/kernels/vectors.h is.

/// The sums of the normal equations, by rows: row i holds the products of regressor i with the
/// regressors i, i + 1 ... and with the three colours. Regressor 0 is 1; regressor i is feature i -
/// 1 relative to its value at the pixel itself, so that features that do not vary are exactly 0.
template <class L, int kFeatures>
struct NormalSums {
    using V = ValueOf<L>;
    static constexpr int kRegressors = kFeatures + 1;

    V at[kRegressors * (kRegressors + 1) / 2 + 3 * kRegressors];

    static constexpr int row_size(int row) { return kRegressors - row + 3; }
    static constexpr int row_begin(int row) {
        int begin = 0;
        for (int i = 0; i < row; ++i) {
            begin += row_size(i);
        }
        return begin;
    }
    CAROM_KERNEL V& matrix(int i, int j) { return at[row_begin(i) + j - i]; }  // i <= j
    CAROM_KERNEL V& right(int i, int channel) {
        return at[row_begin(i) + kRegressors - i + channel];
    }
};

/// Calls `body` with the constants 0 to kCount - 1. Not a loop, so that what they index stays in
/// registers.
template <class Body, int... kIndex>
CAROM_KERNEL void for_each(std::integer_sequence<int, kIndex...>, const Body& body) {
    (body(std::integral_constant<int, kIndex>()), ...);
}
template <int kCount, class Body>
CAROM_KERNEL void for_constants(const Body& body) {
    for_each(std::make_integer_sequence<int, kCount>(), body);
}

/// Adds a neighbour of weight `w` to one row. `values`: all regressors from 1 on, then the colours.
template <class L, int kFeatures, int kRow>
CAROM_KERNEL void add_to_row(ValueOf<L> w, const ValueOf<L>* values, ValueOf<L>* sums) {
    if constexpr (kRow == 0) {
        sums[0] = sums[0] + w;
        for_constants<kFeatures + 3>(
            [&](auto i) CAROM_KERNEL_ATTRIBUTE { sums[i + 1] = sums[i + 1] + w * values[i]; });
    } else {
        const ValueOf<L>* rest = values + kRow - 1;
        const ValueOf<L> factor = w * rest[0];
        for_constants<kFeatures - kRow + 4>(
            [&](auto i) CAROM_KERNEL_ATTRIBUTE { sums[i] = sums[i] + factor * rest[i]; });
    }
}

/// Sums the rows kFirst to kFirst + kCount - 1 over all neighbours. A call has few enough sums that
/// they stay in registers.
template <class L, int kFeatures, int kFirst, int kCount>
CAROM_KERNEL void sum_rows(const RegressionChunk& chunk, int lane, NormalSums<L, kFeatures>& sums) {
    using V = ValueOf<L>;
    using Sums = NormalSums<L, kFeatures>;
    constexpr int kBegin = Sums::row_begin(kFirst);
    constexpr int kSize = Sums::row_begin(kFirst + kCount) - kBegin;
    constexpr int kFirstFeature = kFirst == 0 ? 0 : kFirst - 1;  // that is needed
    constexpr int kNeeded = kFeatures - kFirstFeature;
    V own[kFeatures + 1];
    V values[kFeatures + 3];
    V total[kSize];
    for_constants<kSize>([&](auto i) CAROM_KERNEL_ATTRIBUTE { total[i] = L::all(0); });
    const float* const* feature = chunk.feature + kFirstFeature;
    for_constants<kNeeded>([&](auto i) CAROM_KERNEL_ATTRIBUTE {
        own[kFirstFeature + i] = L::load(feature[i] + lane);
    });
    for (int k = 0; k < chunk.neighbour_count; ++k) {
        const std::ptrdiff_t offset = chunk.neighbours[k] + lane;
        for_constants<kNeeded>([&](auto i) CAROM_KERNEL_ATTRIBUTE {
            values[kFirstFeature + i] = L::load(feature[i] + offset) - own[kFirstFeature + i];
        });
        for_constants<3>([&](auto c) CAROM_KERNEL_ATTRIBUTE {
            values[kFeatures + c] = L::load(chunk.colour[c] + offset);
        });
        const V w = L::load(chunk.weight + std::ptrdiff_t{k} * kChunk + lane);
        for_constants<kCount>([&](auto row) CAROM_KERNEL_ATTRIBUTE {
            add_to_row<L, kFeatures, kFirst + row>(w, values,
                                                   total + Sums::row_begin(kFirst + row) - kBegin);
        });
    }
    for_constants<kSize>([&](auto i) CAROM_KERNEL_ATTRIBUTE { sums.at[kBegin + i] = total[i]; });
}

template <class L, int kFeatures>
CAROM_KERNEL void sum_all(const RegressionChunk& chunk, int lane, NormalSums<L, kFeatures>& sums) {
    if constexpr (kFeatures == 9) {
        sum_rows<L, kFeatures, 0, 2>(chunk, lane, sums);
        sum_rows<L, kFeatures, 2, 2>(chunk, lane, sums);
        sum_rows<L, kFeatures, 4, 3>(chunk, lane, sums);
        sum_rows<L, kFeatures, 7, 3>(chunk, lane, sums);
    } else if constexpr (kFeatures == 6) {
        sum_rows<L, kFeatures, 0, 2>(chunk, lane, sums);
        sum_rows<L, kFeatures, 2, 2>(chunk, lane, sums);
        sum_rows<L, kFeatures, 4, 3>(chunk, lane, sums);
    } else {
        sum_rows<L, kFeatures, 0, kFeatures + 1>(chunk, lane, sums);
    }
}

/// Eliminates the constant, then the features (LDL^T), and evaluates the fit at the exact features,
/// and at those without the samples of the other half.
/// The ridge keeps features that explain nothing from being used. A feature of large values, such
/// as a lamp's light, has one in proportion, so that rounding leaves every pivot positive.
template <class L, int kFeatures>
CAROM_KERNEL void solve(const RegressionChunk& chunk, int lane, NormalSums<L, kFeatures>& sums) {
    using V = ValueOf<L>;
    constexpr float kLeastPivot = 1e-6f;
    const V ridge = L::load(chunk.ridge + lane);
    const V weight = sums.matrix(0, 0);
    V result[3];
    V checked[3];
    for (int c = 0; c < 3; ++c) {
        result[c] = checked[c] = sums.right(0, c) / weight;
    }
    // Of the exact features relative to the neighbours' mean, and of those without the other half:
    // with the share s of both halves, these are (exact - s / 2 other) / (1 - s / 2).
    V place[kFeatures + 1];
    V without[kFeatures + 1];
    V least[kFeatures + 1];
    const V half_share = L::all(0.5f) * L::load(chunk.share + lane);
    const V others = half_share / (L::all(1) - half_share);
    for (int i = 1; i <= kFeatures; ++i) {
        const V exact = L::load(chunk.exact[i - 1] + lane);
        const V moved = exact - L::load(chunk.feature[i - 1] + lane);
        place[i] = moved - sums.matrix(0, i) / weight;
        without[i] = place[i] + others * (exact - L::load(chunk.other_feature[i - 1] + lane));
    }
    for (int i = 1; i <= kFeatures; ++i) {
        const V size = weight + sums.matrix(i, i);
        const V mean = sums.matrix(0, i) / weight;
        for (int j = i; j <= kFeatures; ++j) {
            sums.matrix(i, j) = sums.matrix(i, j) - mean * sums.matrix(0, j);
        }
        for (int c = 0; c < 3; ++c) {
            sums.right(i, c) = sums.right(i, c) - mean * sums.right(0, c);
        }
        sums.matrix(i, i) = sums.matrix(i, i) + ridge * size;
        least[i] = L::all(kLeastPivot) * size;
    }
    for (int i = 1; i <= kFeatures; ++i) {
        const V scale = L::all(1) / L::larger(sums.matrix(i, i), least[i]);
        for (int j = i + 1; j <= kFeatures; ++j) {
            const V factor = sums.matrix(i, j) * scale;
            for (int k = j; k <= kFeatures; ++k) {
                sums.matrix(j, k) = sums.matrix(j, k) - factor * sums.matrix(i, k);
            }
            for (int c = 0; c < 3; ++c) {
                sums.right(j, c) = sums.right(j, c) - factor * sums.right(i, c);
            }
            place[j] = place[j] - factor * place[i];
            without[j] = without[j] - factor * without[i];
        }
        const V along = place[i] * scale;
        const V along_without = without[i] * scale;
        for (int c = 0; c < 3; ++c) {
            result[c] = result[c] + along * sums.right(i, c);
            checked[c] = checked[c] + along_without * sums.right(i, c);
        }
    }
    for (int c = 0; c < 3; ++c) {
        L::store(result[c], chunk.result[c] + lane);
        L::store(checked[c], chunk.checked[c] + lane);
    }
}

template <class L, int kFeatures>
CAROM_KERNEL void regress(const RegressionChunk& chunk, int lane) {
    NormalSums<L, kFeatures> sums;
    sum_all<L, kFeatures>(chunk, lane, sums);
    solve<L, kFeatures>(chunk, lane, sums);
}

/// Whether the numbers from `index` on are the first one.
template <class L>
CAROM_KERNEL MaskOf<L> repeats_first(const float* numbers, int index) {
    return L::is_equal(L::load(numbers + index), L::all(numbers[0]));
}
