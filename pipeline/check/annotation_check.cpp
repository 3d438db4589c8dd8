// Warns of annotations that show less than they say.
#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "pipeline/camera/shown_frame.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/picture/contact.h"
#include "pipeline/picture/measured_way.h"

namespace carom::pipeline {

namespace {

class AnnotationChecker {
  public:
    AnnotationChecker(const Shot& shot, const ShotSource* source, const sim::Timeline& timeline)
        : shot_(shot), source_(source), timeline_(timeline) {}

    void check(const Annotation& annotation, std::size_t index) {
        index_ = fmt::format("{}", index);
        std::visit([this](const auto& kind) { check_kind(kind); }, annotation.kind);
        check_moments(annotation);
    }

    std::vector<Problem> problems;

  private:
    void warn(const char* kind, const char* key, const std::string& message) {
        problems.push_back(placed_problem(source_, {"annotations", index_, kind, key},
                                          Severity::warning, message));
    }

    void require_contact(const char* kind, const char* key, const std::string& object,
                         const std::string& other) {
        if (!first_contact(timeline_, object, other)) {
            warn(kind, key,
                 fmt::format("'{}' never touches '{}', so nothing is drawn", object, other));
        }
    }

    void check_kind(const PathAnnotation& path) {
        const auto left = std::ranges::find_if(timeline_.events, [&](const sim::Event& event) {
            return event.kind == sim::EventKind::off_table && event.a == path.of;
        });
        if (left != timeline_.events.end()) {
            warn("path", "of",
                 fmt::format("the path of '{}' leaves the table at {:.3f} s", path.of, left->time));
        }
    }
    void check_kind(const GhostAnnotation& ghost) {
        require_contact("ghost", "on", ghost.of, ghost.on);
    }
    void check_kind(const TangentAnnotation& tangent) {
        require_contact("tangent", "on", tangent.of, tangent.on);
    }
    void check_kind(const AngleAnnotation& angle) {
        const bool is_between = !angle.between.empty();
        const std::vector<std::string>& names = is_between ? angle.between : angle.deflection;
        if (names.empty()) {
            return;
        }
        require_contact("angle", is_between ? "between" : "deflection", names[0], names[1]);
        if (const auto contact = first_contact(timeline_, names[0], names[1])) {
            check_way(angle, names[0], names[1], *contact);
            if (is_between) {
                check_way(angle, names[1], names[0], *contact);
            }
        }
    }

    /// Warns if the way of an object is not measured as it was asked for.
    void check_way(const AngleAnnotation& angle, const std::string& object,
                   const std::string& other, const Contact& contact) {
        const auto way = measured_way(timeline_, object, contact, other, angle.after);
        if (!way) {
            return;
        }
        const auto since = [&](double time) {
            return fmt::format("{:.3f} s", time - contact.time);
        };
        if (!way->direction) {
            warn("angle", "after",
                 fmt::format("'{}' does not move {} after it touched '{}', so nothing is drawn",
                             object, since(way->measured), other));
        } else if (way->is_cut) {
            warn("angle", "after",
                 fmt::format("{} {} after '{}' and '{}' touched, before {}; its way is measured "
                             "just before that",
                             end_text(*way, object), since(way->end_time), object, other,
                             angle.after.is_rolling
                                 ? "it rolls"
                                 : fmt::format("the {:g} s of 'after'", angle.after.seconds)));
        } else if (way->is_flying && is_above_cloth(object, way->measured)) {
            warn("angle", "after",
                 fmt::format("'{}' is in the air {} after it touched '{}', when its way is "
                             "measured; 'after: rolling' waits until it rolls",
                             object, since(way->measured), other));
        }
    }

    static std::string end_text(const MeasuredWay& way, const std::string& object) {
        switch (way.end) {
            case WayEnd::contact:
                return fmt::format("'{}' touches '{}'", object, way.other);
            case WayEnd::potted:
                return fmt::format("'{}' falls into a pocket", object);
            case WayEnd::off_table:
                return fmt::format("'{}' leaves the table", object);
            case WayEnd::resting:
                return fmt::format("'{}' comes to rest", object);
            case WayEnd::moved:
                return fmt::format("an event moves '{}'", object);
            case WayEnd::none:
                break;
        }
        return "the simulation ends";
    }

    [[nodiscard]] bool is_above_cloth(const std::string& object, double time) const {
        const auto body = std::ranges::find(shot_.world.bodies, object, &sim::Body::name);
        const sim::Track* track = timeline_.find(object);
        if (body == shot_.world.bodies.end() || track == nullptr) {
            return false;
        }
        const auto* sphere = std::get_if<sim::Sphere>(&body->shape);
        return sphere != nullptr && track->sample(time).position.z > sphere->radius + sim::kMinRise;
    }

    /// Warns of an annotation on the picture that waits for a moment which the film does not reach.
    void check_moments(const Annotation& annotation) {
        const bool waits = annotation.from && annotation.from->is_moment;
        if (waits && !is_in_scene(annotation) && !shot_.cameras.empty() &&
            !time_reached(annotation.from->seconds, shot_.cameras)) {
            problems.push_back(placed_problem(
                source_, {"annotations", index_, "from"}, Severity::warning,
                fmt::format("no camera shows the scene at {:.3f} s or later, so the annotation "
                            "never appears",
                            annotation.from->seconds)));
        }
    }

    template <class Kind>
    void check_kind(const Kind& /*kind*/) {}

    const Shot& shot_;
    const ShotSource* source_;
    const sim::Timeline& timeline_;
    std::string index_;
};

}  // namespace

std::vector<Problem> annotation_problems(const Shot& shot, const ShotSource* source,
                                         const sim::Timeline& timeline) {
    AnnotationChecker checker(shot, source, timeline);
    for (std::size_t i = 0; i < shot.annotations.size(); ++i) {
        checker.check(shot.annotations[i], i);
    }
    return std::move(checker.problems);
}

}  // namespace carom::pipeline
