// The annotations of a shot.
#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include <fmt/ranges.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/picture/annotation_boxes.h"
#include "pipeline/picture/shown_annotations.h"
#include "pipeline/studio/shot_state.h"

namespace carom::studio {

namespace {

/// The keys of the kinds, in the order of AnnotationKind.
constexpr std::array<std::string_view, std::variant_size_v<pipeline::AnnotationKind>> kKinds{
    "path", "aim",   "ghost", "tangent", "velocity", "spin", "angle",
    "zone", "label", "text",  "title",   "tip",      "plan", "image"};

/// What an annotation is about, and its text.
struct FillAnnotation {
    ShotAnnotation& message;

    void operator()(const pipeline::AngleAnnotation& angle) const {
        std::vector<std::string> names = angle.between.empty() ? angle.deflection : angle.between;
        for (const pipeline::ScenePoint& point : angle.points) {
            if (!point.object.empty()) {
                names.push_back(point.object);
            }
        }
        message.subject = fmt::format("{}", fmt::join(names, ", "));
    }
    void operator()(const pipeline::ZoneAnnotation& zone) const {
        message.subject = zone.at.object;
    }
    void operator()(const pipeline::TextAnnotation& text) const { message.text = text.text; }
    void operator()(const pipeline::TitleAnnotation& title) const { message.text = title.text; }
    void operator()(const pipeline::PlanAnnotation& /*plan*/) const {}
    void operator()(const pipeline::ImageAnnotation& /*image*/) const {}
    template <class Kind>
    void operator()(const Kind& kind) const {
        message.subject = kind.of;
        if constexpr (requires { kind.on; }) {
            message.subject += ", " + kind.on;
        }
        if constexpr (requires { kind.text; }) {
            message.text = kind.text;
        }
    }
};

/// `written`: as in the shot, `time`: on the annotation's clock. `film`: how long the film lasts,
/// s, for a moment that it does not reach.
std::optional<AnnotationEnd> end_message(const std::optional<pipeline::AnnotationTime>& written,
                                         const std::optional<double>& time, bool in_scene,
                                         double film) {
    if (!written || !time) {
        return std::nullopt;
    }
    AnnotationEnd end{*time, in_scene, {}};
    if (written->is_moment && !in_scene) {
        end.time = std::min(*time, film);
        end.moment = written->seconds;
    }
    return end;
}

AnnotationBox box_message(const pipeline::AnnotationBox& box, const Vec2& picture) {
    const Vec2 centre = (box.corner + 0.5 * box.size) / picture;
    const Vec2 size = box.size / picture;
    return {{centre.x, centre.y}, {size.x, size.y}};
}

}  // namespace

std::vector<ShotAnnotation> annotation_messages(const pipeline::Shot& shot,
                                                const sim::Timeline& timeline) {
    const auto boxes = annotation_boxes(shot, timeline);
    const Vec2 picture(shot.render.width, shot.render.height);
    const double film = static_cast<double>(pipeline::frame_count(shot.cameras, shot.timing)) /
                        shot.timing.fps.to_double();
    std::vector<ShotAnnotation> messages;
    for (const pipeline::Annotation& annotation : shot.annotations) {
        const bool in_scene = is_in_scene(annotation);
        ShotAnnotation& message = messages.emplace_back();
        message.path = {"annotations", std::to_string(messages.size() - 1)};
        message.kind = kKinds.at(annotation.kind.index());
        const pipeline::ShownTimes times = shown_times(annotation, shot.cameras);
        message.from = end_message(annotation.from, times.from, in_scene, film);
        message.to = end_message(annotation.to, times.to, in_scene, film);
        std::visit(FillAnnotation{message}, annotation.kind);
        if (const auto& box = boxes.at(messages.size() - 1)) {
            message.box = box_message(*box, picture);
        }
    }
    return messages;
}

}  // namespace carom::studio
