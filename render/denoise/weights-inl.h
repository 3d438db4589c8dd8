// Weights of neighbours by the likeness of the patches around them: non-local means. Included once
// per instruction set.
#include "render/denoise/denoise_kernels.h"
#include "render/denoise/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// The sum over the channels of
///   ((u_p - u_q)^2 - (V_p + min(V_q, V_p))) / (e + k^2 (V_p + V_q))
/// for pixels p, neighbours q, colours u, their variances V and the bandwidth k (Rousselle, Knaus
/// and Zwicker 2012, "Adaptive rendering with non-local means filtering", equation 4).
inline HWY_ATTR void measure_distances(const DistanceRow& row) {
    constexpr float kLeastVariance = 1e-10f;
    for (int x = 0; x < row.chunks * kChunk; x += lane_count()) {
        const F bandwidth2 = load(row.bandwidth2 + x);
        F excess[3];
        F scale[3];
        for (int c = 0; c < 3; ++c) {
            const F difference = minus(load(row.colour[c] + x), load(row.other_colour[c] + x));
            const F v = load(row.variance[c] + x);
            const F other = load(row.other_variance[c] + x);
            excess[c] = minus(product(difference, difference), sum(v, hn::Min(other, v)));
            scale[c] = sum(all(kLeastVariance), product(bandwidth2, sum(v, other)));
        }
        // With one division; the scales' product is at least 1e-30 and at most 1e31.
        const F both = product(scale[0], scale[1]);
        const F of_both = sum(product(excess[0], scale[1]), product(excess[1], scale[0]));
        const F total = sum(product(of_both, scale[2]), product(excess[2], both));
        store(quotient(total, product(both, scale[2])), row.distance + x);
    }
}

/// exp(-max(0, d)), where d is the mean over the patch and the channels.
inline HWY_ATTR void weigh(const WeightRow& row) {
    constexpr float kFarthest = 20;  // a weight of 2e-9
    constexpr float kSide = 2 * kPatch + 1;
    static_assert(kPatch == 1);
    const F scale = all(1 / (3 * kSide * kSide));
    const F width = all(static_cast<float>(row.width));
    const auto column = [&](int x) HWY_ATTR {
        return sum(sum(load(row.distance[0] + x), load(row.distance[1] + x)),
                   load(row.distance[2] + x));
    };
    for (int x = 0; x < row.chunks * kChunk; x += lane_count()) {
        const F patch = sum(sum(column(x), column(x + 1)), column(x + 2));
        const F distance = hn::Max(all(0.f), product(patch, scale));
        const F weight = exponential_of_negative(hn::Min(distance, all(kFarthest)));
        const F neighbour = hn::Iota(FloatTag(), static_cast<float>(row.neighbour + x));
        const auto exists = hn::And(hn::Ge(neighbour, all(0.f)), hn::Lt(neighbour, width));
        const auto counts = hn::And(exists, hn::Lt(distance, all(kFarthest)));
        const int chunk = x / kChunk;
        store(hn::IfThenElseZero(counts, weight),
              row.weight + std::ptrdiff_t{chunk} * kNeighbours * kChunk + x % kChunk);
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
