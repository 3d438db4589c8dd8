// The closed sets of messages. A message that is not listed here cannot be sent.
#pragma once

#include <variant>

#include "pipeline/studio/messages.h"

namespace carom::studio {

/// What a page may send.
using PageMessage =
    std::variant<Hello, TextChange, Save, Revert, Open, SaveAs, ListFolder, Offer, Forget, Import,
                 ReadParts, AddParts, Fan, Unfan, SolveShot, Judge, Unsolve, Dragging, Recover,
                 Simulate, See, Unsee, SeeAnnotations, StartFilm, StopFilm, Make, StopMaking>;

/// The texts that the server may send.
using ServerMessage =
    std::variant<Welcome, Start, Exists, Folder, Imported, Parts, Additions, Files, TextChanged,
                 Saved, DiskChanged, Recovered, Failed, Problems, ShotState, SequenceState,
                 SoundState, SceneMeshes, Work, Deferred, FilmState, FilmFrame, Making, Made,
                 Judged, StrikeMap>;

/// The heads of its binary messages.
using BinaryHead =
    std::variant<TimelineHead, CamerasHead, PictureHead, FanHead, AnnotationsHead, SolutionsHead>;

}  // namespace carom::studio
