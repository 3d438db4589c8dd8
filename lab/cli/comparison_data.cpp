#include "lab/cli/comparison_data.h"

#include <array>
#include <cmath>

#include "core/json_text.h"
#include "lab/comparison/comparison_text.h"
#include "lab/comparison/growth_text.h"
#include "pipeline/export/csv_text.h"

namespace carom::cli {

namespace {

using pipeline::ComparedStructure;
using pipeline::Comparison;
using render::KindCounts;

constexpr std::array<const char*, 3> kKinds{"primary", "secondary", "shadow"};

std::int64_t signed_of(std::uint64_t number) {
    return static_cast<std::int64_t>(number);
}

void add_rays(JsonMembers& members, const Comparison& comparison) {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        members.add(std::string(kKinds[i]) + "_rays", signed_of(comparison.rays.of[i].rays));
    }
}

void add_tests(JsonMembers& members, const render::TestCounts& tests) {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        const KindCounts& counts = tests.of[i];
        const std::string kind = kKinds[i];
        members.add(kind + "_objects", signed_of(counts.objects))
            .add(kind + "_boxes", signed_of(counts.boxes))
            .add(kind + "_nodes", signed_of(counts.nodes));
    }
}

JsonMembers row_members(const ComparedStructure& row) {
    JsonMembers members;
    members.add("structure", row.name)
        .add("shadow_query", name_of(row.shadow_rays))
        .add("build_seconds", row.build_seconds)
        .add("bytes", signed_of(row.bytes))
        .add("cpu_seconds", row.cpu_seconds)
        .add("computed", row.is_computed ? 1 : 0);
    if (row.is_counted) {
        add_tests(members, row.tests);
    }
    return members;
}

JsonMembers scene_members(const Comparison& comparison) {
    JsonMembers members;
    members.add("scene", comparison.name)
        .add("what", comparison.what)
        .add("width", comparison.width)
        .add("height", comparison.height)
        .add("shapes", signed_of(comparison.shapes));
    return members;
}

/// The names in `columns`, followed by those of the test counts.
std::string csv_header(const std::string& columns) {
    std::string header = columns;
    for (const char* kind : kKinds) {
        for (const char* what : {"rays", "objects", "boxes", "nodes"}) {
            header += std::string(",") + kind + "_" + what;
        }
    }
    return header;
}

/// `tests`: null if they are unknown.
void add_tests(pipeline::CsvText& csv, const render::TestCounts& rays,
               const render::TestCounts* tests) {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        csv.add(static_cast<double>(rays.of[i].rays));
        for (std::uint64_t KindCounts::*what :
             {&KindCounts::objects, &KindCounts::boxes, &KindCounts::nodes}) {
            if (tests != nullptr) {
                csv.add(static_cast<double>(tests->of[i].*what));
            } else {
                csv.add("");
            }
        }
    }
}

constexpr const char* kRowColumns =
    "structure,shadow_query,build_seconds,bytes,cpu_seconds,computed,counted";

void add_row(pipeline::CsvText& csv, const Comparison& comparison, const ComparedStructure& row) {
    csv.add(row.name).add(name_of(row.shadow_rays));
    csv.add(row.build_seconds)
        .add(static_cast<double>(row.bytes))
        .add(row.cpu_seconds)
        .add(row.is_computed ? 1.0 : 0.0)
        .add(row.is_counted ? 1.0 : 0.0);
    add_tests(csv, comparison.rays, row.is_counted ? &row.tests : nullptr);
    csv.end_row();
}

std::string point_object(const pipeline::GrowthPoint& point) {
    JsonMembers members;
    members.add("structure", point.name)
        .add("shapes", signed_of(point.shapes))
        .add("build_seconds", point.build_seconds)
        .add("bytes", signed_of(point.bytes));
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        const std::string kind = kKinds[i];
        members.add("seconds_per_" + kind + "_ray", point.seconds_per_ray[i]);
        if (point.is_counted) {
            members.add(kind + "_rays", signed_of(point.tests.of[i].rays));
        }
    }
    members.add("seconds_per_ray_of_batch", point.seconds_per_ray_of_batch)
        .add("seconds_per_shadow_ray_of_batch", point.seconds_per_shadow_ray_of_batch);
    if (point.is_counted) {
        add_tests(members, point.tests);
    }
    return members.object();
}

std::string motion_object(const pipeline::Motion& motion, const pipeline::MotionPoint& point) {
    JsonMembers members;
    members.add("structure", point.structure)
        .add("intervals", point.intervals)
        .add("shutter", point.shutter)
        .add("shapes", static_cast<std::int64_t>(point.shapes))
        .add("build_seconds", point.build_seconds)
        .add("bytes", static_cast<std::int64_t>(point.bytes))
        .add("seconds_per_ray", point.seconds_per_ray)
        .add("break_even_rays", motion.break_even(point));
    if (point.is_counted) {
        members.add("rays", signed_of(point.tests.total().rays));
        add_tests(members, point.tests);
    }
    return members.object();
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
    JsonMembers members = scene_members(comparison);
    members.add("whole", comparison.is_whole ? 1 : 0);
    add_rays(members, comparison);
    std::string rows;
    for (const ComparedStructure& row : comparison.rows) {
        rows += (rows.empty() ? "\n" : ",\n") + row_members(row).object();
    }
    return "{" + members.text() + ",\n\"structures\":[" + rows + "]}\n";
}

