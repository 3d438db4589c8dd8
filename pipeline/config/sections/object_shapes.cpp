// The shapes that an object may have, one key each.
#include "pipeline/config/sections/object_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/config/units.h"
#include "pipeline/shot/solid_mesh.h"
#include "sim/limits.h"
#include "sim/shape/mass_properties.h"

namespace carom::pipeline::config {

namespace {

template <class V, class Make>
void add_shape(MapSpec<ObjectSection>& spec, std::string name, ValueType<V> type, Make make,
               std::string description) {
    spec.set(
        std::move(name), std::move(type),
        [make](ObjectSection& object, const V& value) { object.shape = make(value); },
        std::move(description));
}

const MapSpec<sim::Capsule>& capsule_spec() {
    static const MapSpec<sim::Capsule> spec = [] {
        MapSpec<sim::Capsule> s("capsule",
                                "A cylinder whose axis is z with a hemisphere at each end.");
        s.key("radius", &sim::Capsule::radius, length(between(sim::kMinSize, sim::kMaxSize)),
              "radius of the cylinder and of the hemispheres")
            .required();
        s.key("length", &sim::Capsule::length, length(between(sim::kMinSize, sim::kMaxSize)),
              "distance between the centres of the hemispheres")
            .required();
        return s;
    }();
    return spec;
}

const MapSpec<sim::Cylinder>& cylinder_spec() {
    static const MapSpec<sim::Cylinder> spec = [] {
        MapSpec<sim::Cylinder> s("cylinder", "A cylinder whose axis is z.");
        s.key("radius", &sim::Cylinder::radius, length(between(sim::kMinSize, sim::kMaxSize)),
              "radius of the caps")
            .required();
        s.key("height", &sim::Cylinder::height, length(between(sim::kMinSize, sim::kMaxSize)),
              "height from cap to cap")
            .required();
        return s;
    }();
    return spec;
}

void check_rounding(Reader& reader, const Node& node, render::RoundedBoxShape& box) {
    const double smallest = std::min({box.size.x, box.size.y, box.size.z});
    const Entry* radius = node.find("radius");
    if (radius != nullptr && node.find("size") != nullptr && 2 * box.radius > smallest) {
        reader.error(radius->value.place,
                     "the radius of " + reader.label() + " is more than half of its smallest side");
    }
}

const MapSpec<render::RoundedBoxShape>& rounded_box_spec() {
    static const MapSpec<render::RoundedBoxShape> spec = [] {
        using Box = render::RoundedBoxShape;
        MapSpec<Box> s("rounded box", "A box with round edges and corners.");
        s.key("size", &Box::size, vector3(Dimension::length, above_up_to(0, 1000)),
              "full lengths along x, y and z, the rounding included")
            .required();
        s.key("radius", &Box::radius, length(above_up_to(0, 1000)),
              "radius of the rounding, at most half of the smallest side")
            .required();
        s.check(check_rounding);
        return s;
    }();
    return spec;
}

/// The points of a rounded box's collision hull: 28 on each corner, which is an eighth of a sphere.
/// The flat sides of the hull are those of the box. At edges and corners the hull is inside the box
/// by at most 2.3 % of the radius.
std::vector<Vec3> rounded_box_points(const render::RoundedBoxShape& box) {
    // Sines of 0, 15, 30, 45, 60, 75 and 90 degrees, from square roots, whose bits are the same on
    // all platforms.
    const double of_15 = (std::sqrt(6.0) - std::sqrt(2.0)) / 4;
    const double of_75 = (std::sqrt(6.0) + std::sqrt(2.0)) / 4;
    const std::array<double, 7> sines{0, of_15, 0.5, std::sqrt(0.5), std::sqrt(0.75), of_75, 1};
    const std::size_t steps = sines.size() - 1;
    std::vector<Vec3> points;
    const Vec3 core = box.core();
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                        (corner & 4) != 0 ? 1 : -1);
        for (std::size_t i = 0; i <= steps; ++i) {
            for (std::size_t j = 0; i + j <= steps; ++j) {
                const Vec3 out = Vec3(sines[i], sines[j], sines[steps - i - j]).normalized();
                points.push_back(side * (core + box.radius * out));
            }
        }
    }
    return points;
}

/// Sets a hull whose vertices are relative to its centre of mass. `at` is still the position of the
/// origin of the points.
void set_hull(ObjectSection& object, const std::vector<Vec3>& points) {
    const std::optional<sim::Polyhedron> hull = sim::convex_hull(points);
    if (!hull) {
        object.shape = render::MeshShape{};
        return;
    }
    object.centre = sim::mass_properties(*hull).centre;
    sim::Polyhedron about_centre = *hull;
    for (Vec3& vertex : about_centre.vertices) {
        vertex -= object.centre;
    }
    object.shape = hull_mesh(about_centre);
    object.solid = sim::ConvexHull{about_centre.vertices};
}

