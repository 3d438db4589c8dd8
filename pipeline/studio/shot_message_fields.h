// The fields of what the server says of a shot, in the order in which they are written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/message_value_fields.h"
#include "pipeline/studio/shot_messages.h"

namespace carom::studio {

constexpr auto fields_of(Describes<Problem>) {
    return fields<Problem>(
        field("severity", &Problem::severity), field("place", &Problem::place),
        field("key_path", &Problem::key_path), field("message", &Problem::message),
        field("suggestion", &Problem::suggestion), field("included_by", &Problem::included_by));
}

constexpr auto fields_of(Describes<Problems>) {
    return fields<Problems>(field("v", &Problems::v), field("complete", &Problems::complete),
                            field("list", &Problems::list));
}

constexpr auto fields_of(Describes<ValuePlace>) {
    return fields<ValuePlace>(field("path", &ValuePlace::path), field("key", &ValuePlace::key),
                              field("value", &ValuePlace::value),
                              field("origin", &ValuePlace::origin));
}

constexpr auto fields_of(Describes<SceneObject>) {
    return fields<SceneObject>(
        field("name", &SceneObject::name), field("kind", &SceneObject::kind),
        field("path", &SceneObject::path), field("shape", &SceneObject::shape),
        field("moves", &SceneObject::moves), field("track", &SceneObject::track),
        field("position", &SceneObject::position), field("orientation", &SceneObject::orientation),
        field("radius", &SceneObject::radius), field("number", &SceneObject::number),
        field("colour", &SceneObject::colour), field("material", &SceneObject::material));
}

constexpr auto fields_of(Describes<SceneLight>) {
    return fields<SceneLight>(
        field("name", &SceneLight::name), field("kind", &SceneLight::kind),
        field("path", &SceneLight::path), field("position", &SceneLight::position),
        field("facing", &SceneLight::facing), field("orientation", &SceneLight::orientation),
        field("colour", &SceneLight::colour), field("size", &SceneLight::size));
}

constexpr auto fields_of(Describes<PathPoint>) {
    return fields<PathPoint>(field("path", &PathPoint::path),
                             field("position", &PathPoint::position), field("of", &PathPoint::of),
                             field("at", &PathPoint::at), field("offset", &PathPoint::offset));
}

constexpr auto fields_of(Describes<Orbit>) {
    return fields<Orbit>(field("radii", &Orbit::radii), field("angles", &Orbit::angles),
                         field("turn", &Orbit::turn));
}

constexpr auto fields_of(Describes<PathShape>) {
    return fields<PathShape>(field("kind", &PathShape::kind), field("orbit", &PathShape::orbit),
                             field("points", &PathShape::points),
                             field("curve", &PathShape::curve));
}

constexpr auto fields_of(Describes<SpeedPoint>) {
    return fields<SpeedPoint>(field("path", &SpeedPoint::path),
                              field("video_time", &SpeedPoint::video_time),
                              field("speed", &SpeedPoint::speed));
}

constexpr auto fields_of(Describes<LensKey>) {
    return fields<LensKey>(field("path", &LensKey::path),
                           field("video_time", &LensKey::video_time));
}

constexpr auto fields_of(Describes<Camera>) {
    return fields<Camera>(
        field("name", &Camera::name), field("path", &Camera::path),
        field("video_start", &Camera::video_start), field("video_end", &Camera::video_end),
        field("fade", &Camera::fade), field("scene_start", &Camera::scene_start),
        field("scene_end", &Camera::scene_end), field("speeds", &Camera::speeds),
        field("smooth", &Camera::smooth), field("position", &Camera::position),
        field("target", &Camera::target), field("sensor_height", &Camera::sensor_height),
        field("fov_scale", &Camera::fov_scale), field("lens_keys", &Camera::lens_keys));
}

constexpr auto fields_of(Describes<ShotEvent>) {
    return fields<ShotEvent>(
        field("path", &ShotEvent::path), field("kind", &ShotEvent::kind),
        field("object", &ShotEvent::object), field("time", &ShotEvent::time),
        field("triggered", &ShotEvent::triggered), field("duration", &ShotEvent::duration),
        field("vector", &ShotEvent::vector), field("speed", &ShotEvent::speed),
        field("ball_speed", &ShotEvent::ball_speed), field("elevation", &ShotEvent::elevation),
        field("tip", &ShotEvent::tip), field("direction", &ShotEvent::direction),
        field("toward", &ShotEvent::toward));
}

constexpr auto fields_of(Describes<AnnotationEnd>) {
    return fields<AnnotationEnd>(field("time", &AnnotationEnd::time),
                                 field("is_scene_time", &AnnotationEnd::is_scene_time),
                                 field("moment", &AnnotationEnd::moment));
}

constexpr auto fields_of(Describes<AnnotationBox>) {
    return fields<AnnotationBox>(field("centre", &AnnotationBox::centre),
                                 field("size", &AnnotationBox::size));
}

constexpr auto fields_of(Describes<ShotAnnotation>) {
    return fields<ShotAnnotation>(
        field("path", &ShotAnnotation::path), field("kind", &ShotAnnotation::kind),
        field("subject", &ShotAnnotation::subject), field("text", &ShotAnnotation::text),
        field("from", &ShotAnnotation::from), field("to", &ShotAnnotation::to),
        field("box", &ShotAnnotation::box));
}

constexpr auto fields_of(Describes<CushionNose>) {
    return fields<CushionNose>(field("from", &CushionNose::from), field("to", &CushionNose::to));
}

constexpr auto fields_of(Describes<TablePocket>) {
    return fields<TablePocket>(field("name", &TablePocket::name),
                               field("place", &TablePocket::place),
                               field("radius", &TablePocket::radius));
}

constexpr auto fields_of(Describes<Table>) {
    return fields<Table>(field("length", &Table::length), field("width", &Table::width),
                         field("cushion_height", &Table::cushion_height),
                         field("ball_radius", &Table::ball_radius));
}

constexpr auto fields_of(Describes<Film>) {
    return fields<Film>(field("width", &Film::width), field("height", &Film::height),
                        field("fps", &Film::fps), field("frames", &Film::frames),
                        field("duration", &Film::duration), field("samples", &Film::samples));
}

constexpr auto fields_of(Describes<Names>) {
    return fields<Names>(field("balls", &Names::balls), field("objects", &Names::objects),
                         field("materials", &Names::materials), field("lights", &Names::lights),
                         field("cameras", &Names::cameras), field("surfaces", &Names::surfaces),
                         field("spots", &Names::spots), field("pockets", &Names::pockets));
}

constexpr auto fields_of(Describes<ShotState>) {
    return fields<ShotState>(
        field("v", &ShotState::v), field("moves", &ShotState::moves),
        field("name", &ShotState::name), field("film", &ShotState::film),
        field("table", &ShotState::table), field("noses", &ShotState::noses),
        field("pockets", &ShotState::pockets), field("objects", &ShotState::objects),
        field("lights", &ShotState::lights), field("cameras", &ShotState::cameras),
        field("events", &ShotState::events), field("annotations", &ShotState::annotations),
        field("names", &ShotState::names), field("places", &ShotState::places));
}

constexpr auto fields_of(Describes<SceneMeshes>) {
    return fields<SceneMeshes>(field("v", &SceneMeshes::v), field("hash", &SceneMeshes::hash));
}

constexpr auto fields_of(Describes<Deferred>) {
    return fields<Deferred>(field("v", &Deferred::v), field("reason", &Deferred::reason),
                            field("message", &Deferred::message));
}

}  // namespace carom::studio