std::string comparison_csv(const Comparison& comparison) {
    pipeline::CsvText csv(csv_header(std::string("scene,") + kRowColumns));
    for (const ComparedStructure& row : comparison.rows) {
        csv.add(comparison.name);
        add_row(csv, comparison, row);
    }
    return csv.finish();
}

std::string sizes_json(const pipeline::SizeCurve& curve) {
    JsonMembers members = scene_members(curve.comparisons.front());
    members.add("varied", pipeline::name_of(curve.size)).add("whole", curve.is_whole ? 1 : 0);
    add_rays(members, curve.comparisons.front());
    std::string rows;
    for (std::size_t i = 0; i < curve.comparisons.size(); ++i) {
        for (const ComparedStructure& row : curve.comparisons[i].rows) {
            JsonMembers with_size;
            with_size.add(pipeline::name_of(curve.size), curve.values[i]).add(row_members(row));
            rows += (rows.empty() ? "\n" : ",\n") + with_size.object();
        }
    }
    return "{" + members.text() + ",\n\"points\":[" + rows + "]}\n";
}

std::string sizes_csv(const pipeline::SizeCurve& curve) {
    pipeline::CsvText csv(
        csv_header(std::string("scene,") + pipeline::name_of(curve.size) + "," + kRowColumns));
    for (std::size_t i = 0; i < curve.comparisons.size(); ++i) {
        const Comparison& comparison = curve.comparisons[i];
        for (const ComparedStructure& row : comparison.rows) {
            csv.add(comparison.name).add(curve.values[i]);
            add_row(csv, comparison, row);
        }
    }
    return csv.finish();
}

std::string growth_json(const pipeline::Growth& growth) {
    JsonMembers members;
    members.add("growth", name_of(growth.scene)).add("whole", growth.is_whole ? 1 : 0);
    std::string points;
    for (const pipeline::GrowthPoint& point : growth.points) {
        points += (points.empty() ? "\n" : ",\n") + point_object(point);
    }
    return "{" + members.text() + ",\n\"points\":[" + points + "]}\n";
}

std::string growth_csv(const pipeline::Growth& growth) {
    pipeline::CsvText csv(
        csv_header("growth,structure,shapes,build_seconds,bytes,seconds_per_primary_ray,"
                   "seconds_per_secondary_ray,seconds_per_shadow_ray,seconds_per_ray_of_batch,"
                   "seconds_per_shadow_ray_of_batch"));
    for (const pipeline::GrowthPoint& point : growth.points) {
        csv.add(name_of(growth.scene))
            .add(point.name)
            .add(static_cast<double>(point.shapes))
            .add(point.build_seconds)
            .add(static_cast<double>(point.bytes));
        for (const double seconds : point.seconds_per_ray) {
            csv.add(seconds);
        }
        csv.add(point.seconds_per_ray_of_batch).add(point.seconds_per_shadow_ray_of_batch);
        add_tests(csv, point.tests, point.is_counted ? &point.tests : nullptr);
        csv.end_row();
    }
    return csv.finish();
}

std::string motion_json(const pipeline::Motion& motion) {
    JsonMembers members;
    members.add("balls", static_cast<std::int64_t>(motion.balls))
        .add("whole", motion.is_whole ? 1 : 0);
    std::string points;
    for (const pipeline::MotionPoint& point : motion.points) {
        points += (points.empty() ? "\n" : ",\n") + motion_object(motion, point);
    }
    return "{" + members.text() + ",\n\"points\":[" + points + "]}\n";
}

std::string motion_csv(const pipeline::Motion& motion) {
    pipeline::CsvText csv(
        csv_header("balls,structure,intervals,shutter,shapes,build_seconds,bytes,seconds_per_ray,"
                   "break_even_rays"));
    for (const pipeline::MotionPoint& point : motion.points) {
        csv.add(static_cast<double>(motion.balls))
            .add(point.structure)
            .add(static_cast<double>(point.intervals))
            .add(point.shutter)
            .add(static_cast<double>(point.shapes))
            .add(point.build_seconds)
            .add(static_cast<double>(point.bytes))
            .add(point.seconds_per_ray);
        const double rays = motion.break_even(point);
        if (std::isfinite(rays)) {
            csv.add(rays);
        } else {
            csv.add("");
        }
        add_tests(csv, point.tests, point.is_counted ? &point.tests : nullptr);
        csv.end_row();
    }
    return csv.finish();
}

}  // namespace carom::cli
