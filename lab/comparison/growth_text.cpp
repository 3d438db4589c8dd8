#include "lab/comparison/growth_text.h"

#include <algorithm>
#include <functional>
#include <optional>

#include <fmt/core.h>

#include "lab/comparison/curves.h"

namespace carom::pipeline {

namespace {

/// The shapes of a scene.
const char* shapes_of(GrowingScene scene) {
    return scene == GrowingScene::mesh ? "triangles" : name_of(scene);
}

/// A description of the scene.
const char* words_of(GrowingScene scene) {
    switch (scene) {
        case GrowingScene::spheres:
            return "spheres in a cube";
        case GrowingScene::balls:
            return "balls in a cube, half of them moving";
        case GrowingScene::mesh:
            break;
    }
    return "triangles of a torus knot";
}

/// A value of a point; empty if unknown.
using Quantity = std::function<std::optional<double>(const GrowthPoint&)>;

std::optional<double> objects_per_ray(const GrowthPoint& point) {
    const render::KindCounts total = point.tests.total();
    return point.is_counted && total.rays > 0
               ? std::optional(static_cast<double>(total.objects) / static_cast<double>(total.rays))
               : std::nullopt;
}

std::optional<double> boxes_per_ray(const GrowthPoint& point) {
    const render::KindCounts total = point.tests.total();
    return point.is_counted && total.rays > 0
               ? std::optional(static_cast<double>(total.boxes) / static_cast<double>(total.rays))
               : std::nullopt;
}

std::optional<double> tests_per_ray(const GrowthPoint& point) {
    const auto objects = objects_per_ray(point);
    return objects ? std::optional(*objects + *boxes_per_ray(point)) : std::nullopt;
}

Quantity nanoseconds(std::size_t kind) {
    return [kind](const GrowthPoint& point) { return 1e9 * point.seconds_per_ray[kind]; };
}

/// The mean over the three kinds of rays.
std::optional<double> nanoseconds_per_ray(const GrowthPoint& point) {
    return 1e9 * (point.seconds_per_ray[0] + point.seconds_per_ray[1] + point.seconds_per_ray[2]) /
           3;
}

Curves curves_of(const Growth& growth) {
    Curves curves{growth.structures, {}};
    for (const std::size_t shapes : growth.sizes()) {
        curves.across.push_back(static_cast<double>(shapes));
    }
    return curves;
}

CurveValue value_of(const Growth& growth, const Quantity& quantity) {
    return [&growth, quantity, sizes = growth.sizes()](std::size_t curve, std::size_t place) {
        const GrowthPoint* point = growth.point(growth.structures[curve], sizes[place]);
        return point != nullptr ? quantity(*point) : std::nullopt;
    };
}

std::string table_of(const Growth& growth, const std::string& title, const Quantity& quantity) {
    return table_of(curves_of(growth), title, value_of(growth, quantity));
}

LinePanel panel_of(const Growth& growth, const std::string& title, bool is_logarithmic,
                   const Quantity& quantity, const std::vector<std::string>& left_out = {}) {
    LinePanel panel =
        panel_of(curves_of(growth), title, is_logarithmic, value_of(growth, quantity));
    std::erase_if(panel.lines, [&](const ChartLine& line) {
        return std::ranges::find(left_out, line.name) != left_out.end();
    });
    return panel;
}

}  // namespace

const char* name_of(GrowingScene scene) {
    switch (scene) {
        case GrowingScene::spheres:
            return "spheres";
        case GrowingScene::balls:
            return "balls";
        case GrowingScene::mesh:
            break;
    }
    return "mesh";
}

std::string growth_text(const Growth& growth) {
    std::string text = std::string("growth: ") + words_of(growth.scene) + "\n";
    text += table_of(growth, "object tests per ray", objects_per_ray);
    text += table_of(growth, "box tests per ray", boxes_per_ray);
    text += table_of(growth, "ns per primary ray", nanoseconds(0));
    text += table_of(growth, "ns per secondary ray", nanoseconds(1));
    text += table_of(growth, "ns per shadow ray", nanoseconds(2));
    text += table_of(growth, "ns per ray of 64",
                     [](const GrowthPoint& point) { return 1e9 * point.seconds_per_ray_of_batch; });
    text += table_of(growth, "ns per shadow ray of 64", [](const GrowthPoint& point) {
        return 1e9 * point.seconds_per_shadow_ray_of_batch;
    });
    text += table_of(growth, "build ms",
                     [](const GrowthPoint& point) { return 1e3 * point.build_seconds; });
    text += table_of(growth, "memory MB", [](const GrowthPoint& point) {
        return 1e-6 * static_cast<double>(point.bytes);
    });
    return growth.is_whole ? text : text + "\ninterrupted: the rest is missing\n";
}

std::string growth_plot_svg(const Growth& growth, PlanPage page) {
    LineChart chart;
    chart.title = std::string("Growth with the number of ") + shapes_of(growth.scene);
    chart.explanation = "the same rays for all: from a camera, onwards, to a light; means of these";
    chart.across = shapes_of(growth.scene);
    chart.names = growth.structures;
    chart.panels = {panel_of(growth, "tests of objects and boxes per ray", true, tests_per_ray),
                    panel_of(growth, "the same: a logarithm is a straight line", false,
                             tests_per_ray, {"brute_force", "grid", "bsp"}),
                    panel_of(growth, "ns per ray", true, nanoseconds_per_ray)};
    return line_chart_svg(chart, page);
}

}  // namespace carom::pipeline
