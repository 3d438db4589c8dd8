// The fields of the messages of a page, in the order in which they are written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/page_messages.h"

namespace carom::studio {

constexpr auto fields_of(Describes<Hello>) {
    return fields<Hello>(field("protocol", &Hello::protocol));
}

constexpr auto fields_of(Describes<TextChange>) {
    return fields<TextChange>(field("v", &TextChange::v), field("file", &TextChange::file),
                              field("text", &TextChange::text), field("base", &TextChange::base));
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

constexpr auto fields_of(Describes<SeeAnnotations>) {
    return fields<SeeAnnotations>(field("q", &SeeAnnotations::q), field("v", &SeeAnnotations::v),
                                  field("view", &SeeAnnotations::view),
                                  field("frame", &SeeAnnotations::frame),
                                  field("video_time", &SeeAnnotations::video_time),
                                  field("playback_speed", &SeeAnnotations::playback_speed));
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

}  // namespace carom::studio
