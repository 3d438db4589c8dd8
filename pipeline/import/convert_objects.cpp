// Converts shapes to objects. Spheres that use physics become moving bodies, boxes become fixed
// ones.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/text.h"
#include "pipeline/config/text.h"
#include "pipeline/import/conversion.h"

namespace carom::pipeline::scene_text {

namespace {

using config::quote;

std::string owner(const Object& object) {
    constexpr const char* kNames[] = {"plane", "sphere", "triangle", "rectangle", "box"};
    return std::string(kNames[static_cast<int>(object.kind)]) + " " + quote(object.name.text);
}

/// The part of v perpendicular to the unit vector `axis`.
Vec3 perpendicular_part(const Vec3& v, const Vec3& axis) {
    return v - axis * axis.dot(v);
}

/// A rectangle given by an edge and a point of the opposite side, in the author's units.
struct Frame {
    Vec3 middle;         // of the rectangle
    Vec3 x, y;           // unit, along the edge and towards the opposite side
    double width = 0;    // along x
    double breadth = 0;  // along y
};

/// Empty, with a problem, if the points are collinear.
std::optional<Frame> rectangle_frame(const Object& object, Conversion& conversion) {
    const Vec3 start = *object.vertices[0];
    const Vec3 edge = *object.vertices[1] - start;
    Frame frame;
    frame.width = edge.length();
    frame.x = edge / std::max(frame.width, 1e-300);
    const Vec3 across = perpendicular_part(*object.vertices[2] - start, frame.x);
    frame.breadth = across.length();
    const double size = std::max(frame.width, (*object.vertices[2] - start).length());
    if (!(frame.width > 1e-9 * size) || !(frame.breadth > 1e-9 * size)) {
        conversion.problems.error(object.name.place,
                                  "the vertices of " + owner(object) + " lie in a line");
        return std::nullopt;
    }
    frame.y = across / frame.breadth;
    frame.middle = start + edge / 2 + across / 2;
    return frame;
}

/// A box stands on the rectangle, on the side from which the rotation from its second edge to its
/// first one is counter-clockwise, as in both examples of the format.
struct BoxFrame {
    Frame base;
    Vec3 up, centre;
};

std::optional<BoxFrame> box_frame(const Object& object, Conversion& conversion) {
    const std::optional<Frame> base = rectangle_frame(object, conversion);
    if (!base) {
        return std::nullopt;
    }
    BoxFrame box{*base, base->y.cross(base->x), {}};
    box.centre = base->middle + box.up * (*object.height / 2);
    return box;
}

/// Moves spheres that penetrate a fixed box to its surface.
void push_out(Object& sphere, const std::vector<std::pair<std::string, BoxFrame>>& boxes,
              const std::vector<double>& heights, Conversion& conversion) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto& [name, box] = boxes[i];
        const Vec3 from_centre = *sphere.position - box.centre;
        const Vec3 nearest =
            box.centre +
            box.base.x *
                std::clamp(from_centre.dot(box.base.x), -box.base.width / 2, box.base.width / 2) +
            box.base.y * std::clamp(from_centre.dot(box.base.y), -box.base.breadth / 2,
                                    box.base.breadth / 2) +
            box.up * std::clamp(from_centre.dot(box.up), -heights[i] / 2, heights[i] / 2);
        const Vec3 way = *sphere.position - nearest;
        const double distance = way.length();
        if (distance > 1e-9 * *sphere.radius && distance < *sphere.radius) {
            const double depth = *sphere.radius - distance;
            sphere.position = nearest + way * ((1 + 1e-7) * *sphere.radius / distance);
            if (depth > 1e-6 * *sphere.radius) {
                conversion.note(owner(sphere) + " overlapped box " + name + " by " + yaml(depth) +
                                " and was moved out of it");
            }
        }
    }
}

std::string rotation(const Object& object, const Axes& axes, Conversion& conversion) {
    if (!object.pole && !object.equator) {
        return {};
    }
    const Vec3 z = object.pole.value_or(axes.author_up()).normalized();
    const Vec3 x = perpendicular_part(object.equator.value_or(Vec3(1, 0, 0)), z);
    if (x.length() < 1e-9 || z.length() < 0.5) {
        conversion.note(owner(object) + ": v_e and v_n do not span a plane; it is not rotated");
        return {};
    }
    const Vec3 our_z = axes.direction(z);
    const Vec3 our_x = axes.direction(x.normalized());
    return yaml_rotation(our_x, our_z.cross(our_x), our_z);
}

/// The parts that are not empty, separated by commas.
std::string joined(std::vector<std::string> parts) {
    std::erase(parts, "");
    return join(parts, ", ");
}

