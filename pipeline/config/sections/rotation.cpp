// The types of rotations: of an object, and of a key of its motion.

#include "core/elementary.h"
#include "core/length.h"
#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

constexpr double kMaxRevolutions = 100;
constexpr double kRevolution = 6.283185307179586;

struct AxisAngle {
    Vec3 axis{0, 0, 1};
    double angle = 0;
};

MapSpec<AxisAngle> make_axis_angle(const char* name, const char* description, Range range) {
    MapSpec<AxisAngle> s(name, description);
    s.key("axis", &AxisAngle::axis, vector3(Dimension::none), "axis in world coordinates")
        .required();
    s.key("angle", &AxisAngle::angle, angle(range),
          "angle, counter-clockwise when the axis points towards the viewer")
        .required();
    s.check([](Reader& reader, const Node& node, AxisAngle& value) {
        if (value.axis.length() < 1e-9) {
            const Entry* axis = node.find("axis");
            reader.error(axis != nullptr ? axis->value.place : node.place,
                         "'axis' must not be the zero vector");
            value.axis = {0, 0, 1};
        }
    });
    return s;
}

const MapSpec<AxisAngle>& axis_angle_spec() {
    static const MapSpec<AxisAngle> spec =
        make_axis_angle("rotation", "A rotation about an axis.", any());
    return spec;
}

const MapSpec<AxisAngle>& turn_spec() {
    static const MapSpec<AxisAngle> spec = make_axis_angle(
        "turn", "A rotation about an axis since the previous key, of any number of revolutions.",
        between(-kMaxRevolutions * kRevolution, kMaxRevolutions * kRevolution));
    return spec;
}

Quat turn(const Vec3& axis, double angle) {
    return Quat(cosine(angle / 2), unit(axis) * sine(angle / 2));
}

}  // namespace

ValueType<Quat> rotation() {
    const auto angles = convert<Quat>(vector3(Dimension::angle), [](const Vec3& a) {
        // Imath's product q1 * q2 applies q2 first.
        return turn({0, 0, 1}, a.z) * turn({0, 1, 0}, a.y) * turn({1, 0, 0}, a.x);
    });
    const auto about_axis = convert<Quat>(record(axis_angle_spec()),
                                          [](const AxisAngle& a) { return turn(a.axis, a.angle); });
    return any_of<Quat>({{is_list, angles}, {is_map, about_axis}});
}

ValueType<Vec3> rotation_vector() {
    return convert<Vec3>(record(turn_spec()),
                         [](const AxisAngle& a) { return a.angle * unit(a.axis); });
}

}  // namespace carom::pipeline::config
