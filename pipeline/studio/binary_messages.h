// The heads of the binary messages of the server. messages.h says how they are sent.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/studio/message_values.h"

namespace carom::studio {

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
    double impulse = 0;  // N s, of an impact or a strike
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

/// The path of an object in one of several runs.
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

/// A text in the scene. Lengths are in heights of the picture unless told otherwise.
struct AnnotationLabel {
    std::string text{};
    std::string font{};  // "sans_bold", "serif" ...; empty: that of a file
    double line_height = 0;
    std::array<double, 2> letters{};  // width of the longest line, height of all lines
    std::array<double, 2> margin{};   // around the letters: of the box, or of their dark edges
    std::array<double, 2> offset{};   // of its centre from its place, to the right and up
    bool is_above = false;            // its lower edge is there instead of its centre
    double nearer = 0;                // m by which it is nearer than its place, for what hides it
    Triple box_colour{};              // linear
    double box_opacity = 0;           // 0: no box
};

/// A line, an area or a text of an annotation. Widths are in heights of the picture.
struct AnnotationShape {
    int annotation = 0;       // its index in ShotState
    std::string kind{};       // "line", "area", "text"
    std::int64_t first = 0;   // index of the first of its numbers in the payload
    std::int64_t points = 0;  // of a line with one: a dot
    Triple colour{};          // linear
    double opacity = 1;
    double width = 0;  // of a line, without its dark edge
    bool is_closed = false;
    bool has_round_ends = true;
    bool has_head = false;  // an arrowhead at its last point
    std::optional<AnnotationLabel> label{};
};

/// Binary, type 5. Payload: 64-bit floats, kNumbersPerPoint for each point: position; opacity. A
/// shape is drawn over those before it. Dashes are lines of their own. What is a thing of the scene
/// (`lit`) has only its texts here.
struct AnnotationsHead {
    static constexpr const char* kName = "annotations";
    static constexpr std::uint32_t kType = 5;
    static constexpr int kNumbersPerPoint = 4;
    std::int64_t q = 0;
    std::int64_t v = 0;  // of the texts that they belong to
    std::vector<AnnotationShape> shapes{};
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

}  // namespace carom::studio
