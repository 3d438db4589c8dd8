// Measures the speed and the accuracy of kernels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/progress.h"
#include "lab/triangle/kernel_library.h"
#include "lab/triangle/variants.h"

namespace carom::render::triangle {

struct MeasureOptions {
    std::vector<KernelName> kernels;    // each in all its forms
    std::vector<Technique> techniques;  // measured besides the plain one
    std::vector<KernelLibrary> libraries = {own_kernels()};
    int rounds = 5;          // every variant is timed once per round, all in turn
    int groups = 64;         // in a timed set: 4096 tests each (test_set.h)
    int streamed = 1 << 20;  // triangles or rays in a set that exceeds the caches
    int error_groups = 256;  // in the set for errors
    std::uint64_t seed = 1;
};

/// Millions of tests per second of CPU time, one number per round. The rates of a round are
/// measured within the same minute, so that ratios are best taken round by round.
struct VariantRates {
    Variant variant;
    std::size_t library = 0;
    std::vector<double> random;  // make_random_set
    std::vector<double> worst;   // make_worst_set
    /// make_streamed_set; if layouts are measured, of variants that exist in several.
    std::vector<double> streamed;
};

/// Errors relative to reference_hits(), over the rays of a random set that hit something. They are
/// the same for all packings.
struct FormErrors {
    Form form;
    Precision precision = Precision::single_precision;
    Technique technique = Technique::plain;
    std::size_t library = 0;
    double distance = 0;      // mean of |t - t'| / t'
    double weights = 0;       // mean of |u - u'| / u' and |v - v'| / v'
    double slipped = 0;       // fraction of the rays of make_edge_set() that hit neither triangle
    std::int64_t hits = 0;    // the rays that hit the same triangle
    std::int64_t others = 0;  // rays that hit another triangle, or only in one of the two results
    std::int64_t rays = 0;
};

struct KernelMeasurements {
    std::vector<std::string> compilers;  // of the libraries
    std::vector<FormErrors> errors;
    std::vector<VariantRates> rates;  // in the order of the variants, then of the libraries
    bool is_whole = false;            // false: stopped before the end of the last round
};

/// Whether the technique has errors of its own; the others compute the bits of the plain one.
[[nodiscard]] constexpr bool changes_numbers(Technique technique) {
    return technique == Technique::newton || technique == Technique::sign_bits ||
           technique == Technique::axis_fixed;
}

/// Runs on one thread. If `stop` is triggered it ends soon and returns what was measured, without
/// forms that have no errors and variants that have no rate.
[[nodiscard]] KernelMeasurements measure_kernels(const MeasureOptions& options,
                                                 const WorkContext& context);

/// The greatest rate of the rounds, because other load on the machine only slows them down; 0 if
/// there are none.
[[nodiscard]] double best_rate(const std::vector<double>& rates);

/// The median ratio over the rounds that both have; 0 if there are none.
[[nodiscard]] double middle_ratio(const std::vector<double>& rates,
                                  const std::vector<double>& others);

}  // namespace carom::render::triangle
