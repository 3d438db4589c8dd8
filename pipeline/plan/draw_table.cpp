#include "pipeline/plan/footprint.h"
#include "pipeline/plan/plan_drawing.h"
#include "sim/billiards/parts.h"

namespace carom::pipeline {

namespace {

using sim::billiards::PlanPath;

constexpr double kSightRadius = 0.006;  // m
constexpr int kSights = 8;              // intervals between the sights of a long side

std::vector<Vec2> on_paper(const Sheet& sheet, const PlanPath& path) {
    std::vector<Vec2> points;
    for (const auto& point : path) {
        points.push_back(sheet.at(point.position));
    }
    return points;
}

void draw_cushions(PlanDrawing& plan) {
    const auto& table = *plan.table;
    for (const auto& cushion : table.cushions) {
        std::vector<Vec2> outline =
            on_paper(plan.sheet, sim::billiards::nose_path(cushion, table.measures.cushion_width));
        // The outline returns along the edge of the rail.
        const auto& side = cushion.side;
        const double depth =
            (table.rail - table.nose).dot(Vec2(std::abs(side.outward.x), std::abs(side.outward.y)));
        const auto end_u = [&](double u, const std::optional<sim::billiards::Jaw>& jaw,
                               double sign) {
            return jaw ? u + sign * jaw->end.x : u + sign * depth;
        };
        outline.push_back(plan.sheet.at(side.at(end_u(cushion.to, cushion.jaw_to, 1), depth)));
        outline.push_back(plan.sheet.at(side.at(end_u(cushion.from, cushion.jaw_from, -1), depth)));
        plan.svg.leaf("path", {{"class", "cushion"}, {"d", svg_path(outline, true)}});
    }
}

/// Draws the sights (diamonds), which lie halfway across the rails.
void draw_sights(PlanDrawing& plan) {
    const auto& table = *plan.table;
    const double off = 0.5 * (table.rail.y + table.outer.y);
    const double off_x = 0.5 * (table.rail.x + table.outer.x);
    const auto dot = [&](double x, double y) {
        const Vec2 centre = plan.sheet.at(Vec2(x, y));
        plan.svg.leaf("circle", {{"class", "sight"},
                                 {"cx", svg_number(centre.x)},
                                 {"cy", svg_number(centre.y)},
                                 {"r", svg_number(plan.sheet.length(kSightRadius))}});
    };
    const double length = table.measures.length;
    const double width = table.measures.width;
    for (int i = 1; i < kSights; ++i) {
        if (!table.measures.side_pocket || 2 * i != kSights) {
            dot(length * (static_cast<double>(i) / kSights - 0.5), off);
            dot(length * (static_cast<double>(i) / kSights - 0.5), -off);
        }
        if (2 * i < kSights) {
            dot(off_x, width * (2.0 * i / kSights - 0.5));
            dot(-off_x, width * (2.0 * i / kSights - 0.5));
        }
    }
}

void draw_fixed_bodies(PlanDrawing& plan) {
    for (const sim::Body& body : plan.shot.world.bodies) {
        if (body.kind != sim::BodyKind::fixed) {
            continue;
        }
        std::vector<Vec2> outline;
        for (const Vec2& point : footprint(body.shape, body.pose)) {
            outline.push_back(plan.sheet.at(point));
        }
        plan.svg.open("g");
        plan.svg.text("title", body.name + " (fixed)");
        plan.svg.leaf("path", {{"class", "cushion"}, {"d", svg_path(outline, true)}});
        plan.svg.leaf("path", {{"class", "fine"}, {"d", svg_path(outline, true)}});
        plan.svg.close();
    }
}

}  // namespace

void draw_table(PlanDrawing& plan) {
    plan.svg.open("g", {{"class", "table"}});
    if (plan.table) {
        const auto& table = *plan.table;
        const auto outer = on_paper(plan.sheet, sim::billiards::outer_path(table));
        plan.svg.leaf("path", {{"class", "rail"}, {"d", svg_path(outer, true)}});
        plan.svg.leaf("path", {{"class", "fine"}, {"d", svg_path(outer, true)}});
        const Vec2 corner = plan.sheet.at(Vec2(-table.rail.x, table.rail.y));
        plan.svg.leaf("rect", {{"class", "cloth"},
                               {"x", svg_number(corner.x)},
                               {"y", svg_number(corner.y)},
                               {"width", svg_number(plan.sheet.length(2 * table.rail.x))},
                               {"height", svg_number(plan.sheet.length(2 * table.rail.y))}});
        draw_cushions(plan);
        for (const auto& pocket : table.pockets) {
            const Vec2 centre = plan.sheet.at(pocket.pocket.centre);
            plan.svg.leaf("circle", {{"class", "hole"},
                                     {"cx", svg_number(centre.x)},
                                     {"cy", svg_number(centre.y)},
                                     {"r", svg_number(plan.sheet.length(pocket.pocket.radius))}});
        }
        if (table.measures.kind != sim::billiards::TableKind::snooker) {
            draw_sights(plan);
        }
    } else if (plan.shot.world.table) {
        const Vec2 size = plan.sheet.size();
        plan.svg.leaf("rect", {{"class", "cloth"},
                               {"x", svg_number(plan.sheet.corner.x)},
                               {"y", svg_number(plan.sheet.corner.y)},
                               {"width", svg_number(size.x)},
                               {"height", svg_number(size.y)}});
    }
    draw_fixed_bodies(plan);
    plan.svg.close();
}

}  // namespace carom::pipeline
