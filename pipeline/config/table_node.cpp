#include "pipeline/config/table_node.h"

#include <cmath>
#include <string>
#include <utility>

#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

namespace {

using sim::billiards::PocketMeasures;
using sim::billiards::TableMeasures;

Node empty_map() {
    Node map;
    map.kind = Node::Kind::map;
    return map;
}

/// Adds a value. Lengths are rounded to a micrometre, because computed or converted ones have many
/// digits.
void add(Node& map, const char* key, double value, Dimension dimension = Dimension::length) {
    const bool is_length = dimension == Dimension::length;
    Node scalar;
    scalar.kind = Node::Kind::scalar;
    scalar.text = show(is_length ? std::round(value * 1e6) / 1e6 : value, dimension);
    map.entries.push_back({key, {}, std::move(scalar)});
}

void add_pocket(Node& pockets, const char* key, const std::optional<PocketMeasures>& pocket) {
    if (!pocket) {
        return;
    }
    Node map = empty_map();
    add(map, "mouth", pocket->mouth);
    add(map, "throat", pocket->throat);
    add(map, "jaw_angle", pocket->jaw_angle, Dimension::angle);
    add(map, "hole_radius", pocket->hole_radius);
    add(map, "shelf", pocket->shelf);
    add(map, "drop", pocket->drop);
    add(map, "lip_radius", pocket->lip_radius);
    pockets.entries.push_back({key, {}, std::move(map)});
}

}  // namespace

Node table_node(const TableMeasures& measures) {
    Node table = empty_map();
    if (!measures.has_cushions) {
        return table;
    }
    add(table, "length", measures.length);
    add(table, "width", measures.width);
    add(table, "cushion_height", measures.nose_height);
    add(table, "cushion_width", measures.cushion_width);
    add(table, "rail_width", measures.rail_width);
    add(table, "rail_height", measures.rail_height);
    add(table, "height", measures.height);
    Node pockets = empty_map();
    add_pocket(pockets, "corner", measures.corner_pocket);
    add_pocket(pockets, "side", measures.side_pocket);
    if (!pockets.entries.empty()) {
        add(pockets, "jaw_restitution", measures.jaw_restitution, Dimension::none);
        Node has_return;
        has_return.kind = Node::Kind::scalar;
        has_return.text = measures.has_ball_return ? "true" : "false";
        pockets.entries.push_back({"return", {}, std::move(has_return)});
        table.entries.push_back({"pockets", {}, std::move(pockets)});
    }
    return table;
}

}  // namespace carom::pipeline::config
