#include <numbers>

#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

using sim::billiards::RackKind;
using sim::billiards::TableKind;

const MapSpec<PocketSection>& pocket_spec() {
    static const MapSpec<PocketSection> spec = [] {
        MapSpec<PocketSection> s(
            "pocket", "One kind of pocket. The defaults are those of the standard table.");
        s.key("mouth", &PocketSection::mouth, length(inside(0, 1)),
              "distance between the ends of the two cushion noses, as if they were not rounded");
        s.key("throat", &PocketSection::throat, length(inside(0, 1)),
              "distance between the jaws where they meet the hole");
        s.key("jaw_angle", &PocketSection::jaw_angle,
              angle(inside(std::numbers::pi / 2, std::numbers::pi)),
              "angle between the line of the cushion nose and the jaw");
        s.key("hole_radius", &PocketSection::hole_radius, length(inside(0, 1)),
              "radius of the hole in the slate");
        s.key("shelf", &PocketSection::shelf, length(between(0, 1)),
              "distance from the line of the mouth to the edge of the hole");
        s.key("drop", &PocketSection::drop, length(inside(0, 2)),
              "depth of the pocket's floor below the cloth");
        s.key("lip_radius", &PocketSection::lip_radius, length(between(0, 0.1)),
              "radius of the rounding between nose and jaw, seen from above");
        return s;
    }();
    return spec;
}

const MapSpec<PocketsSection>& pockets_spec() {
    static const MapSpec<PocketsSection> spec = [] {
        MapSpec<PocketsSection> s("pockets", "The pockets of a table.");
        s.key("corner", &PocketsSection::corner, record(pocket_spec()), "the four corner pockets");
        s.key("side", &PocketsSection::side, record(pocket_spec()),
              "the two side pockets, in the middle of the long sides");
        s.key(
            "jaw_restitution", &PocketsSection::jaw_restitution, number(between(0, 1)),
            "restitution of the straight part of the jaws, as a fraction of that of the cushions. "
            "The default is 0.7, snooker 1");
        s.key("return", &PocketsSection::has_return, boolean(),
              "whether the table has a ball return: where a ball falls into a pocket that is full, "
              "the one that fell in first leaves through the pocket's floor");
        return s;
    }();
    return spec;
}

ValueType<PocketsSection> pockets() {
    const auto none = convert<PocketsSection>(choice<bool>({{"none", true}}), [](bool value) {
        PocketsSection section;
        section.none = value;
        return section;
    });
    return any_of<PocketsSection>({{is_scalar, none}, {is_map, record(pockets_spec())}});
}

/// Checks that the kind of table has the given dimensions.
void check_measures(Reader& reader, const Node& node, TableSection& table) {
    if (const Entry* size = node.find("size")) {
        table.size_place = size->value.place;
    }
    const auto refuse = [&](const char* key, const std::string& why) {
        if (const Entry* entry = node.find(key)) {
            reader.error(entry->key_place, "'" + std::string(key) + "' has no meaning for " + why);
        }
    };
    if (table.kind == TableKind::cloth) {
        for (const char* key : {"size", "length", "width", "cushion_height", "cushion_width",
                                "rail_width", "rail_height", "height", "pockets"}) {
            refuse(key, "an unbounded cloth");
        }
    } else if (table.kind == TableKind::custom) {
        refuse("size", "a custom table; give 'length' and 'width'");
        for (const char* key : {"length", "width"}) {
            if (node.find(key) == nullptr && !reader.is_partial()) {
                reader.error(reader.key_place(),
                             "a custom table needs the key '" + std::string(key) + "'");
            }
        }
    } else {
        for (const char* key : {"length", "width"}) {
            refuse(key, "a table of a standard size; use 'kind: custom'");
        }
    }
}

}  // namespace

const MapSpec<TableSection>& table_spec() {
    static const MapSpec<TableSection> spec = [] {
        MapSpec<TableSection> s("table",
                                "The billiard table. Its cloth is the plane z = 0, its centre the "
                                "origin, its long axis x.");
        s.key("kind", &TableSection::kind,
              choice<TableKind>({{"pool", TableKind::pool},
                                 {"snooker", TableKind::snooker},
                                 {"carom", TableKind::carom},
                                 {"cloth", TableKind::cloth},
                                 {"custom", TableKind::custom}}),
              "`cloth` is an infinite cloth without cushions, drawn 6 m square; `custom` requires "
              "length and width");
        s.key("size", &TableSection::size, text("a table size such as 9 ft"),
              "pool: 7 ft, 8 ft, 9 ft; snooker: 12 ft; carom: 10 ft");
        s.key("length", &TableSection::length, length(between(0.1, 20)),
              "length of the playing field between the cushion noses, along x");
        s.key("width", &TableSection::width, length(between(0.1, 20)),
              "width of the playing field, along y");
        s.key("cushion_height", &TableSection::cushion_height, length(inside(0, 0.5)),
              "height of the cushion nose above the cloth");
        s.key("cushion_width", &TableSection::cushion_width, length(inside(0, 0.5)),
              "distance from the nose to the rail");
        s.key("rail_width", &TableSection::rail_width, length(inside(0, 1)),
              "width of the wooden rail outside the cushion");
        s.key("rail_height", &TableSection::rail_height, length(inside(0, 0.5)),
              "height of the rail's top above the cloth");
        s.key("height", &TableSection::height, length(inside(0, 5)),
              "height of the cloth above the floor");
        s.key("pockets", &TableSection::pockets, pockets(),
              "`none`, or the dimensions of both kinds of pocket");
        s.key(
            "drawn", &TableSection::is_drawn, boolean(),
            "whether the table and the floor under it are in the picture. With `false` balls roll, "
            "rebound and fall as before, and objects of the shot show what they do it on");
        s.check(check_measures);
        return s;
    }();
    return spec;
}

const MapSpec<RackSection>& rack_spec() {
    static const MapSpec<RackSection> spec = [] {
        MapSpec<RackSection> s("rack",
                               "The object balls of a game, racked with the apex on the foot spot "
                               "(x = length / 4). They are named `one` to `fifteen`; snooker: "
                               "`red_1` to `red_15` and the colours; carom: `white`, `yellow`, "
                               "`red`.");
        s.key("set", &RackSection::set,
              choice<RackKind>({{"nine_ball", RackKind::nine_ball},
                                {"eight_ball", RackKind::eight_ball},
                                {"ten_ball", RackKind::ten_ball},
                                {"fifteen_ball", RackKind::fifteen_ball},
                                {"snooker", RackKind::snooker},
                                {"carom", RackKind::carom}}),
              "the game")
            .required();
        s.key("at", &RackSection::at, table_place(),
              "where the apex is, if not on the foot spot: a spot or a point. Snooker and carom "
              "have fixed places");
        s.key("gap", &RackSection::gap, length(between(0, 0.005)),
              "mean gap between neighbours; the gaps are random between 0 and twice this");
        s.check([](Reader& reader, const Node& node, RackSection& rack) {
            const Entry* at = node.find("at");
            if (at != nullptr && (rack.set == RackKind::snooker || rack.set == RackKind::carom)) {
                reader.error(at->key_place,
                             "'at' has no meaning for a snooker or carom rack, whose "
                             "balls have spots of their own");
            }
        });
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
