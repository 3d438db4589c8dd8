#include "lab/comparison/comparison_plot.h"

#include <array>

#include <fmt/core.h>

#include "lab/comparison/bar_chart.h"
#include "lab/comparison/comparison_text.h"

namespace carom::pipeline {

std::string comparison_plot_svg(const Comparison& comparison, PlanPage page) {
    BarChart chart;
    chart.title = comparison.name;
    chart.explanation =
        fmt::format("{}, {} x {} pixels", comparison.what, comparison.width, comparison.height);
    const std::array<const char*, 3> kinds{"primary rays", "secondary rays", "shadow rays"};
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (comparison.rays.of[i].rays > 0) {
            used.push_back(i);
            chart.series.emplace_back(kinds[i]);
        }
    }
    BarPanel objects{"object tests per ray", {}, false};
    BarPanel boxes{"box tests per ray", {}, false};
    BarPanel seconds{"CPU time of the frame, s", {}, true};
    for (const ComparedStructure& row : comparison.rows) {
        const bool is_both = row.shadow_rays != comparison.rows.front().shadow_rays ||
                             row.shadow_rays != comparison.rows.back().shadow_rays;
        chart.groups.push_back(is_both ? row.name + ", " + name_of(row.shadow_rays) : row.name);
        std::vector<double> object_bars;
        std::vector<double> box_bars;
        for (const std::size_t kind : used) {
            const render::KindCounts& counts = row.tests.of[kind];
            const auto rays = static_cast<double>(counts.rays);
            const bool is_known = row.is_counted && counts.rays > 0;
            object_bars.push_back(is_known ? static_cast<double>(counts.objects) / rays : 0);
            box_bars.push_back(is_known ? static_cast<double>(counts.boxes) / rays : 0);
        }
        objects.bars.push_back(std::move(object_bars));
        boxes.bars.push_back(std::move(box_bars));
        seconds.bars.push_back({row.cpu_seconds});
    }
    chart.panels = {std::move(objects), std::move(boxes), std::move(seconds)};
    return bar_chart_svg(chart, page);
}

}  // namespace carom::pipeline
