#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "core/text.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"
#include "pipeline/shot/table_scene.h"
#include "sim/billiards/drawn/drawn_table.h"
#include "sim/billiards/spots.h"

namespace carom::pipeline::config {

namespace {

using sim::billiards::PocketMeasures;
using sim::billiards::TableKind;
using sim::billiards::TableMeasures;

constexpr std::array kSizes{"7 ft", "8 ft", "9 ft", "10 ft", "12 ft"};

std::string kind_name(TableKind kind) {
    if (kind == TableKind::snooker) {
        return "snooker";
    }
    return kind == TableKind::carom ? "carom" : "pool";
}

std::string default_size(TableKind kind) {
    switch (kind) {
        case TableKind::snooker:
            return "12 ft";
        case TableKind::carom:
            return "10 ft";
        case TableKind::cloth:
            return "";
        case TableKind::pool:
        case TableKind::custom:
            break;
    }
    return "9 ft";
}

/// "9ft" and "9  ft" are "9 ft".
std::string normalise_size(const std::string& size) {
    std::string result;
    for (const char c : size) {
        const bool is_digit = c >= '0' && c <= '9';
        if (c == ' ') {
            continue;
        }
        if (!is_digit && !result.empty() && result.back() >= '0' && result.back() <= '9') {
            result += ' ';
        }
        result += c;
    }
    return result;
}

std::optional<TableMeasures> standard_measures(Builder& builder, const TableSection& section) {
    const TableKind kind = section.kind == TableKind::custom ? TableKind::pool : section.kind;
    const std::string size = section.size ? normalise_size(*section.size) : default_size(kind);
    std::optional<TableMeasures> measures = sim::billiards::standard_table(kind, size);
    if (!measures) {
        std::vector<std::string> known;
        for (const char* candidate : kSizes) {
            if (sim::billiards::standard_table(kind, candidate)) {
                known.emplace_back(candidate);
            }
        }
        builder.reader.error(section.size_place,
                             "there is no " + kind_name(kind) + " table of size " +
                                 quote(section.size.value_or("")) +
                                 (known.size() == 1 ? "; the size is " : "; the sizes are ") +
                                 enumerate(known, "and"));
    }
    return measures;
}

/// Overrides the given dimensions. A table without such pockets gets them, and the check of the
/// table finds missing dimensions.
void override_pocket(std::optional<PocketMeasures>& pocket,
                     const std::optional<PocketSection>& section) {
    if (!section) {
        return;
    }
    PocketMeasures measures = pocket.value_or(PocketMeasures{});
    measures.mouth = section->mouth.value_or(measures.mouth);
    measures.throat = section->throat.value_or(measures.throat);
    measures.jaw_angle = section->jaw_angle.value_or(measures.jaw_angle);
    measures.hole_radius = section->hole_radius.value_or(measures.hole_radius);
    measures.shelf = section->shelf.value_or(measures.shelf);
    measures.drop = section->drop.value_or(measures.drop);
    measures.lip_radius = section->lip_radius.value_or(measures.lip_radius);
    pocket = measures;
}

void override_measures(TableMeasures& measures, const TableSection& section) {
    measures.kind = section.kind;
    measures.length = section.length.value_or(measures.length);
    measures.width = section.width.value_or(measures.width);
    measures.nose_height = section.cushion_height.value_or(measures.nose_height);
    measures.cushion_width = section.cushion_width.value_or(measures.cushion_width);
    measures.rail_width = section.rail_width.value_or(measures.rail_width);
    measures.rail_height = section.rail_height.value_or(measures.rail_height);
    measures.height = section.height.value_or(measures.height);
    if (section.pockets && section.pockets->none) {
        measures.corner_pocket.reset();
        measures.side_pocket.reset();
    } else if (section.pockets) {
        override_pocket(measures.corner_pocket, section.pockets->corner);
        override_pocket(measures.side_pocket, section.pockets->side);
        measures.jaw_restitution =
            section.pockets->jaw_restitution.value_or(measures.jaw_restitution);
        measures.has_ball_return = section.pockets->has_return;
    }
}

}  // namespace

void build_table(Builder& builder) {
    if (!builder.file.table) {
        return;
    }
    const TableSection& section = *builder.file.table;
    std::optional<TableMeasures> measures = standard_measures(builder, section);
    if (!measures) {
        return;
    }
    override_measures(*measures, section);
    const std::vector<Diagnostic> problems = sim::billiards::find_problems(*measures);
    for (const Diagnostic& problem : problems) {
        builder.report(problem);
    }
    if (problems.empty()) {
        if (measures->has_cushions) {
            builder.shot.world.floor_height = -measures->height;
        }
        builder.shot.world.table = measures;
    }
}

Vec2 place_of_spot(const Builder& builder, const std::string& spot) {
    const auto& table = builder.shot.world.table;
    const auto found = table ? find_spot(sim::billiards::spots_of(*table), spot) : std::nullopt;
    return found.value_or(Vec2(std::numeric_limits<double>::quiet_NaN()));
}

Vec2 place_on_table(const Builder& builder, const TablePlace& place) {
    return place.spot.empty() ? Vec2(place.point.value.x, place.point.value.y)
                              : place_of_spot(builder, place.spot);
}

std::vector<sim::billiards::PlacedBall> place_rack(Builder& builder) {
    const ShotFile& file = builder.file;
    if (!file.rack) {
        return {};
    }
    if (!file.table) {
        builder.reader.error(builder.place_of({"rack"}),
                             "a rack needs a table; 'table' is missing");
    }
    if (!builder.shot.world.table) {
        return {};  // its problem was reported
    }
    std::vector<sim::billiards::PlacedBall> balls =
        sim::billiards::rack(file.rack->set, *builder.shot.world.table,
                             measures_of_set(file).radius, {file.rack->gap, file.world.seed});
    if (file.rack->at) {
        const Vec2 apex = place_on_table(builder, *file.rack->at);
        const Vec3 shift =
            Vec3(apex.x, apex.y, 0) - Vec3(balls.front().position.x, balls.front().position.y, 0);
        for (sim::billiards::PlacedBall& ball : balls) {
            ball.position += shift;
        }
    }
    return balls;
}

void build_table_geometry(Builder& builder) {
    if (!builder.shot.world.table) {
        return;
    }
    const TableMeasures& measures = *builder.shot.world.table;
    const double radius = measures_of_set(builder.file).radius;
    builder.table_geometry = builder.tables != nullptr
                                 ? builder.tables->table(measures, radius)
                                 : std::make_shared<const sim::billiards::TableGeometry>(
                                       sim::billiards::build_table(measures, radius));
}

void build_table_scene(Builder& builder) {
    builder.shot.draws_table = builder.file.table && builder.file.table->is_drawn;
    if (!builder.shot.draws_table || !builder.shot.world.table) {
        return;
    }
    const TableMeasures& measures = *builder.shot.world.table;
    const double radius = measures_of_set(builder.file).radius;
    if (builder.tables != nullptr) {
        add_table(builder.shot.scene, measures, *builder.tables->drawn(measures, radius));
    } else {
        add_table(builder.shot.scene, measures, sim::billiards::draw_table(measures, radius));
    }
    if (builder.file.set) {  // which has a floor of its own
        std::erase_if(builder.shot.scene.objects, [](const render::ObjectDescription& object) {
            return object.name == kFloorName;
        });
    }
}

}  // namespace carom::pipeline::config
