// How fast kernels are, and how exact.
#pragma once

#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "lab/triangle/variant.h"

namespace carom::render::triangle {

struct MeasureOptions {
    std::vector<KernelName> kernels;  // each in all its forms
    int rounds = 5;                   // every variant is timed once a round, all in turn
    int groups = 64;                  // of a timed set: 4096 tests each (test_set.h)
    int error_groups = 256;           // of the set for errors
    std::uint64_t seed = 1;
};

/// Millions of tests per second of CPU time, a number for each round. The same round is measured
/// within the same minute: ratios are best taken round by round.
struct VariantRates {
    Variant variant;
    std::vector<double> random;  // make_random_set
    std::vector<double> worst;   // make_worst_set
};

/// Against reference_hits(), over rays that hit something in a random set. All packings have the
/// same.
struct FormErrors {
    Form form;
    Precision precision = Precision::single_precision;
    double distance = 0;      // mean of |t - t'| / t'
    double weights = 0;       // mean of |u - u'| / u' and |v - v'| / v'
    double slipped = 0;       // share of the rays of make_edge_set() that hit neither triangle
    std::int64_t hits = 0;    // the rays that hit the same triangle
    std::int64_t others = 0;  // rays that hit another one, or one of both none
};

struct KernelMeasurements {
    std::vector<FormErrors> errors;
    std::vector<VariantRates> rates;  // in the order of all_forms(), then precision, then packing
    bool is_whole = false;            // false: stopped before the last round was over
};

/// One thread. When `stop` is triggered it ends soon with what is there: forms without errors and
/// variants without any rate are left out.
[[nodiscard]] KernelMeasurements measure_kernels(const MeasureOptions& options,
                                                 const WorkContext& context);

/// The greatest of the rounds: what else the machine does only ever slows. 0 if there is none.
[[nodiscard]] double best_rate(const std::vector<double>& rates);

/// The middle one of the ratios of the rounds that both have; 0 if there is none.
[[nodiscard]] double middle_ratio(const std::vector<double>& rates,
                                  const std::vector<double>& others);

}  // namespace carom::render::triangle
