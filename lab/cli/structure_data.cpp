#include "lab/cli/data_row.h"
#include "lab/cli/report_data.h"

namespace carom::cli {

namespace {

using pipeline::ComparedStructure;
using pipeline::Comparison;
using render::KindCounts;
using render::TestCounts;

/// Null counts are unknown.
void add_tests(DataRow& row, const TestCounts* rays, const TestCounts* tests) {
    const auto add = [&](const std::string& name, const TestCounts* counts, std::size_t kind,
                         std::uint64_t KindCounts::*what) {
        counts != nullptr ? row.add(name, counts->of[kind].*what) : row.add_unknown(name);
    };
    for (std::size_t i = 0; i < render::kRayKindNames.size(); ++i) {
        const std::string kind = render::kRayKindNames[i];
        add(kind + "_rays", rays, i, &KindCounts::rays);
        add(kind + "_objects", tests, i, &KindCounts::objects);
        add(kind + "_boxes", tests, i, &KindCounts::boxes);
        add(kind + "_nodes", tests, i, &KindCounts::nodes);
    }
}

void add_row(DataRow& data, const Comparison& comparison, const ComparedStructure& row) {
    data.add("structure", row.name)
        .add("shadow_query", name_of(row.shadow_rays))
        .add("build_seconds", row.build_seconds)
        .add("bytes", row.bytes)
        .add("cpu_seconds", row.cpu_seconds)
        .add("computed", row.is_computed)
        .add("counted", row.is_counted);
    add_tests(data, &comparison.rays, row.is_counted ? &row.tests : nullptr);
}

std::vector<DataRow> rows_of(const Comparison& comparison) {
    std::vector<DataRow> rows;
    for (const ComparedStructure& row : comparison.rows) {
        add_row(rows.emplace_back(), comparison, row);
    }
    return rows;
}

std::vector<DataRow> rows_of(const pipeline::SizeCurve& curve) {
    std::vector<DataRow> rows;
    for (std::size_t i = 0; i < curve.comparisons.size(); ++i) {
        for (const ComparedStructure& row : curve.comparisons[i].rows) {
            rows.emplace_back().add(facts(curve.size).name, curve.values[i]);
            add_row(rows.back(), curve.comparisons[i], row);
        }
    }
    return rows;
}

std::vector<DataRow> rows_of(const pipeline::Growth& growth) {
    std::vector<DataRow> rows;
    for (const pipeline::GrowthPoint& point : growth.points) {
        DataRow& row = rows.emplace_back();
        row.add("structure", point.name)
            .add("shapes", point.shapes)
            .add("build_seconds", point.build_seconds)
            .add("bytes", point.bytes);
        for (std::size_t i = 0; i < render::kRayKindNames.size(); ++i) {
            row.add(std::string("seconds_per_") + render::kRayKindNames[i] + "_ray",
                    point.seconds_per_ray[i]);
        }
        row.add("seconds_per_ray_of_batch", point.seconds_per_ray_of_batch)
            .add("seconds_per_shadow_ray_of_batch", point.seconds_per_shadow_ray_of_batch);
        const TestCounts* tests = point.is_counted ? &point.tests : nullptr;
        add_tests(row, tests, tests);
    }
    return rows;
}

std::vector<DataRow> rows_of(const pipeline::Motion& motion) {
    std::vector<DataRow> rows;
    for (const pipeline::MotionPoint& point : motion.points) {
        DataRow& row = rows.emplace_back();
        row.add("structure", point.name)
            .add("intervals", point.intervals)
            .add("shutter", point.shutter)
            .add("shapes", point.shapes)
            .add("build_seconds", point.build_seconds)
            .add("bytes", point.bytes)
            .add("seconds_per_ray", point.seconds_per_ray)
            .add("break_even_rays", motion.break_even(point));
        const TestCounts* tests = point.is_counted ? &point.tests : nullptr;
        add_tests(row, tests, tests);
    }
    return rows;
}

/// The column before all others, which is the first member of the object.
DataRow first_of(const Comparison& comparison) {
    return DataRow().add("scene", comparison.name);
}

DataRow first_of(const pipeline::SizeCurve& curve) {
    return first_of(curve.comparisons.front());
}

DataRow first_of(const pipeline::Growth& growth) {
    return DataRow().add("growth", facts(growth.scene).name);
}

DataRow first_of(const pipeline::Motion& motion) {
    return DataRow().add("balls", motion.balls);
}

void add_scene(DataRow& row, const Comparison& comparison) {
    row.add("what", comparison.what)
        .add("width", comparison.width)
        .add("height", comparison.height)
        .add("shapes", comparison.shapes);
    for (std::size_t i = 0; i < render::kRayKindNames.size(); ++i) {
        row.add(std::string(render::kRayKindNames[i]) + "_rays", comparison.rays.of[i].rays);
    }
}

std::string object_of(DataRow& first, bool is_whole, const char* name,
                      const std::vector<DataRow>& rows) {
    first.add("whole", is_whole);
    return "{" + first.members().text() + ",\n\"" + name + "\":" + DataRow::json(rows) + "}\n";
}

}  // namespace

std::string report_json(const Comparison& comparison) {
    DataRow first = first_of(comparison);
    add_scene(first, comparison);
    return object_of(first, comparison.is_whole, "structures", rows_of(comparison));
}

std::string report_json(const pipeline::SizeCurve& curve) {
    DataRow first = first_of(curve);
    add_scene(first, curve.comparisons.front());
    first.add("varied", facts(curve.size).name);
    return object_of(first, curve.is_whole, "points", rows_of(curve));
}

std::string report_json(const pipeline::Growth& growth) {
    DataRow first = first_of(growth);
    return object_of(first, growth.is_whole, "points", rows_of(growth));
}

std::string report_json(const pipeline::Motion& motion) {
    DataRow first = first_of(motion);
    return object_of(first, motion.is_whole, "points", rows_of(motion));
}

std::string report_csv(const Comparison& comparison) {
    return DataRow::csv(first_of(comparison), rows_of(comparison));
}

std::string report_csv(const pipeline::SizeCurve& curve) {
    return DataRow::csv(first_of(curve), rows_of(curve));
}

std::string report_csv(const pipeline::Growth& growth) {
    return DataRow::csv(first_of(growth), rows_of(growth));
}

std::string report_csv(const pipeline::Motion& motion) {
    return DataRow::csv(first_of(motion), rows_of(motion));
}

}  // namespace carom::cli
