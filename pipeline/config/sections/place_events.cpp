// Events that put a ball down and take it off the table.
#include <limits>

#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

using sim::ForceEvent;
using sim::PlaceBall;

/// A spot by its name, whose place is found when the table is known, or a point.
ValueType<PlaceBall> spot_or_point() {
    const auto by_name = convert<PlaceBall>(name_of(ReferenceKind::spot), [](std::string name) {
        PlaceBall place;
        place.at = Vec2(std::numeric_limits<double>::quiet_NaN());
        place.spot = std::move(name);
        return place;
    });
    const auto by_point = convert<PlaceBall>(vector2(Dimension::length), [](const Vec2& point) {
        PlaceBall place;
        place.at = point;
        return place;
    });
    return any_of<PlaceBall>({{is_word, by_name}, {is_list, by_point}});
}

}  // namespace

ValueType<TablePlace> table_place() {
    const auto by_name = convert<TablePlace>(name_of(ReferenceKind::spot), [](std::string name) {
        return TablePlace{std::move(name), {}};
    });
    const auto by_point =
        convert<TablePlace>(coordinates(Dimension::length), [](const Coordinates& point) {
            return TablePlace{{}, point};
        });
    return any_of<TablePlace>({{is_list, by_point}, {is_word, by_name}});
}

const MapSpec<ForceEvent>& place_spec() {
    static const MapSpec<ForceEvent> spec = [] {
        ForceEvent prototype;
        prototype.action.emplace<PlaceBall>();
        MapSpec<ForceEvent> s("place",
                              "A ball is put down at rest on the cloth, wherever it is: in a "
                              "pocket, beside the table, "
                              "or moving on it.",
                              prototype);
        s.key("ball", &ForceEvent::object, name_of(ReferenceKind::ball), "the ball").required();
        add_event_start(s);
        s.set(
             "spot", spot_or_point(),
             [](ForceEvent& event, const PlaceBall& given) {
                 auto& place = std::get<PlaceBall>(event.action);
                 place.at = given.at;
                 place.spot = given.spot;
             },
             "where it is put: a spot of the table, or a point")
            .required();
        s.key(
            "if_occupied",
            [](ForceEvent& e) -> PlaceBall::IfOccupied& {
                return std::get<PlaceBall>(e.action).if_occupied;
            },
            choice<PlaceBall::IfOccupied>(
                {{"wait", PlaceBall::IfOccupied::wait}, {"next", PlaceBall::IfOccupied::next}}),
            "what happens while another ball or object is in the way: `wait` until the place is "
            "free, or `next`, the next place by the rules of the table's game");
        return s;
    }();
    return spec;
}

const MapSpec<ForceEvent>& remove_spec() {
    static const MapSpec<ForceEvent> spec = [] {
        ForceEvent prototype;
        prototype.action.emplace<sim::RemoveBall>();
        MapSpec<ForceEvent> s("remove", "A ball is taken off the table, out of sight.", prototype);
        s.key("ball", &ForceEvent::object, name_of(ReferenceKind::ball), "the ball").required();
        add_event_start(s);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
