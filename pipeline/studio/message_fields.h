// The fields of the messages, in the order in which they are written. The page's types
// (studio/src/protocol.ts) are generated from these lists.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

constexpr auto fields_of(Describes<TextRange>) {
    return fields<TextRange>(field("file", &TextRange::file), field("line", &TextRange::line),
                             field("column", &TextRange::column),
                             field("length", &TextRange::length));
}

// ---- from the page ------------------------------------------------------------------------------

constexpr auto fields_of(Describes<Hello>) {
    return fields<Hello>(field("protocol", &Hello::protocol));
}

constexpr auto fields_of(Describes<TextChange>) {
    return fields<TextChange>(field("v", &TextChange::v), field("file", &TextChange::file),
                              field("text", &TextChange::text));
}

constexpr auto fields_of(Describes<Save>) {
    return fields<Save>(field("file", &Save::file), field("text", &Save::text),
                        field("base_hash", &Save::base_hash), field("force", &Save::force));
}

constexpr auto fields_of(Describes<Revert>) {
    return fields<Revert>(field("v", &Revert::v), field("file", &Revert::file));
}

constexpr auto fields_of(Describes<Open>) {
    return fields<Open>(field("file", &Open::file), field("from", &Open::from),
                        field("text", &Open::text), field("overwrite", &Open::overwrite));
}

constexpr auto fields_of(Describes<SaveAs>) {
    return fields<SaveAs>(field("file", &SaveAs::file), field("overwrite", &SaveAs::overwrite));
}

constexpr auto fields_of(Describes<ListFolder>) {
    return fields<ListFolder>(field("folder", &ListFolder::folder));
}

constexpr auto fields_of(Describes<Offer>) {
    return fields<Offer>();
}

constexpr auto fields_of(Describes<Forget>) {
    return fields<Forget>(field("file", &Forget::file));
}

constexpr auto fields_of(Describes<Import>) {
    return fields<Import>(field("name", &Import::name), field("text", &Import::text));
}

constexpr auto fields_of(Describes<ReadParts>) {
    return fields<ReadParts>(field("file", &ReadParts::file), field("text", &ReadParts::text));
}

constexpr auto fields_of(Describes<PartName>) {
    return fields<PartName>(field("section", &PartName::section), field("name", &PartName::name));
}

constexpr auto fields_of(Describes<AddParts>) {
    return fields<AddParts>(field("file", &AddParts::file), field("text", &AddParts::text),
                            field("parts", &AddParts::parts));
}

constexpr auto fields_of(Describes<Fan>) {
    return fields<Fan>(field("v", &Fan::v), field("runs", &Fan::runs),
                       field("distance", &Fan::distance), field("angle", &Fan::angle));
}

constexpr auto fields_of(Describes<Unfan>) {
    return fields<Unfan>();
}

constexpr auto fields_of(Describes<Dragging>) {
    return fields<Dragging>(field("on", &Dragging::on));
}

constexpr auto fields_of(Describes<Recover>) {
    return fields<Recover>(field("use", &Recover::use));
}

constexpr auto fields_of(Describes<Simulate>) {
    return fields<Simulate>(field("v", &Simulate::v));
}

constexpr auto fields_of(Describes<FreeView>) {
    return fields<FreeView>(field("scene_time", &FreeView::scene_time),
                            field("position", &FreeView::position),
                            field("target", &FreeView::target), field("up", &FreeView::up),
                            field("fov", &FreeView::fov), field("focus", &FreeView::focus),
                            field("lens_radius", &FreeView::lens_radius));
}

constexpr auto fields_of(Describes<See>) {
    return fields<See>(field("q", &See::q), field("v", &See::v), field("frame", &See::frame),
                       field("view", &See::view), field("width", &See::width),
                       field("height", &See::height), field("samples", &See::samples),
                       field("channel", &See::channel));
}

constexpr auto fields_of(Describes<Unsee>) {
    return fields<Unsee>();
}

