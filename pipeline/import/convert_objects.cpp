// Converts shapes to objects. Spheres that use physics become moving bodies; boxes move, too,
// unless others stand on them.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
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
    const Object* object = nullptr;
    Frame base;
    Vec3 up, centre;

    [[nodiscard]] Vec3 half_size() const {
        return Vec3(base.width, base.breadth, *object->height) / 2;
    }
};

std::optional<BoxFrame> box_frame(const Object& object, Conversion& conversion) {
    const std::optional<Frame> base = rectangle_frame(object, conversion);
    if (!base) {
        return std::nullopt;
    }
    BoxFrame box{&object, *base, base->y.cross(base->x), {}};
    box.centre = base->middle + box.up * (*object.height / 2);
    return box;
}

/// The boxes that use physics.
std::vector<BoxFrame> physical_boxes(Conversion& conversion) {
    std::vector<BoxFrame> boxes;
    for (const Object& object : conversion.scene.objects) {
        if (object.kind == ShapeKind::box && object.uses_physics) {
            if (const std::optional<BoxFrame> box = box_frame(object, conversion)) {
                boxes.push_back(*box);
            }
        }
    }
    return boxes;
}

/// The greatest extent of the box from its centre along `axis`.
double reach(const BoxFrame& box, const Vec3& axis) {
    const Vec3 half = box.half_size();
    return std::abs(half.x * box.base.x.dot(axis)) + std::abs(half.y * box.base.y.dot(axis)) +
           std::abs(half.z * box.up.dot(axis));
}

/// The lowest of the boxes, if the centre of a sphere or of another box is above its top. Of
/// equally low ones the largest.
const BoxFrame* ground(const std::vector<BoxFrame>& boxes, const SceneModel& scene,
                       const Vec3& up) {
    const auto bottom = [&](const BoxFrame& box) { return box.centre.dot(up) - reach(box, up); };
    const auto lowest =
        std::min_element(boxes.begin(), boxes.end(), [&](const BoxFrame& a, const BoxFrame& b) {
            const double difference = bottom(a) - bottom(b);
            const double least = 1e-6 * (a.half_size().length() + b.half_size().length());
            return std::abs(difference) > least ? difference < 0
                                                : a.half_size().length() > b.half_size().length();
        });
    if (lowest == boxes.end()) {
        return nullptr;
    }
    const double top = lowest->centre.dot(up) + reach(*lowest, up);
    const bool bears_box = std::any_of(
        boxes.begin(), boxes.end(), [&](const BoxFrame& box) { return box.centre.dot(up) > top; });
    const bool bears_sphere =
        std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
            return object.kind == ShapeKind::sphere && object.position->dot(up) > top;
        });
    return bears_box || bears_sphere ? &*lowest : nullptr;
}

/// Which bodies move. The text says of boxes only that they use physics: its own example has a
/// table, which has to stay where it is. So the ground stays, and boxes at least a quarter as long
/// as it, such as cushions and walls.
void choose_moving(SceneModel& scene, const std::vector<BoxFrame>& boxes, Conversion& conversion) {
    const auto longest = [](const BoxFrame& box) {
        const Vec3 half = box.half_size();
        return std::max({half.x, half.y, half.z});
    };
    const BoxMotion motion = conversion.options.boxes;
    const BoxFrame* base = ground(boxes, scene, conversion.axes.author_up());
    std::set<const Object*> fixed;
    for (const BoxFrame& box : boxes) {
        const bool is_large = base != nullptr && longest(box) >= longest(*base) / 4;
        if (motion == BoxMotion::fixed || (motion == BoxMotion::automatic && is_large)) {
            fixed.insert(box.object);
        }
    }
    for (Object& object : scene.objects) {
        object.moves = object.uses_physics && fixed.count(&object) == 0;
    }
    for (const BoxFrame& box : boxes) {
        const bool is_fixed = fixed.count(box.object) == 1;
        conversion.note(owner(*box.object) +
                        (is_fixed ? " uses physics and is fixed: others collide with it"
                                  : " uses physics and moves") +
                        (motion != BoxMotion::automatic ? std::string()
                         : is_fixed                     ? "; with '--boxes dynamic' it moves"
                                                        : "; with '--boxes fixed' it does not"));
    }
}

/// Moves a sphere that penetrates boxes to their surfaces.
void push_out(Object& sphere, const std::vector<BoxFrame>& boxes, Conversion& conversion) {
    for (const BoxFrame& box : boxes) {
        const Vec3 from_centre = *sphere.position - box.centre;
        const Vec3 half = box.half_size();
        const Vec3 nearest = box.centre +
                             box.base.x * std::clamp(from_centre.dot(box.base.x), -half.x, half.x) +
                             box.base.y * std::clamp(from_centre.dot(box.base.y), -half.y, half.y) +
                             box.up * std::clamp(from_centre.dot(box.up), -half.z, half.z);
        const Vec3 way = *sphere.position - nearest;
        const double distance = way.length();
        if (distance > 1e-9 * *sphere.radius && distance < *sphere.radius) {
            const double depth = *sphere.radius - distance;
            sphere.position = nearest + way * ((1 + 1e-7) * *sphere.radius / distance);
            if (depth > 1e-6 * *sphere.radius) {
                conversion.note(owner(sphere) + " overlapped " + owner(*box.object) + " by " +
                                yaml(depth) + " and was moved out of it");
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

std::string physics(const Object& object, const Conversion& conversion) {
    if (!object.uses_physics) {
        return {};
    }
    if (!object.moves) {
        return "physics: fixed";
    }
    const char* material = object.kind == ShapeKind::sphere ? "material: ball, " : "";
    return std::string("physics: {") + material + "density: " + yaml(conversion.options.density) +
           " kg/m^3}";
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
    const std::vector<BoxFrame> boxes = physical_boxes(conversion);
    choose_moving(scene, boxes, conversion);
    std::ostringstream objects;
    std::ostringstream events;
    Names names(names_of(scene.objects));
    MaterialTable materials(conversion);
    for (Object& object : scene.objects) {
        if (object.kind == ShapeKind::sphere && object.uses_physics) {
            push_out(object, boxes, conversion);
        }
        const std::string name = conversion.name("object", object.name.text, names);
        const std::string material =
            object.material ? "material: " + materials.use(*object.material, &object) : "";
        objects << "  " << name << ": {"
                << joined({shape(object, conversion), material, physics(object, conversion)})
                << "}\n";
        add_events(object, name, last_time, conversion, events);
    }
    if (std::any_of(scene.objects.begin(), scene.objects.end(), std::mem_fn(&Object::moves))) {
        conversion.note(
            "gravity is 9.81 m/s^2, and friction and restitution are carom's defaults, because the "
            "text has none");
    }
    std::string text = materials.section();
    if (!scene.objects.empty()) {
        text = "objects:\n" + objects.str() + text;
    }
    if (!events.str().empty()) {
        text += "events:\n" + events.str();
    }
    return text;
}

}  // namespace carom::pipeline::scene_text
