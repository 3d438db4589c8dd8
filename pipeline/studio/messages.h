// The messages between carom's studio and its page, as plain data.
//
// Texts are JSON objects whose member "t" is the message's kName and whose other members are the
// fields of the struct. A binary message is a 32-bit type, the 32-bit length of its head, the head
// (JSON like the texts, padded with spaces to a multiple of 8 bytes, which its length counts), and
// a payload of little-endian numbers that the head describes. Lengths are in metres, times in
// seconds, angles in radians; world axes have Z up. Numbers that count versions start at 1.
//
// The page's types are generated from message_fields.h: `studio/src/protocol.ts`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carom::studio {

inline constexpr const char* kProtocol = "carom-studio/1";

using Triple = std::array<double, 3>;
using Turn = std::array<double, 4>;  // unit quaternion, w first

/// Keys from the top of the shot to a value; elements of lists by their index:
/// ["cameras", "0", "position", "bezier", "1"].
using KeyPath = std::vector<std::string>;

/// A range in a file. Lines and columns count from 1, columns and lengths in characters (code
/// points); line 0: no place.
struct TextRange {
    std::string file;  // a path of Files, or the name of an option such as "--set"
    int line = 0;
    int column = 0;
    int length = 0;
};

// ---- from the page ------------------------------------------------------------------------------

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

