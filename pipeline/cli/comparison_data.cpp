#include "pipeline/cli/comparison_data.h"

#include <array>

#include "pipeline/cli/terminal/json_text.h"
#include "pipeline/export/csv_text.h"
#include "pipeline/laboratory/comparison_text.h"

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

std::string row_object(const ComparedStructure& row) {
    JsonMembers members;
    members.add("structure", row.name)
        .add("shadow_rays", name_of(row.shadow_rays))
        .add("build_seconds", row.build_seconds)
        .add("bytes", signed_of(row.bytes))
        .add("cpu_seconds", row.cpu_seconds)
        .add("computed", row.is_computed ? 1 : 0);
    for (std::size_t i = 0; row.is_counted && i < kKinds.size(); ++i) {
        const KindCounts& counts = row.tests.of[i];
        const std::string kind = kKinds[i];
        members.add(kind + "_objects", signed_of(counts.objects))
            .add(kind + "_boxes", signed_of(counts.boxes))
            .add(kind + "_nodes", signed_of(counts.nodes));
    }
    return members.object();
}

std::string csv_header() {
    std::string header =
        "scene,structure,shadow_rays,build_seconds,bytes,cpu_seconds,computed,counted";
    for (const char* kind : kKinds) {
        for (const char* what : {"rays", "objects", "boxes", "nodes"}) {
            header += std::string(",") + kind + "_" + what;
        }
    }
    return header;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
    JsonMembers members;
    members.add("scene", comparison.name)
        .add("what", comparison.what)
        .add("width", comparison.width)
        .add("height", comparison.height)
        .add("shapes", signed_of(comparison.shapes))
        .add("whole", comparison.is_whole ? 1 : 0);
    add_rays(members, comparison);
    std::string rows;
    for (const ComparedStructure& row : comparison.rows) {
        rows += (rows.empty() ? "\n" : ",\n") + row_object(row);
    }
    return "{" + members.text() + ",\n\"structures\":[" + rows + "]}\n";
}

std::string comparison_csv(const Comparison& comparison) {
    pipeline::CsvText csv(csv_header());
    for (const ComparedStructure& row : comparison.rows) {
        csv.add(comparison.name).add(row.name).add(name_of(row.shadow_rays));
        csv.add(row.build_seconds)
            .add(static_cast<double>(row.bytes))
            .add(row.cpu_seconds)
            .add(row.is_computed ? 1.0 : 0.0)
            .add(row.is_counted ? 1.0 : 0.0);
        for (std::size_t i = 0; i < kKinds.size(); ++i) {
            const KindCounts& counts = row.tests.of[i];
            csv.add(static_cast<double>(comparison.rays.of[i].rays));
            for (const std::uint64_t tests : {counts.objects, counts.boxes, counts.nodes}) {
                if (row.is_counted) {
                    csv.add(static_cast<double>(tests));
                } else {
                    csv.add("");
                }
            }
        }
        csv.end_row();
    }
    return csv.finish();
}

}  // namespace carom::cli
