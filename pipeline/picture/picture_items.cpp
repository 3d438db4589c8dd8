#include "pipeline/picture/picture_items.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/error.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/fonts.h"
#include "pipeline/picture/image_canvas.h"
#include "pipeline/picture/tip_diagram.h"

namespace carom::pipeline {
namespace {

// In picture heights.
constexpr double kTextSize = 0.05;
constexpr double kTitleSize = 0.1;
constexpr double kTipSize = 0.24;
constexpr double kPlanSize = 0.26;
constexpr double kImageSize = 0.12;

constexpr double kSubtitle = 0.5;  // of the title's size

const PicturePlace kTopLeft{{0, 0}, true};
const PicturePlace kTopRight{{1, 0}, true};
const PicturePlace kBottomRight{{1, 1}, true};
const PicturePlace kTitlePlace{{0.5, 0.22}, false};

Vec2 size_of_canvas(const Canvas& canvas) {
    return {static_cast<double>(canvas.width()), static_cast<double>(canvas.height())};
}

/// The place of one on the picture, if it says nothing.
PicturePlace usual_place(const Annotation& annotation) {
    if (std::holds_alternative<TextAnnotation>(annotation.kind)) {
        return kTopLeft;
    }
    if (std::holds_alternative<TitleAnnotation>(annotation.kind)) {
        return kTitlePlace;
    }
    return std::holds_alternative<PlanAnnotation>(annotation.kind) ? kTopRight : kBottomRight;
}

/// Whether it consists of letters, which always stay inside the picture.
bool is_text(const Annotation& annotation) {
    return std::holds_alternative<TextAnnotation>(annotation.kind) ||
           std::holds_alternative<TitleAnnotation>(annotation.kind);
}

PicturePlace place_of(const Annotation& annotation) {
    return annotation.place.value_or(usual_place(annotation));
}

/// The height of a line or of the whole, pixels.
double height_of(const Annotation& look, double usual, double picture_height) {
    return look.size.value_or(usual) * picture_height;
}

/// The strike on that ball, or nullptr.
const sim::Strike* strike_on(const Shot& shot, const std::string& ball) {
    for (const sim::ForceEvent& event : shot.world.events) {
        const auto* strike = std::get_if<sim::Strike>(&event.action);
        if (strike != nullptr && event.object == ball) {
            return strike;
        }
    }
    return nullptr;
}

}  // namespace

const Font& Fonts::of(const std::string& file) {
    std::unique_ptr<Font>& font = fonts_[file];
    if (!font) {
        font = std::make_unique<Font>(file.empty() ? default_font() : file);
    }
    return *font;
}

Vec2 PictureItems::size_of(const Annotation& look, const FrameMoment& moment, const Vec2& picture) {
    if (const auto* text = std::get_if<TextAnnotation>(&look.kind)) {
        return drawn_text(*text, look, moment, picture).text.size();
    }
    if (const auto* title = std::get_if<TitleAnnotation>(&look.kind)) {
        return drawn_title(*title, look, moment, picture).size;
    }
    return scale_of(look, moment, picture) * full_size_of(look, picture.y);
}

Vec2 PictureItems::full_size_of(const Annotation& look, double picture_height) {
    const auto height = [&](double usual) { return height_of(look, usual, picture_height); };
    if (std::holds_alternative<TipAnnotation>(look.kind)) {
        return Vec2(height(kTipSize));
    }
    if (std::holds_alternative<PlanAnnotation>(look.kind)) {
        return height(kPlanSize) * Vec2(plan().width_per_height(), 1);
    }
    const Canvas& image = image_of(std::get<ImageAnnotation>(look.kind).file);
    return height(kImageSize) / image.height() * size_of_canvas(image);
}

double PictureItems::scale_of(const Annotation& annotation, const FrameMoment& moment,
                              const Vec2& picture) {
    if (const auto* text = std::get_if<TextAnnotation>(&annotation.kind)) {
        return drawn_text(*text, annotation, moment, picture).scale;
    }
    if (const auto* title = std::get_if<TitleAnnotation>(&annotation.kind)) {
        return drawn_title(*title, annotation, moment, picture).scale;
    }
    const Vec2 share = picture / full_size_of(annotation, picture.y);
    return std::min({1.0, share.x, share.y});
}

std::optional<AnnotationBox> PictureItems::box_of(const Annotation& annotation,
                                                  const FrameMoment& moment, const Vec2& picture) {
    const auto* tip = std::get_if<TipAnnotation>(&annotation.kind);
    if (is_in_scene(annotation) || (tip != nullptr && strike_on(shot_, tip->of) == nullptr)) {
        return std::nullopt;
    }
    const Vec2 size = size_of(annotation, moment, picture);
    Vec2 corner = corner_at(place_of(annotation), size, picture);
    if (is_text(annotation)) {
        for (int axis = 0; axis < 2; ++axis) {
            corner[axis] = std::clamp(corner[axis], 0.0, std::max(0.0, picture[axis] - size[axis]));
        }
    }
    return AnnotationBox{corner, size};
}

FrameMoment moment_of(const PlannedFrame& frame) {
    return {frame.number, frame.video_time, frame.scene_time, frame.speed + 0.0};
}

void PictureItems::draw(const Annotation& annotation, const FrameMoment& moment, Canvas& canvas) {
    const std::optional<AnnotationBox> box = box_of(annotation, moment, size_of_canvas(canvas));
    if (!box) {
        return;
    }
    const auto& [corner, size] = *box;
    if (const auto* text = std::get_if<TextAnnotation>(&annotation.kind)) {
        drawn_text(*text, annotation, moment, size_of_canvas(canvas))
            .text.draw(canvas.context(), corner);
    } else if (const auto* title = std::get_if<TitleAnnotation>(&annotation.kind)) {
        draw_title(*title, annotation, moment, corner, canvas);
    } else if (const auto* tip = std::get_if<TipAnnotation>(&annotation.kind)) {
        draw_tip_diagram(canvas.context(), *strike_on(shot_, tip->of), annotation.colour, corner,
                         size.y);
    } else if (const auto* small = std::get_if<PlanAnnotation>(&annotation.kind)) {
        plan().draw(canvas.context(), corner, size.y, moment.scene_time, small->has_paths);
    } else if (const auto* image = std::get_if<ImageAnnotation>(&annotation.kind)) {
        const Canvas& picture = image_of(image->file);
        draw_canvas(canvas.context(), picture, corner, size.y / picture.height());
    }
}

const Canvas& PictureItems::image_of(const std::string& file) {
    std::unique_ptr<Canvas>& picture = images_[file];
    if (!picture) {
        picture = std::make_unique<Canvas>(image_canvas(file));
    }
    return *picture;
}

void PictureItems::prepare(const Annotation& annotation) {
    if (const auto* image = std::get_if<ImageAnnotation>(&annotation.kind)) {
        (void)image_of(image->file);
    }
}

std::string PictureItems::filled(const std::string& text, const FrameMoment& moment) const {
    const auto pieces = parse_value_text(text);
    if (const auto* problem = std::get_if<TextProblem>(&pieces)) {
        throw Error(problem->sentence);
    }
    return text_with_values(std::get<std::vector<TextPiece>>(pieces), moment, timeline_);
}

FittedText PictureItems::drawn(const std::string& text, const Annotation& look,
                               const FrameMoment& moment, double line_height, const TextBox& box,
                               const Vec2& room) {
    return fitted_text(fonts_.of(look.font), filled(text, moment),
                       {line_height, look.colour.value_or(text_colour()), look.box.value_or(box),
                        alignment_at(place_of(look))},
                       room);
}

FittedText PictureItems::drawn_text(const TextAnnotation& text, const Annotation& look,
                                    const FrameMoment& moment, const Vec2& picture) {
    return drawn(text.text, look, moment, height_of(look, kTextSize, picture.y), TextBox{},
                 room_on(picture));
}

PictureItems::DrawnTitle PictureItems::title_at(double scale, const TitleAnnotation& title,
                                                const Annotation& look, const FrameMoment& moment,
                                                const Vec2& picture) {
    const double line = scale * height_of(look, kTitleSize, picture.y);
    const TextBox none{Vec3(0), 0};
    const Vec2 room = room_on(picture);
    DrawnTitle result{drawn(title.text, look, moment, line, none, room), std::nullopt};
    result.size = result.above.text.size();
    result.scale = scale * result.above.scale;
    if (!title.subtitle.empty()) {
        result.below = drawn(title.subtitle, look, moment, kSubtitle * line, none, room);
        const Vec2 below = result.below->text.size();
        result.size = {std::max(result.size.x, below.x), result.size.y + below.y};
        result.scale = std::min(result.scale, scale * result.below->scale);
    }
    return result;
}

PictureItems::DrawnTitle PictureItems::drawn_title(const TitleAnnotation& title,
                                                   const Annotation& look,
                                                   const FrameMoment& moment, const Vec2& picture) {
    constexpr double kStep = 0.95;
    double scale = 1;
    DrawnTitle result = title_at(scale, title, look, moment, picture);
    while (result.size.y > room_on(picture).y && scale * kStep > kLeastTextScale) {
        scale *= kStep;
        result = title_at(scale, title, look, moment, picture);
    }
    return result;
}

const SmallPlan& PictureItems::plan() {
    if (!plan_) {
        plan_ = std::make_unique<SmallPlan>(shot_, timeline_);
    }
    return *plan_;
}

void PictureItems::draw_title(const TitleAnnotation& title, const Annotation& look,
                              const FrameMoment& moment, const Vec2& corner, Canvas& canvas) {
    const DrawnTitle drawn = drawn_title(title, look, moment, size_of_canvas(canvas));
    const TextAlign align = alignment_at(place_of(look));
    const double share = align == TextAlign::left ? 0 : align == TextAlign::centre ? 0.5 : 1;
    const DrawnText& above = drawn.above.text;
    above.draw(canvas.context(), corner + Vec2(share * (drawn.size.x - above.size().x), 0));
    if (drawn.below) {
        const DrawnText& below = drawn.below->text;
        below.draw(canvas.context(),
                   corner + Vec2(share * (drawn.size.x - below.size().x), above.size().y));
    }
}

}  // namespace carom::pipeline
