// Checks the strikes and objects that annotations need, and their times.
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"
#include "pipeline/picture/annotation.h"
#include "pipeline/picture/value_text.h"

namespace carom::pipeline::config {

namespace {

using Path = std::vector<std::string>;

void report(Builder& builder, const Path& path, Message message) {
    FoundPlace found = find_place(builder.root, path);
    builder.reader.error_at_path(found.place, std::move(message), std::move(found.key_path));
}

void warn(Builder& builder, const Path& path, const std::string& message) {
    builder.reader.warning(find_place(builder.root, path).place, message);
}

std::vector<std::string> moving_names(const Builder& builder) {
    std::vector<std::string> names(builder.bodies.begin(), builder.bodies.end());
    names.insert(names.end(), builder.keyed.begin(), builder.keyed.end());
    names.insert(names.end(), builder.kinematic.begin(), builder.kinematic.end());
    return names;
}

/// The objects whose values a text shows.
void check_text(Builder& builder, const std::string& text, const Path& path) {
    const auto parsed = parse_value_text(text);
    const auto* pieces = std::get_if<std::vector<TextPiece>>(&parsed);
    if (pieces == nullptr) {
        return;  // it was reported
    }
    const std::vector<std::string> known = moving_names(builder);
    for (const std::string& name : objects_of(*pieces)) {
        if (std::ranges::find(known, name) == known.end()) {
            report(builder, path,
                   "there is no ball or moving object " + quote(name) + hint(name, known).text);
        }
    }
}

bool is_struck(const Builder& builder, const std::string& ball) {
    return std::ranges::any_of(builder.shot.world.events, [&](const sim::ForceEvent& event) {
        return event.object == ball && std::holds_alternative<sim::Strike>(event.action);
    });
}

/// A diagram or an aim line of a ball that exists, but is not struck.
void check_strike(Builder& builder, const std::string& ball, const Path& path,
                  const std::string& advice) {
    if (builder.balls.count(ball) != 0 && !is_struck(builder, ball)) {
        report(builder, path, "there is no strike on " + quote(ball) + advice);
    }
}

/// Warns of an annotation that appears after the end.
void check_time(Builder& builder, const Annotation& annotation, const Path& path) {
    const Shot& shot = builder.shot;
    if (!annotation.from) {
        return;
    }
    const bool in_scene = is_in_scene(annotation) || annotation.from->is_moment;
    if (!in_scene && shot.cameras.empty()) {
        return;
    }
    const double end = in_scene ? shot.world.duration : shot.cameras.back().video_end.to_double();
    if (annotation.from->seconds >= end) {
        warn(builder, path,
             "the annotation appears at " + show(annotation.from->seconds, Dimension::time) +
                 (in_scene ? " of the scene, but the simulation" : " of the film, but the film") +
                 " ends at " + show(end, Dimension::time));
    }
}

/// Why an annotation is not the same during the whole film, which a lit one has to be; empty if it
/// is.
std::string change_of(const Annotation& annotation) {
    if (annotation.from || annotation.to || annotation.fade > 0 || annotation.opacity < 1) {
        return "it is there for the whole film, without 'from', 'to', 'fade' and 'opacity'";
    }
    const auto* path = std::get_if<PathAnnotation>(&annotation.kind);
    if (path != nullptr && (path->part != PathPart::whole || path->fading > 0)) {
        return "the path needs 'part: whole', without 'fading'";
    }
    const auto* aim = std::get_if<AimAnnotation>(&annotation.kind);
    if (aim != nullptr && (aim->toward || aim->direction)) {
        return "the aim has to be that of a strike, without 'toward' and 'direction'";
    }
    const auto* zone = std::get_if<ZoneAnnotation>(&annotation.kind);
    if (zone != nullptr && !zone->at.object.empty()) {
        return "the zone needs a position instead of a ball";
    }
    const auto* angle = std::get_if<AngleAnnotation>(&annotation.kind);
    if (angle != nullptr && std::ranges::any_of(angle->points, [](const ScenePoint& point) {
            return !point.object.empty();
        })) {
        return "the angle needs positions instead of balls";
    }
    return "";
}

void check_annotation(Builder& builder, const Annotation& annotation, const std::string& index) {
    const auto path = [&](const auto&... keys) {
        return Path{"annotations", index, std::string(keys)...};
    };
    if (const std::string change = change_of(annotation); annotation.lit > 0 && !change.empty()) {
        report(builder, path("lit"), "a lit annotation has to stand still: " + change);
    }
    check_time(builder, annotation, path("from"));
    if (const auto* text = std::get_if<TextAnnotation>(&annotation.kind)) {
        check_text(builder, text->text, path("text"));
    } else if (const auto* label = std::get_if<LabelAnnotation>(&annotation.kind)) {
        check_text(builder, label->text, path("label", "text"));
    } else if (const auto* title = std::get_if<TitleAnnotation>(&annotation.kind)) {
        check_text(builder, title->text, path("title", "text"));
        check_text(builder, title->subtitle, path("title", "subtitle"));
    } else if (const auto* tip = std::get_if<TipAnnotation>(&annotation.kind)) {
        check_strike(builder, tip->of, path("tip", "of"), ", which the diagram would show");
    } else if (const auto* aim = std::get_if<AimAnnotation>(&annotation.kind)) {
        if (!aim->toward && !aim->direction) {
            check_strike(builder, aim->of, path("aim", "of"),
                         ", whose aim the line would show; give 'toward' or 'direction'");
        } else if (aim->toward && aim->toward->object == aim->of) {
            warn(builder, path("aim", "toward"),
                 "a ball cannot be aimed at itself, so nothing is drawn");
        }
    }
}

}  // namespace

void build_annotations(Builder& builder) {
    const Reader::Scope scope(builder.reader, "annotations", {});
    builder.shot.annotations = builder.file.annotations;
    for (std::size_t i = 0; i < builder.shot.annotations.size(); ++i) {
        check_annotation(builder, builder.shot.annotations[i], fmt::format("{}", i));
    }
}

}  // namespace carom::pipeline::config
