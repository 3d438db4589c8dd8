#include "pipeline/config/sections/repeat.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/limits.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr int kMostObjects = 10'000;
constexpr double kTurn = 6.283185307179586;

/// Two or three coordinates.
ValueType<Vec3> point() {
    return convert<Vec3>(coordinates(Dimension::length),
                         [](const Coordinates& point) { return point.value; });
}

/// The contents of the map of a path.
struct PathKeys {
    RepeatPath path;
    RepeatArc arc;
};

struct Angles {
    double start = 0;
    double end = kTurn;
};

ValueType<Angles> angles() {
    return convert<Angles>(list_of(angle(between(-kTurn, kTurn)), 2, 2),
                           [](const std::vector<double>& ends) {
                               return Angles{ends[0], ends[1]};
                           });
}

/// Reports a path on which all objects would be at the same place.
void check_length(Reader& reader, const Node& node, PathKeys& keys) {
    const auto report = [&](const char* key) {
        reader.error(node.find(key)->value.place,
                     std::string("'") + key +
                         "' makes a path without length, so all objects would "
                         "be at the same place");
    };
    const auto is_zero = [](const Vec3& way) { return way.length() < 1e-9; };
    const RepeatPath& path = keys.path;
    const auto check_curve = [&](const char* key, const std::optional<std::vector<Vec3>>& points) {
        const auto is_first = [&](const Vec3& point) { return is_zero(point - points->front()); };
        if (points && std::ranges::all_of(*points, is_first)) {
            report(key);
        }
    };
    check_curve("bezier", path.bezier);
    check_curve("spline", path.spline);
    if (path.arc && path.arc->start_angle == path.arc->end_angle) {
        report("angles");
    }
    if (path.to && is_zero(*path.to - path.from)) {
        report("to");
    }
    if (path.step && is_zero(*path.step)) {
        report("step");
    }
    if (path.steps && std::ranges::any_of(*path.steps, is_zero)) {
        report("steps");
    }
}

const MapSpec<PathKeys>& path_spec() {
    static const MapSpec<PathKeys> spec = [] {
        MapSpec<PathKeys> s("repeat path",
                            "Where repeated objects are, at even distances along a curve or in a "
                            "grid. Points have two or three coordinates; the object's `at` is "
                            "added to each.");
        const auto curve = [&](const char* name, std::optional<std::vector<Vec3>> RepeatPath::*at,
                               int fewest, int most, const char* description) {
            s.set(
                name, list_of(point(), fewest, most),
                [at](PathKeys& keys, std::vector<Vec3> points) {
                    keys.path.*at = std::move(points);
                },
                description);
        };
        curve("bezier", &RepeatPath::bezier, 2, 64, "control points of a Bezier curve");
        curve("spline", &RepeatPath::spline, 2, 256, "points that a smooth curve passes through");
        s.set(
            "arc", point(), [](PathKeys& keys, const Vec3& centre) { keys.arc.centre = centre; },
            "centre of a horizontal circle, or of a part of it");
        s.set(
            "to", point(), [](PathKeys& keys, const Vec3& end) { keys.path.to = end; },
            "last position on a line, which starts at `from`");
        s.set(
            "step", point(), [](PathKeys& keys, const Vec3& step) { keys.path.step = step; },
            "on a line that starts at `from`: the way from each object to the next");
        curve("steps", &RepeatPath::steps, 2, 3,
              "in a grid: the ways from each object to the next in two or three directions");
        s.set(
             "from", point(), [](PathKeys& keys, const Vec3& start) { keys.path.from = start; },
             "first position on the line or in the grid", "[0, 0, 0]")
            .goes_with({"to", "step", "steps"});
        s.set(
             "radius", length(above_up_to(0, 1000)),
             [](PathKeys& keys, double radius) { keys.arc.radius = radius; }, "radius of the `arc`")
            .needed_by("arc");
        s.set(
             "angles", angles(),
             [](PathKeys& keys, const Angles& ends) {
                 keys.arc.start_angle = ends.start;
                 keys.arc.end_angle = ends.end;
             },
             "start and end angle of the `arc`, from x towards y. The default is the whole circle")
            .goes_with({"arc"});
        s.exactly_one_of({"bezier", "spline", "arc", "to", "step", "steps"});
        s.check([](Reader&, const Node& node, PathKeys& keys) {
            if (node.find("arc") != nullptr) {
                keys.path.arc = keys.arc;
            }
        });
        s.check(check_length);
        return s;
    }();
    return spec;
}

/// A whole number, or one for each direction of a grid.
ValueType<std::vector<int>> counts() {
    const ValueType<int> number = integer(1, kMostObjects);
    const auto one =
        convert<std::vector<int>>(number, [](int count) { return std::vector<int>{count}; });
    return any_of<std::vector<int>>({{is_scalar, one}, {is_list, list_of(number, 2, 3)}});
}

void check_counts(Reader& reader, const Node& node, RepeatSection& section) {
    const Entry* count = node.find("count");
    if (count == nullptr || section.count.empty()) {
        return;
    }
    const std::size_t directions = section.path.steps ? section.path.steps->size() : 1;
    if (section.count.size() != directions) {
        const std::string wanted = directions == 1 ? "one number"
                                                   : std::to_string(directions) +
                                                         " numbers, one for each "
                                                         "of the 'steps'";
        reader.error(count->value.place, "'count' must be " + wanted);
        return;
    }
    double total = 1;
    for (const int number : section.count) {
        total *= number;
    }
    if (total > static_cast<double>(input_limit(kMostObjects))) {
        reader.error(count->value.place,
                     beyond_limit(input_limit(kMostObjects), "objects are repeated"));
    }
}

void check_turn(Reader& reader, const Node& node, RepeatSection& section) {
    if (section.path.steps && section.is_turned.value_or(false)) {
        reader.error(node.find("turn")->value.place,
                     "the objects of a grid cannot face along it; give them a 'rotate' instead");
    }
}

}  // namespace

const MapSpec<RepeatSection>& repeat_spec() {
    static const MapSpec<RepeatSection> spec = [] {
        MapSpec<RepeatSection> s(
            "repeat",
            "The object stands for many, at even distances. Those of `tile` are `tile_1`, `tile_2` "
            "and so on; in a grid the first direction counts fastest. An object that has such a "
            "name itself is merged over the repeated one: it gives only what differs, and with "
            "the value null there is none.");
        s.key("count", &RepeatSection::count, counts(),
              "number of objects, including both ends; in a grid one number for each direction")
            .required();
        s.set(
             "along", record(path_spec()),
             [](RepeatSection& section, PathKeys keys) { section.path = std::move(keys.path); },
             "a curve or a grid")
            .required();
        s.key("turn", &RepeatSection::is_turned, choice<bool>({{"along", true}, {"none", false}}),
              "`along`: the objects are also turned about the vertical so that their x axes face "
              "along the curve, which is the default except in a grid; `none`: they are not");
        s.check(check_counts);
        s.check(check_turn);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
