// What a structure over moving shapes costs as the shutter stays open longer.
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "lab/comparison/comparison.h"

namespace carom::pipeline {

struct MotionOptions {
    std::vector<render::AccelerationKind> structures;
    std::size_t balls = 1000;
    /// Numbers of equal parts into which the shutter is divided, each with a structure of its own.
    std::vector<int> intervals{1, 4, 16};
    std::vector<double> shutters{0,        1.0 / 256, 1.0 / 128, 1.0 / 64, 1.0 / 32,
                                 1.0 / 16, 1.0 / 8,   1.0 / 4,   1.0 / 2,  1};  // s
    double most_tests = 1e9;      // structures without an order get fewer rays beyond this number
    double enough_seconds = 0.1;  // CPU time spent on the rays, at least
};

/// One structure for each of `intervals` parts of one shutter. Building and bytes are those of all
/// parts.
struct MotionPoint : StructureCost {
    int intervals = 1;
    double shutter = 0;          // s
    std::size_t shapes = 0;      // of the whole shutter: a ball has one for each leg of its path
    double seconds_per_ray = 0;  // CPU time of intersection alone, the mean over all rays
    double hits = 0;             // the fraction of rays that hit something

    /// "bvh" or, for several parts, "bvh, 4 intervals".
    [[nodiscard]] std::string full_name() const;
};

struct Motion {
    std::size_t balls = 0;
    std::vector<double> shutters;     // ascending
    std::vector<MotionPoint> points;  // by shutter, then by structure, then by intervals
    bool is_whole = false;

    /// Null if it was not measured.
    [[nodiscard]] const MotionPoint* point(const std::string& full_name, double shutter) const;
    /// The number of rays from which the parts of `point` cost less than one structure for the
    /// whole shutter; infinite if they never do.
    [[nodiscard]] double break_even(const MotionPoint& point) const;
};

/// Every structure gets the same rays at random times, as in measure_growth. A closed shutter, 0 s,
/// is measured without parts. If `stop` is triggered, the points measured are returned. Throws
/// Error.
[[nodiscard]] Motion measure_motion(const MotionOptions& options,
                                    const ComparisonProgress& progress,
                                    const std::stop_token& stop);

}  // namespace carom::pipeline