/// "plane: infinite, at: [...]"; empty after a problem.
std::string shape(const Object& object, Conversion& conversion) {
    const Axes& axes = conversion.axes;
    const auto at = [&](const Vec3& place) { return "at: " + yaml(axes.place(place)); };
    const auto turned = [&](const Vec3& x, const Vec3& y) {
        const Vec3 our_x = axes.direction(x);
        const Vec3 our_y = axes.direction(y);
        return yaml_rotation(our_x, our_y, our_x.cross(our_y));
    };
    switch (object.kind) {
        case ShapeKind::plane: {
            const Vec3 normal = object.normal->normalized();
            const Vec3 helper = std::abs(normal.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
            const Vec3 x = perpendicular_part(helper, normal).normalized();
            return joined({"plane: infinite", at(*object.position), turned(x, normal.cross(x))});
        }
        case ShapeKind::sphere:
            return joined({"sphere: " + yaml(axes.length(*object.radius)), at(*object.position),
                           rotation(object, axes, conversion)});
        case ShapeKind::triangle: {
            const Vec3 a = *object.vertices[1] - *object.vertices[0];
            const Vec3 b = *object.vertices[2] - *object.vertices[0];
            if (!(a.cross(b).length() > 1e-9 * std::max(a.dot(a), b.dot(b)))) {
                conversion.problems.error(object.name.place,
                                          "the vertices of " + owner(object) + " lie in a line");
                return {};
            }
            return "triangle: [" + yaml(axes.place(*object.vertices[0])) + ", " +
                   yaml(axes.place(*object.vertices[1])) + ", " +
                   yaml(axes.place(*object.vertices[2])) + "]";
        }
        case ShapeKind::rectangle: {
            const std::optional<Frame> frame = rectangle_frame(object, conversion);
            if (!frame) {
                return {};
            }
            return joined({"rectangle: [" + yaml(axes.length(frame->width)) + ", " +
                               yaml(axes.length(frame->breadth)) + "]",
                           at(frame->middle), turned(frame->x, frame->y)});
        }
        case ShapeKind::box: {
            const std::optional<BoxFrame> box = box_frame(object, conversion);
            if (!box) {
                return {};
            }
            // The box's z axis is -up, because x, y and up are left-handed.
            return joined(
                {"box: " + yaml(Vec3(axes.length(box->base.width), axes.length(box->base.breadth),
                                     axes.length(*object.height))),
                 at(box->centre), turned(box->base.x, box->base.y)});
        }
    }
    return {};
}

std::string physics(const Object& object, Conversion& conversion) {
    if (object.kind == ShapeKind::box && object.uses_physics) {
        conversion.note("boxes that use physics became fixed objects, with which others collide");
        return "physics: fixed";
    }
    if (object.uses_physics) {
        return "physics: {material: ball, density: " + yaml(conversion.options.density) +
               " kg/m^3}";
    }
    return {};
}

void add_events(const Object& object, const std::string& name, double last_time,
                Conversion& conversion, std::ostringstream& out) {
    const ImportOptions& options = conversion.options;
    for (const ForceEvent& event : object.events) {
        if (!object.uses_physics) {
            conversion.note(owner(object) + " does not use physics; its forces were left out");
            return;
        }
        if (event.time > last_time) {
            conversion.note(owner(object) + ": a force at " + yaml(event.time) +
                            " s, after the end of the film, was left out");
            continue;
        }
        // In the author's units the density is 1, so momentum scales as density unit^4.
        const double scale = options.force_time * options.density * std::pow(options.unit, 4);
        conversion.note("a force became one impulse: it acts for " + yaml(options.force_time) +
                        " s on a body with density 1 per cubic unit");
        out << "  - impulse: {object: " << name << ", at: " << yaml(event.time)
            << " s, newton_seconds: " << yaml(conversion.axes.direction(event.force) * scale)
            << "}\n";
    }
}

}  // namespace

std::string objects_and_events(Conversion& conversion, double last_time) {
    SceneModel& scene = conversion.scene;
    std::vector<std::pair<std::string, BoxFrame>> boxes;
    std::vector<double> heights;
    for (const Object& object : scene.objects) {
        if (object.kind == ShapeKind::box && object.uses_physics) {
            if (const std::optional<BoxFrame> box = box_frame(object, conversion)) {
                boxes.emplace_back(quote(object.name.text), *box);
                heights.push_back(*object.height);
            }
        }
    }
    std::ostringstream objects;
    std::ostringstream events;
    Names names;
    bool anything_moves = false;
    for (Object& object : scene.objects) {
        if (object.kind == ShapeKind::sphere && object.uses_physics) {
            push_out(object, boxes, heights, conversion);
            anything_moves = true;
        }
        const std::string name = names.claim(object.name.text);
        const std::string material =
            object.material ? "material: " + conversion.material_names[*object.material] : "";
        objects << "  " << name << ": {"
                << joined({shape(object, conversion), material, physics(object, conversion)})
                << "}\n";
        add_events(object, name, last_time, conversion, events);
    }
    if (anything_moves) {
        conversion.note(
            "gravity is 9.81 m/s^2, and friction and restitution are carom's defaults, because the "
            "text has none");
    }
    std::string text;
    if (!scene.objects.empty()) {
        text += "objects:\n" + objects.str();
    }
    if (!events.str().empty()) {
        text += "events:\n" + events.str();
    }
    return text;
}

}  // namespace carom::pipeline::scene_text
