// Warns of annotations that show less than they say.
#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/picture/contact.h"

namespace carom::pipeline {

namespace {

class AnnotationChecker {
  public:
    AnnotationChecker(const ShotSource* source, const sim::Timeline& timeline)
        : source_(source), timeline_(timeline) {}

    void check(const Annotation& annotation, std::size_t index) {
        index_ = fmt::format("{}", index);
        std::visit([this](const auto& kind) { check_kind(kind); }, annotation.kind);
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
        if (!angle.between.empty()) {
            require_contact("angle", "between", angle.between[0], angle.between[1]);
        } else if (!angle.deflection.empty()) {
            require_contact("angle", "deflection", angle.deflection[0], angle.deflection[1]);
        }
    }
    template <class Kind>
    void check_kind(const Kind& /*kind*/) {}

    const ShotSource* source_;
    const sim::Timeline& timeline_;
    std::string index_;
};

}  // namespace

std::vector<Problem> annotation_problems(const Shot& shot, const ShotSource* source,
                                         const sim::Timeline& timeline) {
    AnnotationChecker checker(source, timeline);
    for (std::size_t i = 0; i < shot.annotations.size(); ++i) {
        checker.check(shot.annotations[i], i);
    }
    return std::move(checker.problems);
}

}  // namespace carom::pipeline
