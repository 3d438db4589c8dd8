#include "pipeline/studio/annotations_message.h"

#include <algorithm>
#include <span>
#include <utility>
#include <variant>

#include "pipeline/picture/fonts.h"
#include "pipeline/picture/line_dashes.h"
#include "pipeline/picture/shown_annotations.h"
#include "pipeline/studio/triple.h"
#include "pipeline/studio/view_frame.h"

namespace carom::studio {

namespace {

constexpr int kHeight = 1000;  // pixels of the picture; shapes do not depend on it

/// The name of a font's file, as shots write it; empty if it has none.
std::string font_name(const std::string& file) {
    const std::span<const pipeline::NamedFont> fonts = pipeline::named_fonts();
    const auto found =
        file.empty() ? fonts.begin() : std::ranges::find(fonts, file, &pipeline::NamedFont::file);
    return found == fonts.end() ? "" : std::string(found->name);
}

class Writer {
  public:
    Writer(const pipeline::Pinhole& view, pipeline::TextExtents& extents)
        : view_(view), extents_(extents) {}

    void add(const pipeline::ShownAnnotation& shown) {
        index_ = static_cast<int>(shown.index);
        opacity_ = shown.opacity;
        for (const pipeline::SceneShape& shape : shown.shapes) {
            std::visit([&](const auto& one) { add(one); }, shape);
        }
    }

    Numbers<AnnotationsHead> message;

  private:
    AnnotationShape& begin(const char* kind, const Vec3& colour) {
        AnnotationShape& shape = message.head.shapes.emplace_back();
        shape.annotation = index_;
        shape.kind = kind;
        shape.first = static_cast<std::int64_t>(message.numbers.size());
        shape.colour = triple(colour);
        shape.opacity = opacity_;
        return shape;
    }

    void add_point(AnnotationShape& shape, const Vec3& at, double strength = 1) {
        message.numbers.insert(message.numbers.end(), {at.x, at.y, at.z, strength});
        ++shape.points;
    }

    void add(const pipeline::SceneArea& area) {
        AnnotationShape& shape = begin("area", area.colour);
        shape.opacity *= area.opacity;
        for (const Vec3& corner : area.corners) {
            add_point(shape, corner);
        }
    }

    void add(const pipeline::SceneLine& line) {
        for (const pipeline::LineDash& dash : dashes_of(line, view_)) {
            AnnotationShape& shape = begin("line", line.colour);
            shape.width = line.width * dash.thickness;
            shape.is_closed = dash.is_closed;
            shape.has_round_ends = dash.has_round_ends;
            shape.has_head = dash.has_head;
            for (const pipeline::StrongPoint& point : dash.points) {
                add_point(shape, point.at, point.strength);
            }
        }
    }

    void add(const pipeline::SceneDot& dot) {
        AnnotationShape& shape = begin("line", dot.colour);
        shape.width = dot.width;
        add_point(shape, dot.at, dot.strength);
    }

    void add(const pipeline::SceneText& text) {
        if (text.text.empty()) {
            return;
        }
        const pipeline::TextExtent extent = extents_.of(text);
        AnnotationShape& shape = begin("text", text.colour);
        add_point(shape, text.at);
        AnnotationLabel& label = shape.label.emplace();
        label.text = text.text;
        label.font = font_name(text.font);
        label.line_height = text.size;
        label.letters = {extent.letters.x, extent.letters.y};
        label.margin = {extent.margin.x, extent.margin.y};
        label.offset = {text.offset.x, text.offset.y};
        label.is_above = text.is_above;
        label.nearer = text.nearer;
        label.box_colour = triple(text.box.colour);
        label.box_opacity = text.box.opacity;
    }

    const pipeline::Pinhole& view_;
    pipeline::TextExtents& extents_;
    int index_ = 0;
    double opacity_ = 1;
};

}  // namespace

Numbers<AnnotationsHead> annotations_message(const pipeline::Shot& shot,
                                             const sim::Timeline& timeline,
                                             const SeeAnnotations& question,
                                             pipeline::TextExtents& extents) {
    const pipeline::Pinhole view(frame_of(question.view), kHeight, kHeight);
    const double time = question.view.scene_time;
    const pipeline::FrameMoment values{question.frame, question.video_time, time,
                                       question.playback_speed};
    Writer writer(view, extents);
    writer.message.head.q = question.q;
    for (const pipeline::ShownAnnotation& shown :
         pipeline::shown_annotations(shot, timeline, view, values, time)) {
        writer.add(shown);
    }
    return std::move(writer.message);
}

}  // namespace carom::studio
