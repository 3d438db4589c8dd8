// The fields of a world's description, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "sim/billiards/table_fields.h"
#include "sim/contact_law_fields.h"
#include "sim/force_event_fields.h"
#include "sim/timeline/track_fields.h"
#include "sim/world.h"

namespace carom::sim {

constexpr auto fields_of(Describes<Sphere>) {
    return fields<Sphere>(field("radius", &Sphere::radius));
}

constexpr auto fields_of(Describes<Box>) {
    return fields<Box>(field("size", &Box::size));
}

constexpr auto fields_of(Describes<Capsule>) {
    return fields<Capsule>(field("radius", &Capsule::radius), field("length", &Capsule::length));
}

constexpr auto fields_of(Describes<Cylinder>) {
    return fields<Cylinder>(field("radius", &Cylinder::radius), field("height", &Cylinder::height));
}

constexpr auto fields_of(Describes<ConvexHull>) {
    return fields<ConvexHull>(field("points", &ConvexHull::points));
}

constexpr auto fields_of(Describes<TriangleMesh>) {
    return fields<TriangleMesh>(field("vertices", &TriangleMesh::vertices),
                                field("triangles", &TriangleMesh::triangles));
}

constexpr auto fields_of(Describes<KeyedPath>) {
    return fields<KeyedPath>(field("centre", &KeyedPath::centre),
                             field("track", &KeyedPath::track));
}

constexpr auto fields_of(Describes<Body>) {
    using T = Body;
    return fields<T>(field("name", &T::name), field("shape", &T::shape), field("kind", &T::kind),
                     field("mass", &T::mass), field("material", &T::material),
                     field("pose", &T::pose), field("velocity", &T::velocity),
                     field("angular_velocity", &T::angular_velocity),
                     field_if_given("path", &T::path, "kinematic bodies have one, and no others"));
}

constexpr auto fields_of(Describes<WorldDescription>) {
    using T = WorldDescription;
    return fields<T>(field("gravity", &T::gravity), field("duration", &T::duration),
                     field("step", &T::step), field("seed", &T::seed),
                     field("key_reduction", &T::key_reduction),
                     field("contact_law", &T::contact_law), field("table", &T::table),
                     field("floor_height", &T::floor_height), field("bodies", &T::bodies),
                     field("events", &T::events),
                     field_if_given("respot", &T::respot,
                                    "it is the last field, and worlds without it keep their hash"));
}

}  // namespace carom::sim
