// Reports whose quantities are curves: over a size, the number of shapes, the time of the shutter.
#include <algorithm>
#include <cmath>

#include "lab/comparison/curves.h"
#include "lab/comparison/reports.h"

namespace carom::pipeline {

namespace {

using render::KindCounts;

std::optional<double> per_ray(const StructureCost& cost, std::uint64_t KindCounts::*what) {
    const KindCounts total = cost.tests.total();
    return cost.is_counted && total.rays > 0
               ? std::optional(static_cast<double>(total.*what) / static_cast<double>(total.rays))
               : std::nullopt;
}

std::optional<double> objects(const StructureCost& cost) {
    return per_ray(cost, &KindCounts::objects);
}

std::optional<double> boxes(const StructureCost& cost) {
    return per_ray(cost, &KindCounts::boxes);
}

std::optional<double> tests(const StructureCost& cost) {
    const auto of_objects = objects(cost);
    return of_objects ? std::optional(*of_objects + *boxes(cost)) : std::nullopt;
}

double build_milliseconds(const StructureCost& cost) {
    return 1e3 * cost.build_seconds;
}

double kilobytes(const StructureCost& cost) {
    return 1e-3 * static_cast<double>(cost.bytes);
}

const char* end_of(bool is_whole) {
    return is_whole ? "" : "\ninterrupted: the rest is missing\n";
}

// ---- over a size

Curves<ComparedStructure> curves_of(const SizeCurve& curve) {
    Curves<ComparedStructure> curves{{}, curve.values, {}};
    for (const ComparedStructure& row : curve.comparisons.front().rows) {
        curves.names.push_back(row.name);
    }
    curves.point = [&curve, names = curves.names](std::size_t name, std::size_t place) {
        return curve.row(names[name], place);
    };
    return curves;
}

double cpu_seconds(const ComparedStructure& row) {
    return row.cpu_seconds;
}

// ---- over the number of shapes

Curves<GrowthPoint> curves_of(const Growth& growth) {
    const std::vector<std::size_t> sizes = growth.sizes();
    return {growth.structures,
            {sizes.begin(), sizes.end()},
            [&growth, sizes](std::size_t curve, std::size_t place) {
                return growth.point(growth.structures[curve], sizes[place]);
            }};
}

auto nanoseconds_of(render::RayKind kind) {
    return [kind](const GrowthPoint& point) {
        return 1e9 * point.seconds_per_ray[static_cast<std::size_t>(kind)];
    };
}

/// The mean over the three kinds of rays.
double mean_nanoseconds(const GrowthPoint& point) {
    const auto& seconds = point.seconds_per_ray;
    return 1e9 * (seconds[0] + seconds[1] + seconds[2]) / 3;
}

/// Of trees, which grow like a logarithm.
std::optional<double> tests_of_trees(const GrowthPoint& point) {
    const bool is_tree = point.name != "brute_force" && point.name != "grid" && point.name != "bsp";
    return is_tree ? tests(point) : std::nullopt;
}

// ---- over the time of the shutter

/// The number of rays per frame that share the cost of building in tables and charts.
constexpr double kRaysPerFrame = 1e6;

/// First all structures for the whole shutter, then those for the same number of intervals.
Curves<MotionPoint> curves_of(const Motion& motion) {
    std::vector<const MotionPoint*> points;
    for (const MotionPoint& point : motion.points) {
        points.push_back(&point);
    }
    std::ranges::stable_sort(points, {}, &MotionPoint::intervals);
    Curves<MotionPoint> curves{{}, motion.shutters, {}};
    for (const MotionPoint* point : points) {
        if (std::ranges::find(curves.names, point->full_name()) == curves.names.end()) {
            curves.names.push_back(point->full_name());
        }
    }
    curves.point = [&motion, names = curves.names](std::size_t curve, std::size_t place) {
        return motion.point(names[curve], motion.shutters[place]);
    };
    return curves;
}

double nanoseconds(const MotionPoint& point) {
    return 1e9 * point.seconds_per_ray;
}

double nanoseconds_with_building(const MotionPoint& point) {
    return 1e9 * (point.seconds_per_ray + point.build_seconds / kRaysPerFrame);
}

}  // namespace

std::string report_text(const SizeCurve& curve) {
    const Comparison& first = curve.comparisons.front();
    return fmt::format(
               "{}: {}\n{}x{}, {} shapes, {} rays; the first column: {}\n", first.name, first.what,
               first.width, first.height, large_number(static_cast<double>(first.shapes)),
               large_number(static_cast<double>(first.rays.total().rays)), facts(curve.size).unit) +
           curves_of(curve).tables({{"object tests per ray", objects},
                                    {"box tests per ray", boxes},
                                    {"CPU s", cpu_seconds},
                                    {"build ms", build_milliseconds},
                                    {"memory kB", kilobytes}}) +
           end_of(curve.is_whole);
}

std::string report_plot(const SizeCurve& curve, PlanPage page) {
    const auto curves = curves_of(curve);
    const Comparison& first = curve.comparisons.front();
    const std::string unit(facts(curve.size).unit);
    return line_chart_svg({fmt::format("{}: {}", first.name, unit),
                           fmt::format("{}, {} x {} pixels", first.what, first.width, first.height),
                           curves.names,
                           {curves.panel("object tests per ray", true, objects),
                            curves.panel("box tests per ray", true, boxes),
                            curves.panel("CPU time of the frame, s", false, cpu_seconds)}},
                          curves.across, unit, page);
}

std::string report_text(const Growth& growth) {
    return fmt::format("growth: {}\n", facts(growth.scene).what) +
           curves_of(growth).tables(
               {{"object tests per ray", objects},
                {"box tests per ray", boxes},
                {"ns per primary ray", nanoseconds_of(render::RayKind::primary)},
                {"ns per secondary ray", nanoseconds_of(render::RayKind::secondary)},
                {"ns per shadow ray", nanoseconds_of(render::RayKind::shadow)},
                {"ns per ray of 64",
                 [](const GrowthPoint& point) { return 1e9 * point.seconds_per_ray_of_batch; }},
                {"ns per shadow ray of 64",
                 [](const GrowthPoint& point) {
                     return 1e9 * point.seconds_per_shadow_ray_of_batch;
                 }},
                {"build ms", build_milliseconds},
                {"memory MB", [](const GrowthPoint& point) { return 1e-3 * kilobytes(point); }}}) +
           end_of(growth.is_whole);
}

std::string report_plot(const Growth& growth, PlanPage page) {
    const auto curves = curves_of(growth);
    const std::string shapes(facts(growth.scene).shapes);
    return line_chart_svg(
        {"Growth with the number of " + shapes,
         "the same rays for all: from a camera, onwards, to a light; means of these",
         curves.names,
         {curves.panel("tests of objects and boxes per ray", true, tests),
          curves.panel("the same: a logarithm is a straight line", false, tests_of_trees),
          curves.panel("ns per ray", true, mean_nanoseconds)}},
        curves.across, shapes, page);
}

std::string report_text(const Motion& motion) {
    return fmt::format(
               "motion: {} balls, half of which move, at up to 2 m/s, with an impact about "
               "every 0.1 s; the first column: how long the shutter is open, s\n",
               motion.balls) +
           curves_of(motion).tables(
               {{"object tests per ray", objects},
                {"box tests per ray", boxes},
                {"ns per ray", nanoseconds},
                {"build ms", build_milliseconds},
                {"ns per ray with the building, 10^6 rays", nanoseconds_with_building},
                {"thousands of rays from which intervals pay",
                 [&](const MotionPoint& point) {
                     const double rays = motion.break_even(point);
                     return std::isfinite(rays) ? std::optional(1e-3 * rays) : std::nullopt;
                 }},
                {"memory kB", kilobytes}}) +
           end_of(motion.is_whole);
}

std::string report_plot(const Motion& motion, PlanPage page) {
    const auto curves = curves_of(motion);
    return line_chart_svg(
        {fmt::format("{} balls, half of which move", motion.balls),
         "a structure for the whole shutter, or one for each of several equal intervals of it",
         curves.names,
         {curves.panel("tests of objects and boxes per ray", true, tests),
          curves.panel("ns per ray", true, nanoseconds),
          curves.panel("the same with the building, 1M rays", true, nanoseconds_with_building)}},
        curves.across, "the shutter is open, s", page);
}

}  // namespace carom::pipeline
