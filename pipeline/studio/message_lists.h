// The closed sets of messages. A message that is not listed here cannot be sent.
#pragma once

#include <variant>

#include "pipeline/studio/messages.h"

namespace carom::studio {

/// What a page may send.
using PageMessage = std::variant<Hello, TextChange, Save, Revert, Open, Dragging, Recover, Simulate,
                                 See, Unsee, StartFilm, StopFilm, Make>;

/// The texts that the server may send.
using ServerMessage =
    std::variant<Welcome, Start, Files, TextChanged, Saved, DiskChanged, Recovered, Failed,
                 Problems, ShotState, SceneMeshes, Work, Deferred, FilmState, FilmFrame, Made>;

/// The heads of its binary messages.
using BinaryHead = std::variant<TimelineHead, CamerasHead, PictureHead>;

}  // namespace carom::studio
