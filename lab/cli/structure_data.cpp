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

DataRow first_of(const Comparison& comparison) {
    return DataRow().add("scene", comparison.name);
}

DataRow scene_of(const Comparison& comparison) {
    DataRow row;
    row.add("what", comparison.what)
        .add("width", comparison.width)
        .add("height", comparison.height)
        .add("shapes", comparison.shapes);
    for (std::size_t i = 0; i < render::kRayKindNames.size(); ++i) {
        row.add(std::string(render::kRayKindNames[i]) + "_rays", comparison.rays.of[i].rays);
    }
    return row;
}

}  // namespace

ReportData report_data(const Comparison& comparison) {
    return {first_of(comparison),
            scene_of(comparison).add("whole", comparison.is_whole),
            {{"structures", rows_of(comparison)}}};
}

ReportData report_data(const pipeline::SizeCurve& curve) {
    const Comparison& first = curve.comparisons.front();
    return {first_of(first),
            scene_of(first).add("varied", facts(curve.size).name).add("whole", curve.is_whole),
            {{"points", rows_of(curve)}}};
}

ReportData report_data(const pipeline::Growth& growth) {
    return {DataRow().add("growth", facts(growth.scene).name),
            DataRow().add("whole", growth.is_whole),
            {{"points", rows_of(growth)}}};
}

ReportData report_data(const pipeline::Motion& motion) {
    return {DataRow().add("balls", motion.balls),
            DataRow().add("whole", motion.is_whole),
            {{"points", rows_of(motion)}}};
}

}  // namespace carom::cli
