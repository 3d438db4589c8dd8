#include "pipeline/picture/picture_items.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/error.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/fonts.h"
#include "pipeline/picture/image_canvas.h"
#include "pipeline/picture/text_drawing.h"
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

Vec2 size_of(const Canvas& canvas) {
    return {static_cast<double>(canvas.width()), static_cast<double>(canvas.height())};
}

double pixels(const Annotation& look, double usual, const Canvas& canvas) {
    return look.size.value_or(usual) * canvas.height();
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

void PictureItems::draw(const Annotation& annotation, const FrameMoment& moment, Canvas& canvas) {
    std::visit(
        [&](const auto& kind) {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (std::is_same_v<Kind, TextAnnotation>) {
                draw_text(kind, annotation, moment, canvas);
            } else if constexpr (std::is_same_v<Kind, TitleAnnotation>) {
                draw_title(kind, annotation, moment, canvas);
            } else if constexpr (std::is_same_v<Kind, TipAnnotation>) {
                draw_tip(kind, annotation, canvas);
            } else if constexpr (std::is_same_v<Kind, PlanAnnotation>) {
                draw_plan(kind, annotation, moment, canvas);
            } else if constexpr (std::is_same_v<Kind, ImageAnnotation>) {
                draw_image(kind, annotation, canvas);
            }
        },
        annotation.kind);
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

void PictureItems::draw_text(const TextAnnotation& text, const Annotation& look,
                             const FrameMoment& moment, Canvas& canvas) {
    const PicturePlace place = look.place.value_or(kTopLeft);
    const DrawnText drawn(fonts_.of(look.font), filled(text.text, moment),
                          {pixels(look, kTextSize, canvas), look.colour.value_or(text_colour()),
                           look.box.value_or(TextBox{}), alignment_at(place)});
    drawn.draw(canvas.context(), corner_at(place, drawn.size(), size_of(canvas)));
}

void PictureItems::draw_title(const TitleAnnotation& title, const Annotation& look,
                              const FrameMoment& moment, Canvas& canvas) {
    const PicturePlace place = look.place.value_or(kTitlePlace);
    const double line = pixels(look, kTitleSize, canvas);
    TextLook style{line, look.colour.value_or(text_colour()),
                   look.box.value_or(TextBox{Vec3(0), 0}), alignment_at(place)};
    const Font& font = fonts_.of(look.font);
    const DrawnText above(font, filled(title.text, moment), style);
    style.line_height *= kSubtitle;
    const DrawnText below(font, filled(title.subtitle, moment), style);
    const bool has_below = !title.subtitle.empty();
    const Vec2 size(std::max(above.size().x, has_below ? below.size().x : 0),
                    above.size().y + (has_below ? below.size().y : 0));
    const Vec2 corner = corner_at(place, size, size_of(canvas));
    const double share = style.align == TextAlign::left     ? 0
                         : style.align == TextAlign::centre ? 0.5
                                                            : 1;
    above.draw(canvas.context(), corner + Vec2(share * (size.x - above.size().x), 0));
    if (has_below) {
        below.draw(canvas.context(),
                   corner + Vec2(share * (size.x - below.size().x), above.size().y));
    }
}

void PictureItems::draw_tip(const TipAnnotation& tip, const Annotation& look, Canvas& canvas) {
    const sim::Strike* strike = strike_on(shot_, tip.of);
    if (strike == nullptr) {
        return;
    }
    const double size = pixels(look, kTipSize, canvas);
    const Vec2 corner = corner_at(look.place.value_or(kBottomRight), Vec2(size), size_of(canvas));
    draw_tip_diagram(canvas.context(), *strike, look.colour, corner, size);
}

void PictureItems::draw_plan(const PlanAnnotation& plan, const Annotation& look,
                             const FrameMoment& moment, Canvas& canvas) {
    if (!plan_) {
        plan_ = std::make_unique<SmallPlan>(shot_, timeline_);
    }
    const double height = pixels(look, kPlanSize, canvas);
    const Vec2 size(height * plan_->width_per_height(), height);
    const Vec2 corner = corner_at(look.place.value_or(kTopRight), size, size_of(canvas));
    plan_->draw(canvas.context(), corner, height, moment.scene_time, plan.has_paths);
}

void PictureItems::draw_image(const ImageAnnotation& image, const Annotation& look,
                              Canvas& canvas) {
    const Canvas& picture = image_of(image.file);
    const double scale = pixels(look, kImageSize, canvas) / picture.height();
    const Vec2 size = scale * size_of(picture);
    const Vec2 corner = corner_at(look.place.value_or(kBottomRight), size, size_of(canvas));
    draw_canvas(canvas.context(), picture, corner, scale);
}

}  // namespace carom::pipeline