constexpr auto fields_of(Describes<StartFilm>) {
    return fields<StartFilm>(field("output", &StartFilm::output),
                             field("quality", &StartFilm::quality),
                             field("frames", &StartFilm::frames), field("size", &StartFilm::size),
                             field("overwrite", &StartFilm::overwrite));
}

constexpr auto fields_of(Describes<StopFilm>) {
    return fields<StopFilm>();
}

constexpr auto fields_of(Describes<Make>) {
    return fields<Make>(field("q", &Make::q), field("what", &Make::what),
                        field("output", &Make::output), field("frame", &Make::frame),
                        field("rate", &Make::rate), field("overwrite", &Make::overwrite));
}

constexpr auto fields_of(Describes<StopMaking>) {
    return fields<StopMaking>(field("q", &StopMaking::q));
}

// ---- from the server ----------------------------------------------------------------------------

constexpr auto fields_of(Describes<Welcome>) {
    return fields<Welcome>(field("protocol", &Welcome::protocol),
                           field("version", &Welcome::version), field("v", &Welcome::v),
                           field("shot", &Welcome::shot), field("root", &Welcome::root));
}

constexpr auto fields_of(Describes<StartFile>) {
    return fields<StartFile>(field("file", &StartFile::file), field("name", &StartFile::name),
                             field("about", &StartFile::about), field("still", &StartFile::still));
}

constexpr auto fields_of(Describes<Start>) {
    return fields<Start>(field("templates", &Start::templates), field("examples", &Start::examples),
                         field("recent", &Start::recent));
}

constexpr auto fields_of(Describes<Exists>) {
    return fields<Exists>(field("what", &Exists::what), field("file", &Exists::file),
                          field("name", &Exists::name));
}

constexpr auto fields_of(Describes<FolderEntry>) {
    return fields<FolderEntry>(field("name", &FolderEntry::name), field("file", &FolderEntry::file),
                               field("is_folder", &FolderEntry::is_folder));
}

constexpr auto fields_of(Describes<Folder>) {
    return fields<Folder>(field("folder", &Folder::folder), field("name", &Folder::name),
                          field("parent", &Folder::parent), field("entries", &Folder::entries));
}

constexpr auto fields_of(Describes<Imported>) {
    return fields<Imported>(field("name", &Imported::name), field("yaml", &Imported::yaml),
                            field("problems", &Imported::problems),
                            field("notes", &Imported::notes));
}

constexpr auto fields_of(Describes<Part>) {
    return fields<Part>(field("section", &Part::section), field("name", &Part::name),
                        field("about", &Part::about), field("exists", &Part::exists));
}

constexpr auto fields_of(Describes<Parts>) {
    return fields<Parts>(field("file", &Parts::file), field("parts", &Parts::parts));
}

constexpr auto fields_of(Describes<Addition>) {
    return fields<Addition>(field("section", &Addition::section), field("name", &Addition::name),
                            field("yaml", &Addition::yaml), field("of", &Addition::of));
}

constexpr auto fields_of(Describes<Additions>) {
    return fields<Additions>(field("list", &Additions::list));
}

constexpr auto fields_of(Describes<OpenFile>) {
    return fields<OpenFile>(field("file", &OpenFile::file), field("name", &OpenFile::name),
                            field("text", &OpenFile::text), field("hash", &OpenFile::hash),
                            field("writable", &OpenFile::writable),
                            field("changed", &OpenFile::changed));
}

constexpr auto fields_of(Describes<Files>) {
    return fields<Files>(field("v", &Files::v), field("files", &Files::files));
}

constexpr auto fields_of(Describes<TextChanged>) {
    return fields<TextChanged>(field("v", &TextChanged::v), field("file", &TextChanged::file),
                               field("text", &TextChanged::text));
}

constexpr auto fields_of(Describes<Saved>) {
    return fields<Saved>(field("file", &Saved::file), field("hash", &Saved::hash));
}

constexpr auto fields_of(Describes<DiskChanged>) {
    return fields<DiskChanged>(field("file", &DiskChanged::file), field("text", &DiskChanged::text),
                               field("hash", &DiskChanged::hash),
                               field("refused", &DiskChanged::refused));
}

