// What the server says of a film of several shots. messages.h says how the messages are sent.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/studio/message_values.h"
#include "pipeline/studio/shot_messages.h"

namespace carom::studio {

/// A part of a film of several shots.
struct FilmPart {
    KeyPath path{};              // ["film", "shots", "0"]
    std::string kind{};          // "shot" or "title"
    std::string file{};          // of a shot: the path of its text; empty: it is a bake
    std::string name{};          // of a shot: the name of its file; else the text of the card
    std::int64_t start = 0;      // the frame of the film with which it begins
    std::int64_t frames = 0;     // at least one
    std::int64_t fade = 0;       // frames that it has in common with the part before; of the first
                                 // part: over which it appears out of black
    std::int64_t first = 0;      // of a shot: the frame of its own film with which it begins
    std::int64_t of_frames = 0;  // of a shot: the frames of its own film
};

/// What the page draws and edits of a film of several shots, of one version. It takes the place of
/// ShotState. Of a version with errors there is none.
struct SequenceState {
    static constexpr const char* kName = "sequence";
    std::int64_t v = 0;
    std::string name{};
    Film film{};  // without samples: each shot has its own
    std::vector<FilmPart> parts{};
    std::vector<ValuePlace> places{};
};

}  // namespace carom::studio
