// The messages of a page. messages.h says how they are sent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/studio/message_values.h"

namespace carom::studio {

/// The first message of a page after it connected.
struct Hello {
    static constexpr const char* kName = "hello";
    std::string protocol;  // kProtocol
};

/// The whole text of one file as it stands in the page. It stands before the file on disk until it
/// is saved or dropped.
struct TextChange {
    static constexpr const char* kName = "text";
    std::int64_t v = 0;  // the version of all texts that this change makes; larger than any before
    std::string file;
    std::string text;
    std::int64_t base = 0;  // the newest version that the page has taken over in this text
};

/// Writes a file. Refused if the file on disk no longer has `base_hash`, unless `force`.
struct Save {
    static constexpr const char* kName = "save";
    std::string file;
    std::string text;
    std::string base_hash;  // of Files, Saved or DiskChanged; empty: the file must not exist
    bool force = false;
};

/// Forgets the page's text of a file: the file on disk is used again.
struct Revert {
    static constexpr const char* kName = "revert";
    std::int64_t v = 0;
    std::string file;
};

/// Opens another shot, or writes a new one and opens it. Names of files are relative to the root;
/// ".yaml" is added to one without an ending. A file that exists is answered with Exists.
struct Open {
    static constexpr const char* kName = "open";
    std::string file{};  // to open, or to write if one of the next two is given; empty: the start
                         // page
    std::string from{};  // a path of Start: a template or an example
    std::string text{};  // instead of `from`: the text of the new file
    bool overwrite = false;
};

/// Writes the shot as it stands in the page to another file, in which its includes and meshes are
/// still found, and opens that. Answered as Open is.
struct SaveAs {
    static constexpr const char* kName = "save_as";
    std::string file{};
    bool overwrite = false;
};

/// Asks for the shots in a folder below the root. Answered with Folder.
struct ListFolder {
    static constexpr const char* kName = "list";
    std::string folder{};  // empty: that of the open shot
};

/// Asks what the start page offers. Answered with Start, again when there are more pictures.
struct Offer {
    static constexpr const char* kName = "offer";
};

/// Takes a file from the list of recent ones. Answered with Start.
struct Forget {
    static constexpr const char* kName = "forget";
    std::string file{};
};

/// A text scene of the older format. Answered with Imported; nothing is written.
struct Import {
    static constexpr const char* kName = "import";
    std::string name{};  // of its file, for problems
    std::string text{};
};

/// Asks what another shot has that can be added to this one. Answered with Parts.
struct ReadParts {
    static constexpr const char* kName = "read_parts";
    std::string file{};  // below the root, or a path of Start
    std::string text{};  // instead of the file: such as the YAML of Imported
};

/// A part of a shot.
struct PartName {
    std::string section{};  // "balls", "objects", "lights", "cameras", "materials"
    std::string name{};     // its key, or the name of a camera
};

/// Asks for the YAML of parts of another shot. Answered with Additions.
struct AddParts {
    static constexpr const char* kName = "add_parts";
    std::string file{};  // as in ReadParts
    std::string text{};
    std::vector<PartName> parts{};
};

/// Asks how sure the outcome of the shot is: it is simulated several times with small
/// disturbances. The answers are FanHeads, one after each simulation. The newest question is the
/// only one; texts that change end it, so that it has to be asked again. The start of every ball
/// that a stick strikes is displaced on the cloth by `distance`, and the directions of strikes,
/// impulses, forces and of velocities at the start are turned about the vertical by up to `angle`;
/// the disturbances of each run are always the same.
struct Fan {
    static constexpr const char* kName = "fan";
    std::int64_t v = 0;  // version of the texts that the page shows
    int runs = 8;        // 1 to 16
    double distance = 1e-4;
    double angle = 1.75e-3;  // 0.1 degrees
};

/// Ends the question.
struct Unfan {
    static constexpr const char* kName = "unfan";
};

/// Whether the pointer is dragging something: pictures wait meanwhile.
struct Dragging {
    static constexpr const char* kName = "dragging";
    bool on = false;
};

/// The answer to Recovered: whether the texts are to be used. Otherwise they are forgotten.
struct Recover {
    static constexpr const char* kName = "recover";
    bool use = false;
};

/// Simulates the newest texts without the limits of a live bake. The answer to Deferred.
struct Simulate {
    static constexpr const char* kName = "simulate";
    std::int64_t v = 0;  // the version that the user saw
};

/// A camera of the page's own.
struct FreeView {
    double scene_time = 0;  // in the middle of the exposure, which is that of the film at speed 1
    Triple position{};
    Triple target{};
    Triple up{0, 0, 1};
    double fov = 0.7;        // vertical, rad
    double focus = 2;        // distance of focus along the optical axis, m
    double lens_radius = 0;  // m; 0: a pinhole, all is sharp
};

/// Asks for the path-traced picture of a frame of the film or of a view of the page's own. The
/// answers are PictureHeads. The newest question is the only one: it ends the one before.
struct See {
    static constexpr const char* kName = "see";
    std::int64_t q = 0;                 // number of the question; larger than any before
    std::int64_t v = 0;                 // version of the texts that the page shows
    std::optional<std::int64_t> frame;  // of the film ...
    std::optional<FreeView> view;       // ... or this
    int width = 0;                      // largest size of the picture, pixels; 0: the film's
    int height = 0;
    int samples = 0;      // most samples per pixel; 0: as many as the film has
    std::string channel;  // "" or "colour"; "depth", "normal", "albedo", "object_id",
                          // "material_id", "noise"
};

/// Ends the question.
struct Unsee {
    static constexpr const char* kName = "unsee";
};

/// Asks for the annotations in the scene as they are at a time, seen from a place. The answer is an
/// AnnotationsHead. The newest question is the only one.
struct SeeAnnotations {
    static constexpr const char* kName = "see_annotations";
    std::int64_t q = 0;      // number of the question; larger than any before
    std::int64_t v = 0;      // version of the motion that the page shows
    FreeView view;           // with the scene time; its focus and its lens mean nothing
    std::int64_t frame = 0;  // the number that texts show
    double video_time = 0;
    double playback_speed = 1;  // scene seconds per second of film
};

/// Starts to make a film of the shot's files as they are on disk: the page saves first. The answers
/// are FilmStates and FilmFrames. Frames that are in the cache are used again, so that the same
/// request resumes a film that was stopped. If a file of the output's name exists, the answer is
/// Exists, unless `overwrite`, or if carom made the file and the film was stopped before.
struct StartFilm {
    static constexpr const char* kName = "film";
    std::string output{};     // path or name; empty: beside the shot, named after it
    std::string quality{};    // a preset, or empty
    std::string frames{};     // ranges such as "0-47x2,60", or empty
    std::vector<int> size{};  // width and height, pixels; empty: the shot's
    bool overwrite = false;
};

/// Stops the film. Its finished frames are kept.
struct StopFilm {
    static constexpr const char* kName = "stop_film";
};

/// Makes something else than a film of the shot. Answered with Making, and with Made, Exists or
/// Failed. Without a file, drawings and the report show the shot as it was simulated last in the
/// page; what is written, and all pictures, are made of the files on disk by the command line.
struct Make {
    static constexpr const char* kName = "make";
    std::int64_t q = 0;
    std::string what{};      // "plan", "plot", "report", "contact_sheet", "frame", "export",
                             // "events"
    std::string output{};    // path or name of a file to write; its ending is the format; empty:
                             // only to look at
    std::int64_t frame = 0;  // of "frame"
    double rate = 0;         // of "export" as .csv or .json, samples per second; 0: keys
    bool overwrite = false;
};

/// Stops what the question asked for, unless it is a drawing or the report to look at.
struct StopMaking {
    static constexpr const char* kName = "stop_making";
    std::int64_t q = 0;
};

}  // namespace carom::studio
