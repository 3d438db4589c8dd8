#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "lab/comparison/chart.h"
#include "lab/comparison/reports.h"
#include "lab/comparison/text_table.h"

namespace carom::pipeline {

namespace {

using render::KindCounts;

std::string name_in(const Comparison& comparison, const ComparedStructure& row) {
    const bool has_both = std::ranges::any_of(comparison.rows, [&](const ComparedStructure& other) {
        return other.shadow_rays != row.shadow_rays;
    });
    return has_both ? row.name + ", " + name_of(row.shadow_rays) : row.name;
}

std::string name_with_mark(const Comparison& comparison, const ComparedStructure& row) {
    return name_in(comparison, row) + (row.is_computed ? " *" : "");
}

/// The kinds of which there are rays, as indices.
std::vector<std::size_t> kinds_of(const Comparison& comparison) {
    std::vector<std::size_t> kinds;
    for (std::size_t i = 0; i < render::kRayKindNames.size(); ++i) {
        if (comparison.rays.of[i].rays > 0) {
            kinds.push_back(i);
        }
    }
    return kinds;
}

double per_ray(std::uint64_t tests, const KindCounts& rays) {
    return rays.rays > 0 ? static_cast<double>(tests) / static_cast<double>(rays.rays) : 0;
}

std::string large(std::uint64_t number) {
    return large_number(static_cast<double>(number));
}

std::string first_lines(const Comparison& comparison) {
    std::string kinds;
    for (const std::size_t kind : kinds_of(comparison)) {
        kinds += fmt::format("{} {} {}", kinds.empty() ? "" : ",",
                             large(comparison.rays.of[kind].rays), render::kRayKindNames[kind]);
    }
    return fmt::format("{}: {}\n{}x{}, {} shapes, {} rays:{}\n\n", comparison.name, comparison.what,
                       comparison.width, comparison.height, large(comparison.shapes),
                       large(comparison.rays.total().rays), kinds);
}

std::string costs(const Comparison& comparison) {
    TextTable table({"", "build ms", "memory kB", "object tests", "box tests", "CPU s", "Mrays/s",
                     "tests saved", "times as fast"});
    const auto rays = static_cast<double>(comparison.rays.total().rays);
    const auto known = [](bool is_known, const std::string& text) { return is_known ? text : "-"; };
    const auto times = [](double number, double other) {
        return short_number(number / other) + "x";
    };
    for (const ComparedStructure& row : comparison.rows) {
        const KindCounts total = row.tests.total();
        const ComparedStructure* brute_force = comparison.brute_force_row(row);
        const ComparedStructure& other = brute_force != nullptr ? *brute_force : row;
        table.add({name_with_mark(comparison, row), short_number(1e3 * row.build_seconds),
                   short_number(1e-3 * static_cast<double>(row.bytes)),
                   known(row.is_counted, large(total.objects)),
                   known(row.is_counted, large(total.boxes)), short_number(row.cpu_seconds),
                   short_number(1e-6 * rays / row.cpu_seconds),
                   known(brute_force != nullptr && row.is_counted && total.objects > 0,
                         times(static_cast<double>(other.tests.total().objects),
                               static_cast<double>(total.objects))),
                   known(brute_force != nullptr, times(other.cpu_seconds, row.cpu_seconds))});
    }
    return table.text();
}

std::string tests_per_ray(const Comparison& comparison) {
    const std::vector<std::size_t> kinds = kinds_of(comparison);
    std::vector<std::string> header{"tests per ray"};
    for (const char* what : {"objects", "boxes", "nodes"}) {
        header.push_back(std::string(what) + ": all");
        for (const std::size_t kind : kinds) {
            header.emplace_back(render::kRayKindNames[kind]);
        }
    }
    TextTable table(std::move(header));
    bool is_empty = true;
    for (const ComparedStructure& row : comparison.rows) {
        if (!row.is_counted) {
            continue;
        }
        is_empty = false;
        std::vector<std::string> cells{name_with_mark(comparison, row)};
        for (std::uint64_t KindCounts::*what :
             {&KindCounts::objects, &KindCounts::boxes, &KindCounts::nodes}) {
            const KindCounts total = row.tests.total();
            cells.push_back(short_number(per_ray(total.*what, total)));
            for (const std::size_t kind : kinds) {
                const KindCounts& counts = row.tests.of[kind];
                cells.push_back(short_number(per_ray(counts.*what, counts)));
            }
        }
        table.add(std::move(cells));
    }
    return is_empty ? "" : "\n" + table.text();
}

std::string notes(const Comparison& comparison) {
    std::string text;
    if (std::ranges::any_of(comparison.rows, &ComparedStructure::is_computed)) {
        text +=
            "\n* computed: rays times shapes; how soon shadow rays end, and the time, from a part "
            "of the picture\n";
    }
    if (!std::ranges::all_of(comparison.rows, &ComparedStructure::is_counted)) {
        text += "\n- not counted: a library does the tests, or a part of them\n";
    }
    if (!comparison.is_whole) {
        text += "\ninterrupted: the other structures are missing\n";
    }
    return text;
}

}  // namespace

std::string report_text(const Comparison& comparison) {
    return first_lines(comparison) + costs(comparison) + tests_per_ray(comparison) +
           notes(comparison);
}

std::string report_plot(const Comparison& comparison, PlanPage page) {
    Chart chart{
        comparison.name,
        fmt::format("{}, {} x {} pixels", comparison.what, comparison.width, comparison.height),
        {},
        {{"object tests per ray", true, {}},
         {"box tests per ray", true, {}},
         {"CPU time of the frame, s", true, {}, true}}};
    const std::vector<std::size_t> kinds = kinds_of(comparison);
    for (const std::size_t kind : kinds) {
        chart.series.push_back(fmt::format("{} rays", render::kRayKindNames[kind]));
    }
    std::vector<std::string> groups;
    for (const ComparedStructure& row : comparison.rows) {
        groups.push_back(name_in(comparison, row));
        std::vector<double>& objects = chart.panels[0].values.emplace_back();
        std::vector<double>& boxes = chart.panels[1].values.emplace_back();
        for (const std::size_t kind : kinds) {
            const KindCounts counts = row.is_counted ? row.tests.of[kind] : KindCounts{};
            objects.push_back(per_ray(counts.objects, counts));
            boxes.push_back(per_ray(counts.boxes, counts));
        }
        chart.panels[2].values.push_back({row.cpu_seconds});
    }
    return bar_chart_svg(chart, groups, page);
}

}  // namespace carom::pipeline
