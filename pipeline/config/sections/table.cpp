#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

using sim::billiards::PocketMeasures;
using sim::billiards::RackKind;
using sim::billiards::TableKind;

constexpr double kPi = 3.14159265358979323846;

const MapSpec<PocketMeasures>& pocket_spec() {
    static const MapSpec<PocketMeasures> spec = [] {
        MapSpec<PocketMeasures> s("pocket", "The measures of one kind of pocket.");
        s.key("mouth", &PocketMeasures::mouth, length(inside(0, 1)),
              "between the ends of the two cushion noses")
            .required();
        s.key("throat", &PocketMeasures::throat, length(inside(0, 1)),
              "between the jaws where they meet the hole")
            .required();
        s.key("jaw_angle", &PocketMeasures::jaw_angle, angle(inside(kPi / 2, kPi)),
              "between the cushion's nose line and the jaw")
            .required();
        s.key("hole_radius", &PocketMeasures::hole_radius, length(inside(0, 1)),
              "of the hole in the slate")
            .required();
        s.key("shelf", &PocketMeasures::shelf, length(between(0, 1)),
              "from the line of the mouth to the edge of the hole")
            .required();
        s.key("drop", &PocketMeasures::drop, length(inside(0, 2)),
              "depth of the pocket's floor under the cloth")
            .required();
        s.key("lip_radius", &PocketMeasures::lip_radius, length(between(0, 0.5)),
              "rounding, seen from above, between nose and jaw (3 mm)");
        return s;
    }();
    return spec;
}

const MapSpec<PocketsSection>& pockets_spec() {
    static const MapSpec<PocketsSection> spec = [] {
        MapSpec<PocketsSection> s("pockets", "The pockets of a table.");
        s.key("corner", &PocketsSection::corner, record(pocket_spec()), "the four in the corners");
        s.key("side", &PocketsSection::side, record(pocket_spec()),
              "the two in the middle of the long sides");
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

void note_size_place(Reader& /*reader*/, const Node& node, TableSection& table) {
    if (const Entry* size = node.find("size")) {
        table.size_place = size->value.place;
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
              "`cloth` is an unbounded cloth without cushions; `custom` needs length and width");
        s.key("size", &TableSection::size, text("a table size such as 9 ft"),
              "pool: 7 ft, 8 ft, 9 ft; snooker: 12 ft; carom: 10 ft");
        s.key("length", &TableSection::length, length(between(0.1, 20)),
              "of the playing field between the cushion noses, along x");
        s.key("width", &TableSection::width, length(between(0.1, 20)),
              "of the playing field, along y");
        s.key("cushion_height", &TableSection::cushion_height, length(inside(0, 0.5)),
              "of the cushion's nose above the cloth");
        s.key("cushion_width", &TableSection::cushion_width, length(inside(0, 0.5)),
              "from the nose to the rail");
        s.key("rail_width", &TableSection::rail_width, length(inside(0, 1)),
              "of the wooden rail outside the cushion");
        s.key("rail_height", &TableSection::rail_height, length(inside(0, 0.5)),
              "of the rail's top above the cloth");
        s.key("height", &TableSection::height, length(inside(0, 5)),
              "of the cloth above the floor");
        s.key("pockets", &TableSection::pockets, pockets(),
              "`none`, or the measures of both kinds");
        s.check(note_size_place);
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
        s.key("gap", &RackSection::gap, length(between(0, 0.005)),
              "mean gap between neighbours; the gaps are random between 0 and twice this");
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
