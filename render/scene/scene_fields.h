// The fields of shapes, objects and lights, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "render/scene/material_fields.h"
#include "render/scene/scene_description.h"

namespace carom::render {

// ---- shapes ----------------------------------------------------------------------------------

constexpr auto fields_of(Describes<SphereShape>) {
    return fields<SphereShape>(field("radius", &SphereShape::radius));
}

constexpr auto fields_of(Describes<BoxShape>) {
    return fields<BoxShape>(field("size", &BoxShape::size));
}

constexpr auto fields_of(Describes<PlaneShape>) {
    return fields<PlaneShape>();
}

constexpr auto fields_of(Describes<RectangleShape>) {
    return fields<RectangleShape>(field("size", &RectangleShape::size));
}

constexpr auto fields_of(Describes<TriangleShape>) {
    return fields<TriangleShape>(field("corners", &TriangleShape::corners));
}

constexpr auto fields_of(Describes<ParallelogramShape>) {
    using T = ParallelogramShape;
    return fields<T>(field("corner", &T::corner), field("edge_u", &T::edge_u),
                     field("edge_v", &T::edge_v));
}

constexpr auto fields_of(Describes<DiskShape>) {
    return fields<DiskShape>(field("radius", &DiskShape::radius));
}

constexpr auto fields_of(Describes<CylinderShape>) {
    using T = CylinderShape;
    return fields<T>(field("radius", &T::radius), field("height", &T::height));
}

constexpr auto fields_of(Describes<ConeShape>) {
    using T = ConeShape;
    return fields<T>(field("radius", &T::radius), field("top_radius", &T::top_radius),
                     field("height", &T::height));
}

constexpr auto fields_of(Describes<CapsuleShape>) {
    using T = CapsuleShape;
    return fields<T>(field("radius", &T::radius), field("length", &T::length));
}

constexpr auto fields_of(Describes<RoundedBoxShape>) {
    using T = RoundedBoxShape;
    return fields<T>(field("size", &T::size), field("radius", &T::radius));
}

constexpr auto fields_of(Describes<MeshShape>) {
    using T = MeshShape;
    return fields<T>(file_field("file", &T::file), field("smooth_angle", &T::smooth_angle),
                     field("vertices", &T::vertices), field("normals", &T::normals),
                     field("uv", &T::uv), field("triangles", &T::triangles));
}

// ---- objects ---------------------------------------------------------------------------------

constexpr auto fields_of(Describes<ObjectDescription>) {
    using T = ObjectDescription;
    return fields<T>(
        unhashed("name", &T::name, "only mattes show it: frame_key adds it for them"),
        field("shape", &T::shape), field("world_from_object", &T::world_from_object),
        hashed_elsewhere("track", &T::track, "hash_scene adds whether there is one, frame_key it"),
        hashed_elsewhere("material", &T::material, "hash_scene adds the material of that name"));
}

// ---- lights ----------------------------------------------------------------------------------

constexpr auto fields_of(Describes<RectangleLight>) {
    using T = RectangleLight;
    return fields<T>(field("centre", &T::centre), field("edge_u", &T::edge_u),
                     field("edge_v", &T::edge_v), field("normal", &T::normal),
                     field("radiance", &T::radiance), field("falloff", &T::falloff));
}

constexpr auto fields_of(Describes<SphereLight>) {
    using T = SphereLight;
    return fields<T>(field("centre", &T::centre), field("radius", &T::radius),
                     field("radiance", &T::radiance), field("falloff", &T::falloff));
}

constexpr auto fields_of(Describes<Sky>) {
    return fields<Sky>(field("sun", &Sky::sun), field("turbidity", &Sky::turbidity),
                       field("ground", &Sky::ground));
}

constexpr auto fields_of(Describes<EnvironmentLight>) {
    using T = EnvironmentLight;
    return fields<T>(field("radiance", &T::radiance), file_field("image", &T::image),
                     field("rotation", &T::rotation), field("sky", &T::sky));
}

constexpr auto fields_of(Describes<PointLight>) {
    using T = PointLight;
    return fields<T>(field("position", &T::position), field("intensity", &T::intensity),
                     field("falloff", &T::falloff));
}

constexpr auto fields_of(Describes<SpotLight>) {
    using T = SpotLight;
    return fields<T>(field("position", &T::position), field("direction", &T::direction),
                     field("intensity", &T::intensity), field("inner_angle", &T::inner_angle),
                     field("outer_angle", &T::outer_angle), field("falloff", &T::falloff));
}

constexpr auto fields_of(Describes<DirectionalLight>) {
    using T = DirectionalLight;
    return fields<T>(field("direction", &T::direction), field("irradiance", &T::irradiance));
}

constexpr auto fields_of(Describes<LightDescription>) {
    using T = LightDescription;
    return fields<T>(unhashed("name", &T::name, "only mattes show it: frame_key adds it for them"),
                     field("light", &T::light));
}

}  // namespace carom::render