/// Starts to make a film of the shot's files as they are on disk: the page saves first. The answers
/// are FilmStates and FilmFrames. Frames that are in the cache are used again, so that the same
/// request goes on where a film was stopped. If a file of the output's name exists, the answer is
/// Exists, unless `overwrite`, or if carom made the file and the film was stopped before.
struct StartFilm {
    static constexpr const char* kName = "film";
    std::string output{};                    // path or name; empty: beside the shot, named after it
    std::string quality{};                   // a preset, or empty
    std::string frames{};                    // ranges such as "0-47x2,60", or empty
    std::optional<std::vector<int>> size{};  // width and height, pixels; empty: the shot's
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

/// Stops what the question asked for.
struct StopMaking {
    static constexpr const char* kName = "stop_making";
    std::int64_t q = 0;
};

// ---- from the server ----------------------------------------------------------------------------

/// The answer to Hello.
struct Welcome {
    static constexpr const char* kName = "welcome";
    std::string protocol{};
    std::string version{};  // of carom
    std::int64_t v = 0;     // the version of the texts
    std::string shot{};     // the path of the shot's file; empty: the start page
    std::string root{};     // the folder below which files may be written
};

/// A file to start from.
struct StartFile {
    std::string file{};
    std::string name{};   // "nine_ball_break"
    std::string about{};  // its first comment
    std::string still{};  // the address of a picture, or empty
};

/// What the start page offers. Sent after Hello if no shot is open, and whenever it changes.
struct Start {
    static constexpr const char* kName = "start";
    std::vector<StartFile> templates{};
    std::vector<StartFile> examples{};
    std::vector<StartFile> recent{};
};

/// A file was not written because it exists. The page may ask for the same with `overwrite`.
struct Exists {
    static constexpr const char* kName = "exists";
    std::string what{};  // the kName of the request
    std::string file{};
    std::string name{};  // relative to the root
};

struct FolderEntry {
    std::string name{};
    std::string file{};      // absolute path
    bool is_folder = false;  // else a shot
};

/// The folders and the YAML files of a folder, sorted by their names.
struct Folder {
    static constexpr const char* kName = "folder";
    std::string folder{};  // absolute path
    std::string name{};    // relative to the root; empty: the root
    std::string parent{};  // absolute path; empty: this is the root
    std::vector<FolderEntry> entries{};
};

/// The answer to Import.
struct Imported {
    static constexpr const char* kName = "imported";
    std::string name{};
    std::string yaml{};                   // empty: it has errors
    std::vector<std::string> problems{};  // sentences with their places
    std::vector<std::string> notes{};     // what was assumed
};

/// A part that can be added.
struct Part {
    std::string section{};
    std::string name{};
    std::string about{};  // "sphere, felt"
    bool exists = false;  // the open shot has a part of that section and name
};

/// The answer to ReadParts.
struct Parts {
    static constexpr const char* kName = "parts";
    std::string file{};
    std::vector<Part> parts{};
};

/// What to add to the text of the open shot.
struct Addition {
    std::string section{};
    std::string name{};  // that the open shot does not have yet
    std::string yaml{};  // on one line; the value of the entry, or an item of the list
    std::string of{};    // the name of the part from which it was made
};

/// The answer to AddParts: the parts, the materials that they need, and everything renamed where
/// the open shot has that name.
struct Additions {
    static constexpr const char* kName = "additions";
    std::vector<Addition> list{};
};

struct OpenFile {
    std::string file{};     // absolute path
    std::string name{};     // as the shot names it, for a tab: "nine_ball_break.yaml"
    std::string text{};     // as it stands now: the page's text if it has one, else the disk's
    std::string hash{};     // of the file on disk
    bool writable = false;  // a file of carom's configs or outside of the root is not
    bool changed = false;   // `text` differs from the file on disk
};

/// The shot's file, first, and all files that it includes. Sent after Hello, and when the list
/// changes.
struct Files {
    static constexpr const char* kName = "files";
    std::int64_t v = 0;
    std::vector<OpenFile> files{};
};

/// Another page changed a text.
struct TextChanged {
    static constexpr const char* kName = "text_changed";
    std::int64_t v = 0;
    std::string file{};
    std::string text{};
};

struct Saved {
    static constexpr const char* kName = "saved";
    std::string file{};
    std::string hash{};
};

/// A file on disk is no longer what it was when it was last read or saved. Also the answer to a
/// Save that is refused for this reason.
struct DiskChanged {
    static constexpr const char* kName = "disk_changed";
    std::string file{};
    std::string text{};  // the new one on disk
    std::string hash{};
    bool refused = false;  // a Save
};

/// A text that was not saved before the studio ended unexpectedly.
struct RecoveredText {
    std::string file{};
    std::string text{};
    std::string base_hash{};  // of the file on disk from which it was made
    std::string hash{};       // of the file on disk now; empty: it does not exist
};

/// Texts of the shot's files that were not saved when the studio ended unexpectedly. Sent after
/// Files; nothing changes until the page answers with Recover.
struct Recovered {
    static constexpr const char* kName = "recovered";
    std::vector<RecoveredText> files{};
};

/// Something that was asked for failed; a sentence for the user.
struct Failed {
    static constexpr const char* kName = "failed";
    std::string what{};  // the kName of the request, or "bake", "picture"
    std::int64_t v = 0;
    std::string message{};
};

struct Problem {
    std::string severity{};  // "error" or "warning"
    TextRange place{};
    std::string key_path{};
    std::string message{};
    std::string suggestion{};  // what was probably meant in the place's stead, or empty
    std::vector<TextRange> included_by{};
};

/// All problems of a version, sorted as `carom check` sorts them. Those of the motion follow after
/// the bake (`complete`).
struct Problems {
    static constexpr const char* kName = "problems";
    std::int64_t v = 0;
    bool complete = false;
    std::vector<Problem> list{};
};

/// Where a value comes from. The plain values in a list have no place of their own: they come from
/// where the list does.
struct ValuePlace {
    KeyPath path{};
    TextRange key{};       // of its key; line 0 in lists
    TextRange value{};     // of the value; of a map or list its first character
    std::string origin{};  // "shot", "include" (a writable file), "config" (a file of carom's),
                           // "set" (an option)
};

/// A ball or an object of the scene.
struct SceneObject {
    std::string name{};
    std::string kind{};   // "ball", "object", "table"
    KeyPath path{};       // where it is, or would be, in the shot: ["balls", "nine"]
    std::string shape{};  // "sphere", "box" ...
    bool moves = false;   // has a track in the timeline; else it rests at this pose
    Triple position{};    // at the start, of the origin of its axes
    Turn orientation{1, 0, 0, 0};
    double radius = 0;            // of a ball
    std::optional<int> number{};  // on a ball
    Triple colour{};              // linear, of its material, for outlines and trails
    std::string material{};
};

struct SceneLight {
    std::string name{};
    std::string kind{};  // "point", "spot", "directional", "rectangle", "sphere", "environment"
    KeyPath path{};
    Triple position{};
    Triple facing{};
    Turn orientation{1, 0, 0, 0};  // of a rectangle: its edges along x and y, it shines along z
    Triple colour{};               // linear, its largest component 1
    std::vector<double>
        size;  // rectangle: width, height; sphere: radius; spot: inner and outer half angle
};

/// One point of a path, as a handle to drag.
struct PathPoint {
    KeyPath path{};     // of the point in the shot, or of the offset that moves it
    Triple position{};  // in the world
    std::string of{};   // an object to which the point is relative, or empty
    double at = 0;      // the scene time of that object
    Triple offset{};    // what is written: at `path`, or at its `offset` if the path is that of a
                        // point relative to an object
};

/// The ellipse of an orbit around its one point.
struct Orbit {
    std::array<double, 2> radii{};   // along x and y
    std::array<double, 2> angles{};  // at its start and end, from x towards y
    Turn turn{1, 0, 0, 0};           // of its plane
};

struct PathShape {
    std::string kind{};  // "bezier" (also a fixed point), "spline", "along", "follow", "orbit"
    std::optional<Orbit> orbit{};
    std::vector<PathPoint> points{};
    std::vector<double> curve{};  // x, y, z of points along it, for a polyline
};

struct SpeedPoint {
    KeyPath path{};
    double video_time = 0;
    double speed = 1;
};

struct Camera {
    std::string name{};
    KeyPath path{};
    double video_start = 0;
    double video_end = 0;
    double fade = 0;
    double scene_start = 0;
    double scene_end = 0;
    std::vector<SpeedPoint> speeds{};  // empty: a linear map from scene_start to scene_end
    bool smooth = false;
    PathShape position{};
    PathShape target{};
    double sensor_height = 0.024;
};

/// An event as the shot describes it.
struct ShotEvent {
    KeyPath path{};
    std::string kind{};  // "strike", "force", "torque", "impulse", "velocity"
    std::string object{};
    double time =
        0;  // scene time of its entry; of its start if a trigger starts it (then from the bake)
    bool triggered = false;
    std::optional<double> duration{};
    Triple vector{};          // force ...; of a strike the horizontal aim, a unit vector
    double speed = 0;         // of a strike, m/s
    bool ball_speed = false;  // `speed` is the ball's instead of the stick's
    double elevation = 0;
    std::array<double, 2> tip{};  // offset to the right and up, in radii
    double direction = 0;         // of a strike, counter-clockwise from +x
    std::string toward{};         // of a strike: an object, or empty
};

/// The straight part of a cushion, on the line that the foremost point of a ball touches. The
/// playing field is on the left of from -> to.
struct CushionNose {
    std::array<double, 2> from{};
    std::array<double, 2> to{};
};

struct TablePocket {
    std::string name{};  // "corner_left_front" ...
    std::array<double, 2> place{};
    double radius = 0;  // of the hole
};

/// A table, for drawing aids: the ghost ball, the first rebound.
struct Table {
    double length = 0;  // between the noses
    double width = 0;
    double cushion_height = 0;
    double ball_radius = 0;
};

struct Film {
    int width = 0;
    int height = 0;
    double fps = 24;
    std::int64_t frames = 0;
    double duration = 0;
    int samples = 0;
};

/// Names to choose from.
struct Names {
    std::vector<std::string> balls{}, objects{}, materials{}, lights{}, cameras{}, surfaces{};
};

/// What the page draws and edits, of one version. Of a version with errors there is none.
struct ShotState {
    static constexpr const char* kName = "shot";
    std::int64_t v = 0;
    std::string name{};
    Film film{};
    std::optional<Table> table{};
    std::vector<CushionNose> noses{};    // of the table's cushions
    std::vector<TablePocket> pockets{};  // of the table
    std::vector<SceneObject> objects{};
    std::vector<SceneLight> lights{};
    std::vector<Camera> cameras{};
    std::vector<ShotEvent> events{};
    Names names{};
    std::vector<ValuePlace> places{};
};

/// The meshes of a version: GET /scene/HASH.glb. Sent when the hash changes. Nodes are named as in
/// ShotState; their transformations are those of the start and replaced by the page.
struct SceneMeshes {
    static constexpr const char* kName = "scene";
    std::int64_t v = 0;
    std::string hash{};
};

struct TrackHead {
    std::string name{};
    std::int64_t first = 0;  // index of the first of its numbers in the payload
    std::int64_t keys = 0;
};

struct TimelineEvent {
    std::string kind{};  // "impact", "rolling", "potted" ... (sim/timeline/event.h)
    double time = 0;
    double end_time = 0;
    std::string a{};
    std::string b{};
    Triple place{};
    double impulse = 0;  // N s, of an impact
    std::string text{};  // a phrase for people: "cue hits one"
};

/// Binary, type 1. Payload: 64-bit floats, kNumbersPerKey for each key: time; position; orientation
/// (w, x, y, z); velocity in; velocity out; angular velocity in; angular velocity out. The curve
/// between keys: docs/timeline.md.
struct TimelineHead {
    static constexpr const char* kName = "timeline";
    static constexpr std::uint32_t kType = 1;
    static constexpr int kNumbersPerKey = 20;
    std::int64_t v = 0;
    bool kept = false;  // the same motion as that of the version before (no bake was needed)
    double start = 0;
    double end = 0;
    std::vector<TrackHead> tracks{};
    std::vector<TimelineEvent> events{};
    std::vector<double>
        energy{};             // time, kinetic, potential of each sample; thinned to at most 500
    double milliseconds = 0;  // CPU time from the text to this message
};

/// Binary, type 2. Payload: 64-bit floats, kNumbersPerFrame for each entry: frame; camera (index in
/// ShotState); weight; video time; scene time; shutter opens; shutter closes (scene times); speed;
/// position; target; up; roll; vertical field of view; distance of focus; lens radius. Poses are
/// those in the middle of the shutter. A frame of a cross-fade has two entries. Frames without a
/// valid view have none, and of a film of more than 20,000 frames only every second, third ...
/// frame has one.
struct CamerasHead {
    static constexpr const char* kName = "cameras";
    static constexpr std::uint32_t kType = 2;
    static constexpr int kNumbersPerFrame = 21;
    std::int64_t v = 0;
    std::int64_t entries = 0;
};

/// The path of an object in one run of a fan.
struct FanTrack {
    std::string name{};
    int run = 0;             // from 0
    std::int64_t first = 0;  // index of the first of its numbers in the payload
    std::int64_t points = 0;
};

/// What happened in some of the runs.
struct FanOutcome {
    std::string kind{};  // as in TimelineEvent
    std::string a{};
    std::string b{};
    std::string text{};  // "nine is potted"
    int runs = 0;        // in how many of those that are finished
    double first = 0;    // earliest and latest time
    double last = 0;
};

/// Binary, type 4. Payload: 64-bit floats, kNumbersPerPoint for each point: time; position. The
/// paths are those of what moves, with as few points as show them to a millimetre.
struct FanHead {
    static constexpr const char* kName = "fan";
    static constexpr std::uint32_t kType = 4;
    static constexpr int kNumbersPerPoint = 4;
    std::int64_t v = 0;
    int runs = 0;
    int finished = 0;  // of them
    std::vector<FanTrack> tracks{};
    std::vector<FanOutcome> outcomes{};  // sorted by their earliest time
};

/// The motion of this version is not simulated yet.
struct Deferred {
    static constexpr const char* kName = "deferred";
    std::int64_t v = 0;
    std::string reason{};   // "dragging": it follows when the drag ends, because simulating this
                            // shot takes long; "limit": only after Simulate
    std::string message{};  // a sentence for the user
};

/// Binary, type 3. Payload: RGBA, 8 bits each, row by row from the top left. Each question gets
/// pictures of growing size and then of growing number of samples, until one is `complete`.
struct PictureHead {
    static constexpr const char* kName = "picture";
    static constexpr std::uint32_t kType = 3;
    std::int64_t q = 0;
    std::int64_t v = 0;  // of the texts that it shows
    int width = 0;
    int height = 0;
    int samples = 0;        // per pixel, that it consists of; the mean if it is complete
    int of_samples = 0;     // that the last one will have
    bool complete = false;  // nothing more will come
    bool stored = false;    // the film's own frame, which is in the cache: `carom render` uses it
    std::string channel;    // of the question
    std::string legend;     // what the shades of a channel mean, a sentence; empty for colours
};

/// A film that is being made, or the last one. Sent when it starts, with each frame, and at its
/// end.
struct FilmState {
    static constexpr const char* kName = "film_state";
    std::string state{};   // "running", "stopping", "done", "stopped", "failed"
    std::string shot{};    // the file of its shot
    std::string output{};  // its path
    int width = 0;
    int height = 0;
    double fps = 0;
    std::string stage{};                  // "bake", "render", "encode"; empty before the first one
    double fraction = 0;                  // of the stage
    std::int64_t frames = 0;              // of the film
    std::int64_t finished = 0;            // of them
    std::int64_t reused = 0;              // of those, from the cache
    double seconds = 0;                   // since it started
    double left = -1;                     // estimate, s; negative: not known
    std::string message{};                // why it failed
    std::vector<std::string> warnings{};  // sentences
    std::string address{};  // GET it here once it is done; empty for an image sequence
};

/// A frame of the film that is being made, or of the last one, is finished. In no particular order.
struct FilmFrame {
    static constexpr const char* kName = "film_frame";
    std::int64_t frame = 0;
    bool reused = false;  // from the cache
    double seconds = 0;
    std::string address{};  // GET a small picture of it here, or empty
};

/// How far the answer to Make is.
struct Making {
    static constexpr const char* kName = "making";
    std::int64_t q = 0;
    std::string stage{};  // "bake", "render"
    double fraction = 0;  // of the stage
};

/// The answer to Make.
struct Made {
    static constexpr const char* kName = "made";
    std::int64_t q = 0;
    std::int64_t v = 0;  // of the texts that it shows; 0: of the files on disk
    std::string what{};
    std::string address{};  // GET it here
    std::string file{};     // that was written, or empty
};

/// What the server works on, for the status line.
struct Work {
    static constexpr const char* kName = "work";
    std::string what{};  // "bake", or empty: nothing
    std::int64_t v = 0;
    double fraction = 0;  // [0, 1]
};

}  // namespace carom::studio