constexpr auto fields_of(Describes<RecoveredText>) {
    return fields<RecoveredText>(
        field("file", &RecoveredText::file), field("text", &RecoveredText::text),
        field("base_hash", &RecoveredText::base_hash), field("hash", &RecoveredText::hash));
}

constexpr auto fields_of(Describes<Recovered>) {
    return fields<Recovered>(field("files", &Recovered::files));
}

constexpr auto fields_of(Describes<Failed>) {
    return fields<Failed>(field("what", &Failed::what), field("v", &Failed::v),
                          field("message", &Failed::message));
}

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
        field("moves", &SceneObject::moves), field("position", &SceneObject::position),
        field("orientation", &SceneObject::orientation), field("radius", &SceneObject::radius),
        field("number", &SceneObject::number), field("colour", &SceneObject::colour),
        field("material", &SceneObject::material));
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

constexpr auto fields_of(Describes<Camera>) {
    return fields<Camera>(
        field("name", &Camera::name), field("path", &Camera::path),
        field("video_start", &Camera::video_start), field("video_end", &Camera::video_end),
        field("fade", &Camera::fade), field("scene_start", &Camera::scene_start),
        field("scene_end", &Camera::scene_end), field("speeds", &Camera::speeds),
        field("smooth", &Camera::smooth), field("position", &Camera::position),
        field("target", &Camera::target), field("sensor_height", &Camera::sensor_height));
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
                         field("cameras", &Names::cameras), field("surfaces", &Names::surfaces));
}

constexpr auto fields_of(Describes<ShotState>) {
    return fields<ShotState>(
        field("v", &ShotState::v), field("name", &ShotState::name), field("film", &ShotState::film),
        field("table", &ShotState::table), field("noses", &ShotState::noses),
        field("pockets", &ShotState::pockets), field("objects", &ShotState::objects),
        field("lights", &ShotState::lights), field("cameras", &ShotState::cameras),
        field("events", &ShotState::events), field("names", &ShotState::names),
        field("places", &ShotState::places));
}

constexpr auto fields_of(Describes<SceneMeshes>) {
    return fields<SceneMeshes>(field("v", &SceneMeshes::v), field("hash", &SceneMeshes::hash));
}

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

constexpr auto fields_of(Describes<FilmState>) {
    return fields<FilmState>(
        field("state", &FilmState::state), field("shot", &FilmState::shot),
        field("output", &FilmState::output), field("width", &FilmState::width),
        field("height", &FilmState::height), field("fps", &FilmState::fps),
        field("stage", &FilmState::stage), field("fraction", &FilmState::fraction),
        field("frames", &FilmState::frames), field("finished", &FilmState::finished),
        field("reused", &FilmState::reused), field("seconds", &FilmState::seconds),
        field("left", &FilmState::left), field("message", &FilmState::message),
        field("warnings", &FilmState::warnings), field("address", &FilmState::address));
}

constexpr auto fields_of(Describes<FilmFrame>) {
    return fields<FilmFrame>(field("frame", &FilmFrame::frame), field("reused", &FilmFrame::reused),
                             field("seconds", &FilmFrame::seconds),
                             field("address", &FilmFrame::address));
}

constexpr auto fields_of(Describes<Making>) {
    return fields<Making>(field("q", &Making::q), field("stage", &Making::stage),
                          field("fraction", &Making::fraction));
}

constexpr auto fields_of(Describes<Made>) {
    return fields<Made>(field("q", &Made::q), field("v", &Made::v), field("what", &Made::what),
                        field("address", &Made::address), field("file", &Made::file));
}

constexpr auto fields_of(Describes<Work>) {
    return fields<Work>(field("what", &Work::what), field("v", &Work::v),
                        field("fraction", &Work::fraction));
}

constexpr auto fields_of(Describes<Deferred>) {
    return fields<Deferred>(field("v", &Deferred::v), field("reason", &Deferred::reason),
                            field("message", &Deferred::message));
}

}  // namespace carom::studio
