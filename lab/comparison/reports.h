// What was measured, as text and as charts.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"
#include "lab/comparison/growth.h"
#include "lab/comparison/motion.h"
#include "lab/comparison/size_curve.h"
#include "lab/triangle/measure.h"
#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// The scene, a table of costs, and a table of tests per ray by kind of ray.
[[nodiscard]] std::string report_text(const Comparison& comparison);
/// A table for each quantity, with a column for each structure; the rows are values of the size.
[[nodiscard]] std::string report_text(const SizeCurve& curve);
/// The rows are numbers of shapes.
[[nodiscard]] std::string report_text(const Growth& growth);
/// The rows are times of the shutter; a column for each structure and number of intervals.
[[nodiscard]] std::string report_text(const Motion& motion);
/// Tables of rates, one form per row and one packing per column; of errors; of the memory of a
/// triangle in each input; and, if they were measured, of perpendicular planes relative to Wald's,
/// of techniques relative to the plain variants, and of the second compiler relative to the first.
[[nodiscard]] std::string report_text(const render::triangle::KernelMeasurements& measured);

/// SVG documents, 297 mm wide. Bars for each structure, grouped by kind of ray: object tests per
/// ray, box tests per ray, and CPU time; logarithmic.
[[nodiscard]] std::string report_plot(const Comparison& comparison, PlanPage page);
/// Tests of objects, tests of boxes and CPU time over the size.
[[nodiscard]] std::string report_plot(const SizeCurve& curve, PlanPage page);
/// Tests per ray with both axes logarithmic; those of trees with a logarithmic horizontal axis
/// only, on which a logarithm is a straight line; and the time per ray.
[[nodiscard]] std::string report_plot(const Growth& growth, PlanPage page);
/// Over the time of the shutter: tests per ray, time per ray, and time per ray with its share of
/// the building.
[[nodiscard]] std::string report_plot(const Motion& motion, PlanPage page);
/// For each kernel and input, with the faster division, bars of the packings side by side; random
/// rays and the worst case, in float and in double.
[[nodiscard]] std::string report_plot(const render::triangle::KernelMeasurements& measured,
                                      PlanPage page);

}  // namespace carom::pipeline
