// The fields of what the server says of a film of several shots, in the order in which they are
// written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/message_value_fields.h"
#include "pipeline/studio/sequence_messages.h"
#include "pipeline/studio/shot_message_fields.h"

namespace carom::studio {

constexpr auto fields_of(Describes<FilmPart>) {
    return fields<FilmPart>(field("path", &FilmPart::path), field("kind", &FilmPart::kind),
                            field("file", &FilmPart::file), field("name", &FilmPart::name),
                            field("start", &FilmPart::start), field("frames", &FilmPart::frames),
                            field("fade", &FilmPart::fade), field("first", &FilmPart::first),
                            field("of_frames", &FilmPart::of_frames));
}

constexpr auto fields_of(Describes<SequenceState>) {
    return fields<SequenceState>(field("v", &SequenceState::v), field("name", &SequenceState::name),
                                 field("film", &SequenceState::film),
                                 field("parts", &SequenceState::parts),
                                 field("places", &SequenceState::places));
}

}  // namespace carom::studio
