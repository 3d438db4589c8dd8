#include "lab/comparison/size_text.h"

#include <fmt/core.h>

#include "lab/comparison/curves.h"
#include "lab/comparison/text_table.h"

namespace carom::pipeline {

namespace {

using render::KindCounts;
using render::VariedSize;

const char* unit_of(VariedSize size) {
    switch (size) {
        case VariedSize::leaf_capacity:
            return "shapes to a leaf";
        case VariedSize::node_capacity:
            return "children of a node";
        case VariedSize::grid_density:
            break;
    }
    return "cells per shape";
}

using Quantity = double (*)(const ComparedStructure& row);

double per_ray(const ComparedStructure& row, std::uint64_t KindCounts::*what) {
    const KindCounts total = row.tests.total();
    return total.rays > 0 ? static_cast<double>(total.*what) / static_cast<double>(total.rays) : 0;
}

double objects(const ComparedStructure& row) {
    return per_ray(row, &KindCounts::objects);
}

double boxes(const ComparedStructure& row) {
    return per_ray(row, &KindCounts::boxes);
}

double cpu_seconds(const ComparedStructure& row) {
    return row.cpu_seconds;
}

double build_milliseconds(const ComparedStructure& row) {
    return 1e3 * row.build_seconds;
}

double kilobytes(const ComparedStructure& row) {
    return 1e-3 * static_cast<double>(row.bytes);
}

Curves curves_of(const SizeCurve& curve) {
    Curves curves{{}, curve.values};
    for (const ComparedStructure& row : curve.comparisons.front().rows) {
        curves.names.push_back(row.name);
    }
    return curves;
}

CurveValue value_of(const SizeCurve& curve, const Curves& curves, Quantity quantity) {
    return [&curve, &curves, quantity](std::size_t name, std::size_t place) {
        const ComparedStructure* row = curve.row(curves.names[name], place);
        return row != nullptr ? std::optional(quantity(*row)) : std::nullopt;
    };
}

}  // namespace

std::string size_text(const SizeCurve& curve) {
    const Comparison& first = curve.comparisons.front();
    std::string text = fmt::format(
        "{}: {}\n{}x{}, {} shapes, {} rays; the first column: {}\n", first.name, first.what,
        first.width, first.height, large_number(static_cast<double>(first.shapes)),
        large_number(static_cast<double>(first.rays.total().rays)), unit_of(curve.size));
    const Curves curves = curves_of(curve);
    const auto add = [&](const char* title, Quantity quantity) {
        text += table_of(curves, title, value_of(curve, curves, quantity));
    };
    add("object tests per ray", objects);
    add("box tests per ray", boxes);
    add("CPU s", cpu_seconds);
    add("build ms", build_milliseconds);
    add("memory kB", kilobytes);
    return curve.is_whole ? text : text + "\ninterrupted: the rest is missing\n";
}

std::string size_plot_svg(const SizeCurve& curve, PlanPage page) {
    const Curves curves = curves_of(curve);
    const Comparison& first = curve.comparisons.front();
    LineChart chart;
    chart.title = fmt::format("{}: {}", first.name, unit_of(curve.size));
    chart.explanation = fmt::format("{}, {} x {} pixels", first.what, first.width, first.height);
    chart.across = unit_of(curve.size);
    chart.names = curves.names;
    chart.panels = {
        panel_of(curves, "object tests per ray", true, value_of(curve, curves, objects)),
        panel_of(curves, "box tests per ray", true, value_of(curve, curves, boxes)),
        panel_of(curves, "CPU time of the frame, s", false, value_of(curve, curves, cpu_seconds))};
    return line_chart_svg(chart, page);
}

}  // namespace carom::pipeline