void add_solids(MapSpec<ObjectSection>& s) {
    s.set(
        "capsule", record(capsule_spec()),
        [](ObjectSection& object, const sim::Capsule& capsule) {
            object.shape = render::CapsuleShape{capsule.radius, capsule.length};
            object.solid = capsule;
        },
        "a cylinder with hemispherical ends whose axis is z");
    s.set(
        "cylinder", record(cylinder_spec()),
        [](ObjectSection& object, const sim::Cylinder& cylinder) {
            object.shape = render::CylinderShape{cylinder.radius, cylinder.height};
            object.solid = cylinder;
        },
        "a cylinder whose axis is z");
    s.set(
        "rounded_box", record(rounded_box_spec()),
        [](ObjectSection& object, const render::RoundedBoxShape& box) {
            object.shape = box;
            object.solid = sim::ConvexHull{rounded_box_points(box)};
        },
        "a box with round edges and corners");
    s.set("hull", list_of(vector3(Dimension::length, between(-1000, 1000)), 4, 1000), set_hull,
          "the convex hull of four or more points that are not all in one plane");
}

const MapSpec<render::ConeShape>& cone_spec() {
    static const MapSpec<render::ConeShape> spec = [] {
        using Cone = render::ConeShape;
        MapSpec<Cone> s("cone", "A cone whose axis is z, with its tip up, or a truncated cone.");
        s.key("radius", &Cone::radius, length(above_up_to(0, 1000)), "radius at the bottom")
            .required();
        s.key("top_radius", &Cone::top_radius, length(between(0, 1000)),
              "radius at the top; 0: a tip");
        s.key("height", &Cone::height, length(above_up_to(0, 1000)), "height from bottom to top")
            .required();
        return s;
    }();
    return spec;
}

/// Whether two edges span an area; check_shape reports and removes a shape without area.
bool spans_area(const Vec3& u, const Vec3& v) {
    return u.cross(v).length() > 1e-9 * u.length() * v.length();
}

void add_flat_shapes(MapSpec<ObjectSection>& s) {
    const auto corners = list_of(vector3(Dimension::length, between(-1e6, 1e6)), 3, 3);
    s.set(
        "triangle", corners,
        [](ObjectSection& object, const std::vector<Vec3>& p) {
            object.shape = render::TriangleShape{{p[0], p[1], p[2]}};
            object.is_degenerate = !spans_area(p[1] - p[0], p[2] - p[0]);
        },
        "the three corners, counter-clockwise seen from the front");
    s.set(
        "parallelogram", corners,
        [](ObjectSection& object, const std::vector<Vec3>& p) {
            object.shape = render::ParallelogramShape{p[0], p[1] - p[0], p[2] - p[0]};
            object.is_degenerate = !spans_area(p[1] - p[0], p[2] - p[0]);
        },
        "a corner and its two neighbours; u runs to the first neighbour, v to the second");
    add_shape(
        s, "disk", length(above_up_to(0, 1000)),
        [](double radius) { return render::DiskShape{radius}; }, "radius; the front faces +z");
}

}  // namespace

const std::vector<std::string>& shape_keys() {
    static const std::vector<std::string> keys{
        "box",  "sphere", "rectangle", "plane",    "mesh",        "triangle", "parallelogram",
        "disk", "cone",   "capsule",   "cylinder", "rounded_box", "hull"};
    return keys;
}

void add_shapes(MapSpec<ObjectSection>& s) {
    add_shape(
        s, "box", vector3(Dimension::length, above_up_to(0, 1000)),
        [](const Vec3& size) { return render::BoxShape{size}; },
        "lengths of the edges along x, y and z");
    add_shape(
        s, "sphere", length(between(sim::kMinSize, sim::kMaxSize)),
        [](double radius) { return render::SphereShape{radius}; }, "radius of a sphere");
    add_shape(
        s, "rectangle", vector2(Dimension::length, above_up_to(0, 1000)),
        [](const Vec2& size) { return render::RectangleShape{size}; },
        "lengths along x and y; the front faces +z");
    add_shape(
        s, "plane", choice<bool>({{"infinite", true}}), [](bool) { return render::PlaneShape{}; },
        "the infinite plane that faces +z");
    add_shape(
        s, "mesh", file(FileKind::mesh),
        [](const std::string& path) {
            render::MeshShape mesh;
            mesh.file = path;
            return mesh;
        },
        "an OBJ or PLY file");
    add_flat_shapes(s);
    add_shape(
        s, "cone", record(cone_spec()), [](const render::ConeShape& cone) { return cone; },
        "a cone, or a truncated cone, whose axis is z");
    add_solids(s);
    s.exactly_one_of(shape_keys());
}

}  // namespace carom::pipeline::config
