// Graphics that are drawn on the finished frames of a film, as plain data.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vectors.h"

namespace carom::pipeline {

// ---- in the scene: placed in it and hidden by what is nearer; times are scene times ----------

/// A fixed point, or the centre of a ball or object.
struct ScenePoint {
    std::string object{};  // empty: `at`
    Vec3 at{0, 0, 0};      // m
};

enum class PathPart { so_far, ahead, whole };

/// The way of a ball's centre.
struct PathAnnotation {
    std::string of{};
    PathPart part = PathPart::so_far;
    std::optional<double> length{};  // of the time that is shown, s; none: all
    double fading = 0;               // s over which the line fades away; 0: it does not
    std::optional<double> marks{};   // s between dots on the line
    std::optional<int> number{};  // at its start; 0: none; default: if the shot has several paths
    bool on_cloth = false;        // on the cloth, under the ball
};

/// A straight line along which a ball is aimed, up to the first ball or cushion in its way.
struct AimAnnotation {
    std::string of{};
    std::optional<ScenePoint> toward{};  // from where the ball is at the time of the frame
    std::optional<double> direction{};   // counter-clockwise from +x, rad; neither: the strike's
    std::optional<double> length{};      // m
};

/// The place of a ball when it first touches another one.
struct GhostAnnotation {
    std::string of{}, on{};
};

/// The line at right angles to the line of the centres when a ball first touches another one.
struct TangentAnnotation {
    std::string of{}, on{};
    double length = 0.5;  // m
};

/// How far a ball would go in some time: an arrow along its velocity.
struct VelocityAnnotation {
    std::string of{};
    double during = 0.2;  // s
    bool value = false;   // written at its end
};

/// How far a ball would turn in some time: a round arrow about the axis of its spin.
struct SpinAnnotation {
    std::string of{};
    double during = 0.05;  // s
    bool value = false;    // written at its end
};

/// When the way of a ball after a contact is measured.
struct MeasuringTime {
    double seconds = 0;       // after the contact
    bool is_rolling = false;  // as soon as the ball rolls, instead
};

/// An angle: exactly one of the first three is given.
struct AngleAnnotation {
    std::vector<ScenePoint> points{};       // on one side, the vertex, on the other side
    std::vector<std::string> between{};     // two objects: their ways after they first touch
    std::vector<std::string> deflection{};  // an object whose way changes when it first touches the
                                            // other object or surface
    MeasuringTime after{};                  // of the ways, at the latest before the next contact
    double radius = 0.15;                   // of the arc, m
    bool value = true;                      // written beside the arc
};

/// A part of the cloth: exactly one of `polygon` and `radius` is given.
struct ZoneAnnotation {
    std::vector<Vec2> polygon{};     // corners, m
    std::optional<double> radius{};  // of a circle about `at`, m
    ScenePoint at{};
};

/// Text above a ball, which follows it.
struct LabelAnnotation {
    std::string of{};
    std::string text;  // with values in braces (value_text.h)
};

// ---- on the picture; times are video times ----------------------------------------------------

struct TextAnnotation {
    std::string text;  // lines, with values in braces
};

struct TitleAnnotation {
    std::string text;  // with values in braces
    std::string subtitle{};
};

/// Where the stick hits a ball, as the shooter sees it.
struct TipAnnotation {
    std::string of{};
};

/// The table from above with the balls and their ways up to the time of the frame.
struct PlanAnnotation {
    bool has_paths = true;
};

struct ImageAnnotation {
    std::string file;
};

using AnnotationKind =
    std::variant<PathAnnotation, AimAnnotation, GhostAnnotation, TangentAnnotation,
                 VelocityAnnotation, SpinAnnotation, AngleAnnotation, ZoneAnnotation,
                 LabelAnnotation, TextAnnotation, TitleAnnotation, TipAnnotation, PlanAnnotation,
                 ImageAnnotation>;

// ---- what all of them have --------------------------------------------------------------------

enum class Dash { solid, dashed, dotted, dash_dot };

/// Where an annotation is on the picture.
struct PicturePlace {
    Vec2 at{0, 0};  // fractions of the picture's width and height, from the top left
    bool is_edge =
        true;  // the same point of the annotation is there, inside a margin; else centred
};

/// Behind a text.
struct TextBox {
    Vec3 colour{0.006, 0.008, 0.01};  // linear
    double opacity = 0.6;             // 0: no box
};

/// A time on the annotation's clock, or, if it was given as a moment, on that of the scene.
struct AnnotationTime {
    double seconds = 0;
    bool is_moment = false;
};

struct Annotation {
    AnnotationKind kind;
    std::optional<AnnotationTime> from{}, to{};  // none: always
    double fade = 0;                             // s, after `from` and before `to`
    double opacity = 1;
    std::optional<Vec3> colour{};   // linear Rec.709; none: that of its kind, paths in turn
    std::optional<double> width{};  // of lines, picture heights
    std::optional<Dash> dash{};     // none: that of its kind, paths in turn
    std::string font;               // path of its file; empty: DejaVu Sans Bold
    std::optional<double> size{};   // of a line of text, of a diagram or picture; picture heights
    std::optional<TextBox> box{};
    std::optional<PicturePlace> place{};
    /// In the scene, a thin object instead of lines on the picture (lit_annotations.h): its
    /// diameter, m; 0: it is none.
    double lit = 0;
};

/// Whether the annotation is placed in the scene, so that its times are scene times.
[[nodiscard]] inline bool is_in_scene(const Annotation& annotation) {
    const AnnotationKind& kind = annotation.kind;
    return !std::holds_alternative<TextAnnotation>(kind) &&
           !std::holds_alternative<TitleAnnotation>(kind) &&
           !std::holds_alternative<TipAnnotation>(kind) &&
           !std::holds_alternative<PlanAnnotation>(kind) &&
           !std::holds_alternative<ImageAnnotation>(kind);
}

}  // namespace carom::pipeline
