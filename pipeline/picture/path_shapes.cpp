// The ways of balls.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/track_line.h"

namespace carom::pipeline {
namespace {

constexpr double kWidth = 0.0075;       // picture heights
constexpr double kMark = 2.2;           // of a dot, in widths of the line
constexpr double kNumber = 0.036;       // size of a number, picture heights
constexpr double kBeside = 0.045;       // of a number from the line, picture heights
constexpr double kLeast = 0.0002;       // m between points
constexpr double kAboveCloth = 0.0005;  // m

struct Span {
    double from = 0, to = 0;  // s
};

/// The time at which the object is potted, or the end.
double end_of(const std::string& object, const sim::Timeline& timeline) {
    for (const sim::Event& event : timeline.events) {
        if (event.kind == sim::EventKind::potted && event.a == object) {
            return event.time;
        }
    }
    return timeline.end_time;
}

Span span_of(const PathAnnotation& path, const SceneMoment& moment) {
    const double start = moment.timeline.start_time;
    const double end = end_of(path.of, moment.timeline);
    const double now = std::clamp(moment.time, start, end);
    Span span{path.part == PathPart::ahead ? now : start,
              path.part == PathPart::so_far ? now : end};
    if (path.length) {
        span.from =
            path.part == PathPart::so_far ? std::max(span.from, now - *path.length) : span.from;
        span.to =
            path.part == PathPart::so_far ? span.to : std::min(span.to, span.from + *path.length);
    }
    return span;
}

Dash dash_of(std::size_t index) {
    constexpr std::array<Dash, 4> kDashes{Dash::solid, Dash::dashed, Dash::dotted, Dash::dash_dot};
    return kDashes[index % kDashes.size()];
}

class PathBuilder {
  public:
    PathBuilder(const PathAnnotation& path, const Annotation& look, const SceneMoment& moment)
        : path_(path), moment_(moment) {
        line_.colour = look.colour.value_or(path_colour(moment.path_index));
        line_.width = look.width.value_or(kWidth);
        line_.dash = look.dash.value_or(dash_of(moment.path_index));
    }

    SceneShapes shapes(const sim::Track& track, const Span& span, const Annotation& look) {
        for (const LinePoint& point : track_line(track, span.from, span.to)) {
            add(point);
        }
        if (line_.points.size() < 2) {
            return {};
        }
        if (path_.part == PathPart::ahead) {  // dashes begin where the way ends, and so stand still
            std::reverse(line_.points.begin(), line_.points.end());
            std::reverse(line_.strengths.begin(), line_.strengths.end());
        }
        const sim::Timeline& timeline = moment_.timeline;
        line_.reach = {shown(track.sample(timeline.start_time).position),
                       shown(track.sample(end_of(path_.of, timeline)).position)};
        SceneShapes shapes{line_};
        add_marks(track, span, shapes);
        add_number(look, shapes);
        return shapes;
    }

  private:
    [[nodiscard]] Vec3 shown(Vec3 position) const {
        if (path_.on_cloth) {
            position.z = kAboveCloth;
        }
        return position;
    }
    [[nodiscard]] double strength(double time) const {
        return path_.fading > 0
                   ? std::clamp(1 - std::abs(moment_.time - time) / path_.fading, 0.0, 1.0)
                   : 1;
    }
    void add(const LinePoint& point) {
        const Vec3 position = shown(point.position);
        if (!line_.points.empty() && (position - line_.points.back()).length() < kLeast) {
            return;
        }
        line_.points.push_back(position);
        line_.strengths.push_back(strength(point.time));
    }
    void add_marks(const sim::Track& track, const Span& span, SceneShapes& shapes) const {
        if (!path_.marks) {
            return;
        }
        Vec3 last(1e300, 0, 0);
        for (double n = std::ceil(span.from / *path_.marks); n * *path_.marks <= span.to; ++n) {
            const double time = n * *path_.marks;
            const Vec3 at = shown(track.sample(time).position);
            if ((at - last).length() > kLeast) {
                shapes.push_back(SceneDot{at, line_.colour, kMark * line_.width, strength(time)});
                last = at;
            }
        }
    }
    void add_number(const Annotation& look, SceneShapes& shapes) const {
        const int usual = moment_.path_count > 1 ? static_cast<int>(moment_.path_index) + 1 : 0;
        const int number = path_.number.value_or(usual);
        if (number == 0) {
            return;
        }
        // Beside the end that does not move.
        SceneText text = scene_text(std::to_string(number), line_.points.front(), look, kNumber);
        text.offset = kBeside * left_of_line();
        text.colour = line_.colour;
        text.box = look.box.value_or(TextBox{casing_colour(), 0.8});
        text.nearer = 0.06;  // more than a ball's diameter, so that the ball there does not hide it
        shapes.push_back(std::move(text));
    }

    /// On the picture, to the right and up: a unit vector to the left of the line's first piece.
    [[nodiscard]] Vec2 left_of_line() const {
        if (moment_.view.depth(line_.points[0]) < Pinhole::kNearest ||
            moment_.view.depth(line_.points[1]) < Pinhole::kNearest) {
            return {0, 1};
        }
        const Vec2 way = moment_.view.project(line_.points[1]).place -
                         moment_.view.project(line_.points[0]).place;
        const double length = way.length();
        return length > 0 ? Vec2(way.y, way.x) / length : Vec2(0, 1);
    }

    const PathAnnotation& path_;
    const SceneMoment& moment_;
    SceneLine line_;
};

}  // namespace

SceneShapes shapes_of(const PathAnnotation& path, const Annotation& look,
                      const SceneMoment& moment) {
    const sim::Track* track = moment.timeline.find(path.of);
    const Span span = span_of(path, moment);
    if (track == nullptr || span.from >= span.to) {
        return {};
    }
    return PathBuilder(path, look, moment).shapes(*track, span, look);
}

}  // namespace carom::pipeline
