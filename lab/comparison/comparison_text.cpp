#include "lab/comparison/comparison_text.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/core.h>

#include "lab/comparison/text_table.h"

namespace carom::pipeline {

namespace {

using render::KindCounts;
using render::TestCounts;

constexpr std::array<const char*, 3> kKinds{"primary", "secondary", "shadow"};

bool has_both_shadow_rays(const Comparison& comparison) {
    return std::ranges::any_of(comparison.rows, [&](const ComparedStructure& row) {
        return row.shadow_rays != comparison.rows.front().shadow_rays;
    });
}

std::string name_in(const Comparison& comparison, const ComparedStructure& row) {
    std::string name = row.name;
    if (has_both_shadow_rays(comparison)) {
        name += std::string(", ") + name_of(row.shadow_rays);
    }
    return name + (row.is_computed ? " *" : "");
}

double per_ray(std::uint64_t tests, const KindCounts& rays) {
    return rays.rays > 0 ? static_cast<double>(tests) / static_cast<double>(rays.rays) : 0;
}

std::string first_lines(const Comparison& comparison) {
    std::string text = fmt::format("{}: {}\n{}x{}, {} shapes, {} rays:", comparison.name,
                                   comparison.what, comparison.width, comparison.height,
                                   large_number(static_cast<double>(comparison.shapes)),
                                   large_number(static_cast<double>(comparison.rays.total().rays)));
    std::string kinds;
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        const std::uint64_t rays = comparison.rays.of[i].rays;
        if (rays > 0) {
            kinds += (kinds.empty() ? " " : ", ") + large_number(static_cast<double>(rays)) + " " +
                     kKinds[i];
        }
    }
    return text + kinds + "\n\n";
}

std::string costs(const Comparison& comparison) {
    TextTable table({"", "build ms", "memory kB", "object tests", "box tests", "CPU s", "Mrays/s",
                     "tests saved", "times as fast"});
    const auto rays = static_cast<double>(comparison.rays.total().rays);
    for (const ComparedStructure& row : comparison.rows) {
        const KindCounts total = row.tests.total();
        const ComparedStructure* brute_force_row = comparison.brute_force_row(row);
        std::vector<std::string> cells{name_in(comparison, row),
                                       short_number(1e3 * row.build_seconds),
                                       short_number(1e-3 * static_cast<double>(row.bytes))};
        cells.push_back(row.is_counted ? large_number(static_cast<double>(total.objects)) : "-");
        cells.push_back(row.is_counted ? large_number(static_cast<double>(total.boxes)) : "-");
        cells.push_back(short_number(row.cpu_seconds));
        cells.push_back(short_number(1e-6 * rays / row.cpu_seconds));
        const bool has_tests = brute_force_row != nullptr && row.is_counted && total.objects > 0;
        cells.push_back(
            has_tests ? short_number(static_cast<double>(brute_force_row->tests.total().objects) /
                                     static_cast<double>(total.objects)) +
                            "x"
                      : "-");
        cells.push_back(brute_force_row != nullptr
                            ? short_number(brute_force_row->cpu_seconds / row.cpu_seconds) + "x"
                            : "-");
        table.add(std::move(cells));
    }
    return table.text();
}

std::string tests_per_ray(const Comparison& comparison) {
    std::vector<std::size_t> kinds;
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        if (comparison.rays.of[i].rays > 0) {
            kinds.push_back(i);
        }
    }
    std::vector<std::string> header{"tests per ray"};
    for (const char* what : {"objects", "boxes", "nodes"}) {
        header.push_back(std::string(what) + ": all");
        for (const std::size_t kind : kinds) {
            header.emplace_back(kKinds[kind]);
        }
    }
    TextTable table(std::move(header));
    bool is_empty = true;
    for (const ComparedStructure& row : comparison.rows) {
        if (!row.is_counted) {
            continue;
        }
        is_empty = false;
        std::vector<std::string> cells{name_in(comparison, row)};
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
    if (std::ranges::any_of(comparison.rows, [](const auto& row) { return !row.is_counted; })) {
        text += "\n- not counted: a library does the tests, or a part of them\n";
    }
    if (!comparison.is_whole) {
        text += "\ninterrupted: the other structures are missing\n";
    }
    return text;
}

}  // namespace

const char* name_of(ShadowRays shadow_rays) {
    return shadow_rays == ShadowRays::any ? "any" : "closest";
}

std::string comparison_text(const Comparison& comparison) {
    return first_lines(comparison) + costs(comparison) + tests_per_ray(comparison) +
           notes(comparison);
}

}  // namespace carom::pipeline
