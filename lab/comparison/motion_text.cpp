#include "lab/comparison/motion_text.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/core.h>

#include "lab/comparison/curves.h"

namespace carom::pipeline {

namespace {

/// A value of a point; empty if unknown.
using Quantity = std::function<std::optional<double>(const MotionPoint&)>;

double per_ray(std::uint64_t tests, const MotionPoint& point) {
    return static_cast<double>(tests) / static_cast<double>(point.tests.total().rays);
}

std::optional<double> objects(const MotionPoint& point) {
    return point.is_counted ? std::optional(per_ray(point.tests.total().objects, point))
                            : std::nullopt;
}

std::optional<double> boxes(const MotionPoint& point) {
    return point.is_counted ? std::optional(per_ray(point.tests.total().boxes, point))
                            : std::nullopt;
}

std::optional<double> tests(const MotionPoint& point) {
    return point.is_counted ? std::optional(*objects(point) + *boxes(point)) : std::nullopt;
}

double nanoseconds(const MotionPoint& point) {
    return 1e9 * point.seconds_per_ray;
}

double nanoseconds_with_building(const MotionPoint& point) {
    return 1e9 * point.seconds_with_building(kRaysPerFrame);
}

/// First all structures for the whole shutter, then those for the same number of intervals.
Curves curves_of(const Motion& motion) {
    std::vector<const MotionPoint*> points;
    for (const MotionPoint& point : motion.points) {
        points.push_back(&point);
    }
    std::ranges::stable_sort(points, {}, &MotionPoint::intervals);
    Curves curves{{}, motion.shutters};
    for (const MotionPoint* point : points) {
        if (std::ranges::find(curves.names, point->name()) == curves.names.end()) {
            curves.names.push_back(point->name());
        }
    }
    return curves;
}

CurveValue value_of(const Motion& motion, const Curves& curves, const Quantity& quantity) {
    return [&motion, &curves, quantity](std::size_t curve, std::size_t place) {
        const MotionPoint* point = motion.point(curves.names[curve], motion.shutters[place]);
        return point != nullptr ? quantity(*point) : std::nullopt;
    };
}

}  // namespace

std::string motion_text(const Motion& motion) {
    std::string text = fmt::format(
        "motion: {} balls, half of which move, at up to 2 m/s, with an impact about "
        "every 0.1 s; the first column: how long the shutter is open, s\n",
        motion.balls);
    const Curves curves = curves_of(motion);
    const auto add = [&](const char* title, const Quantity& quantity) {
        text += table_of(curves, title, value_of(motion, curves, quantity));
    };
    add("object tests per ray", objects);
    add("box tests per ray", boxes);
    add("ns per ray", nanoseconds);
    add("build ms", [](const MotionPoint& point) { return 1e3 * point.build_seconds; });
    add("ns per ray with the building, 10^6 rays", nanoseconds_with_building);
    add("thousands of rays from which intervals pay", [&](const MotionPoint& point) {
        const double rays = motion.break_even(point);
        return std::isfinite(rays) ? std::optional(1e-3 * rays) : std::nullopt;
    });
    add("memory kB",
        [](const MotionPoint& point) { return 1e-3 * static_cast<double>(point.bytes); });
    return motion.is_whole ? text : text + "\ninterrupted: the rest is missing\n";
}

std::string motion_plot_svg(const Motion& motion, PlanPage page) {
    const Curves curves = curves_of(motion);
    LineChart chart;
    chart.title = fmt::format("{} balls, half of which move", motion.balls);
    chart.explanation =
        "a structure for the whole shutter, or one for each of several equal intervals of it";
    chart.across = "the shutter is open, s";
    chart.names = curves.names;
    chart.panels = {panel_of(curves, "tests of objects and boxes per ray", true,
                             value_of(motion, curves, tests)),
                    panel_of(curves, "ns per ray", true, value_of(motion, curves, nanoseconds)),
                    panel_of(curves, "the same with the building, 1M rays", true,
                             value_of(motion, curves, nanoseconds_with_building))};
    return line_chart_svg(chart, page);
}

}  // namespace carom::pipeline
