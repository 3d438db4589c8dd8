// The fields of the heads of binary messages, in the order in which they are written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/binary_messages.h"

namespace carom::studio {

constexpr auto fields_of(Describes<TrackHead>) {
    return fields<TrackHead>(field("name", &TrackHead::name), field("first", &TrackHead::first),
                             field("keys", &TrackHead::keys));
}

constexpr auto fields_of(Describes<TimelineEvent>) {
    return fields<TimelineEvent>(
        field("kind", &TimelineEvent::kind), field("time", &TimelineEvent::time),
        field("end_time", &TimelineEvent::end_time), field("a", &TimelineEvent::a),
        field("b", &TimelineEvent::b), field("place", &TimelineEvent::place),
        field("impulse", &TimelineEvent::impulse), field("text", &TimelineEvent::text));
}

constexpr auto fields_of(Describes<TimelineHead>) {
    return fields<TimelineHead>(
        field("v", &TimelineHead::v), field("kept", &TimelineHead::kept),
        field("start", &TimelineHead::start), field("end", &TimelineHead::end),
        field("tracks", &TimelineHead::tracks), field("events", &TimelineHead::events),
        field("energy", &TimelineHead::energy), field("milliseconds", &TimelineHead::milliseconds));
}

constexpr auto fields_of(Describes<FanTrack>) {
    return fields<FanTrack>(field("name", &FanTrack::name), field("run", &FanTrack::run),
                            field("first", &FanTrack::first), field("points", &FanTrack::points));
}

constexpr auto fields_of(Describes<FanOutcome>) {
    return fields<FanOutcome>(field("kind", &FanOutcome::kind), field("a", &FanOutcome::a),
                              field("b", &FanOutcome::b), field("text", &FanOutcome::text),
                              field("runs", &FanOutcome::runs), field("first", &FanOutcome::first),
                              field("last", &FanOutcome::last));
}

constexpr auto fields_of(Describes<FanHead>) {
    return fields<FanHead>(field("v", &FanHead::v), field("runs", &FanHead::runs),
                           field("finished", &FanHead::finished), field("tracks", &FanHead::tracks),
                           field("outcomes", &FanHead::outcomes));
}

constexpr auto fields_of(Describes<AnnotationLabel>) {
    return fields<AnnotationLabel>(
        field("text", &AnnotationLabel::text), field("font", &AnnotationLabel::font),
        field("line_height", &AnnotationLabel::line_height),
        field("letters", &AnnotationLabel::letters), field("margin", &AnnotationLabel::margin),
        field("offset", &AnnotationLabel::offset), field("is_above", &AnnotationLabel::is_above),
        field("nearer", &AnnotationLabel::nearer),
        field("box_colour", &AnnotationLabel::box_colour),
        field("box_opacity", &AnnotationLabel::box_opacity));
}

constexpr auto fields_of(Describes<AnnotationShape>) {
    return fields<AnnotationShape>(
        field("annotation", &AnnotationShape::annotation), field("kind", &AnnotationShape::kind),
        field("first", &AnnotationShape::first), field("points", &AnnotationShape::points),
        field("colour", &AnnotationShape::colour), field("opacity", &AnnotationShape::opacity),
        field("width", &AnnotationShape::width), field("is_closed", &AnnotationShape::is_closed),
        field("has_round_ends", &AnnotationShape::has_round_ends),
        field("has_head", &AnnotationShape::has_head), field("label", &AnnotationShape::label));
}

constexpr auto fields_of(Describes<AnnotationsHead>) {
    return fields<AnnotationsHead>(field("q", &AnnotationsHead::q), field("v", &AnnotationsHead::v),
                                   field("shapes", &AnnotationsHead::shapes));
}

constexpr auto fields_of(Describes<CamerasHead>) {
    return fields<CamerasHead>(field("v", &CamerasHead::v),
                               field("entries", &CamerasHead::entries));
}

constexpr auto fields_of(Describes<PictureHead>) {
    return fields<PictureHead>(
        field("q", &PictureHead::q), field("v", &PictureHead::v),
        field("width", &PictureHead::width), field("height", &PictureHead::height),
        field("samples", &PictureHead::samples), field("of_samples", &PictureHead::of_samples),
        field("complete", &PictureHead::complete), field("stored", &PictureHead::stored),
        field("channel", &PictureHead::channel), field("legend", &PictureHead::legend));
}

}  // namespace carom::studio
