// What annotations in the scene consist of: lines, areas and texts at places of the scene, with
// widths and sizes of the picture.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "pipeline/picture/annotation.h"

namespace carom::pipeline {

struct SceneLine {
    std::vector<Vec3> points;       // m
    std::vector<double> strengths;  // opacity at each point; empty: 1
    Vec3 colour{1, 1, 1};           // linear
    double width = 0.006;           // picture heights
    Dash dash = Dash::solid;        // in metres from the first point on
    double dash_size = 1;           // of the usual one
    std::vector<Vec3> reach;        // places of a line that grows, so that its dashes do not
    bool is_closed = false;         // from the last point to the first
    bool has_head = false;          // an arrowhead at the last point
};

/// A plane area, convex or not.
struct SceneArea {
    std::vector<Vec3> corners;  // m
    Vec3 colour{1, 1, 1};       // linear
    double opacity = 1;
};

/// A dot with a size of the picture.
struct SceneDot {
    Vec3 at{0, 0, 0};      // m
    Vec3 colour{1, 1, 1};  // linear
    double width = 0.012;  // its diameter, picture heights
    double strength = 1;
};

struct SceneText {
    Vec3 at{0, 0, 0};       // m
    double nearer = 0;      // m by which it is nearer than that, as for what hides it
    Vec2 offset{0, 0};      // of the text's centre, to the right and up, picture heights
    bool is_above = false;  // its lower edge is there instead of its centre
    std::string text;
    std::string font;      // path of its file; empty: default
    double size = 0.04;    // of a line, picture heights
    Vec3 colour{1, 1, 1};  // linear
    TextBox box{Vec3(0), 0};
};

using SceneShape = std::variant<SceneArea, SceneLine, SceneDot, SceneText>;

/// They are drawn in this order, each over those before it.
using SceneShapes = std::vector<SceneShape>;

}  // namespace carom::pipeline
