// A sweep: what is measured of a shot while the values of some of its keys are varied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/config/measures/measures.h"
#include "pipeline/config/shot_variants.h"
#include "pipeline/study/sampling.h"
#include "pipeline/study/varied_key.h"
#include "pipeline/variants/variants.h"

namespace carom::pipeline::study {

using measures::Measure;
using measures::Value;

struct Sweep {
    std::vector<VariedKey> keys;
    std::vector<Measure> measures;
    std::size_t samples = 1;  // of the sampled keys, for each combination of the listed values
    Sampling sampling = Sampling::sobol;
    std::uint64_t seed = 0;
};

/// The variants of a sweep in order: the first listed key changes slowest, samples change fastest
/// and are the same for each combination.
class SweepPoints {
  public:
    explicit SweepPoints(const Sweep& sweep);

    [[nodiscard]] std::size_t count() const { return count_; }
    /// The value of each key.
    [[nodiscard]] std::vector<VariedPoint> at(std::size_t index) const;

  private:
    const Sweep* sweep_;
    std::vector<std::vector<VariedPoint>> samples_;  // of the sampled keys
    std::size_t count_ = 1;
};

/// The number of variants, or the largest number if there are more.
[[nodiscard]] std::size_t variant_count(const Sweep& sweep);

struct SweepColumn {
    std::string title;         // "rebound_angle:cue [deg]"
    bool is_measured = false;  // else varied
};

struct SweepTable {
    std::vector<SweepColumn> columns;      // the keys, then the measures
    std::vector<std::vector<Value>> rows;  // of the variants that were simulated, in order
    std::size_t variants = 0;              // of the whole sweep
    std::size_t unfinished = 0;            // variants that took more steps than allowed
    std::size_t warned = 0;                // variants of which the simulation warned
    std::string first_warning;             // of the first of them
};

/// The most steps (bake_within) of one variant.
inline constexpr std::uint64_t kMostSteps = 100'000'000;

/// The problems of all variants, each of them once; empty if all can be simulated.
[[nodiscard]] std::vector<Problem> find_problems(const Sweep& sweep, const ShotVariants& variants,
                                                 const PartsWork& work = {});

/// Simulates all variants, which have no problems. After a stop the table has those that were
/// finished.
[[nodiscard]] SweepTable run_sweep(const Sweep& sweep, const ShotVariants& variants,
                                   const PartsWork& work = {});

/// The table as CSV (RFC 4180), with titles; nothing is an empty field.
[[nodiscard]] std::string csv_of(const SweepTable& table);
/// One JSON object for each variant, with titles as names; nothing is null.
[[nodiscard]] std::string json_lines_of(const SweepTable& table);

}  // namespace carom::pipeline::study
