#include "pipeline/check/text_check.h"

#include <cmath>
#include <string>

#include <fmt/core.h>

#include "pipeline/check/placed_problem.h"
#include "pipeline/picture/annotation_fits.h"

namespace carom::pipeline {

namespace {

std::string size_text(const Shot& shot) {
    return fmt::format("{}x{}", shot.render.width, shot.render.height);
}

std::string smaller_text(const AnnotationFit& fit, const Shot& shot) {
    return fmt::format(
        "the annotation is too large for a picture of {}, so it is drawn at {:.0f} % of its size "
        "{}",
        size_text(shot), std::floor(100 * fit.scale), fit.smaller->text(shot.timing));
}

std::string outside_text(const AnnotationFit& fit, const Shot& shot) {
    std::string sides;
    for (std::size_t edge = 0; edge < kPictureEdges.size(); ++edge) {
        if (fit.beyond.at(edge) > 0) {
            sides += fmt::format("{}{:.0f} pixels beyond the {} edge", sides.empty() ? "" : " and ",
                                 std::ceil(fit.beyond.at(edge)), kPictureEdges.at(edge));
        }
    }
    return fmt::format("the annotation runs out of the picture of {}, {}, {}", size_text(shot),
                       sides, fit.outside->text(shot.timing));
}

}  // namespace

std::vector<Problem> text_problems(const Shot& shot, const ShotSource* source,
                                   const sim::Timeline& timeline) {
    std::vector<Problem> problems;
    if (shot.annotations.empty() || shot.cameras.empty()) {
        return problems;
    }
    const std::vector<AnnotationFit> fits = annotation_fits(shot, timeline);
    for (std::size_t i = 0; i < fits.size(); ++i) {
        const auto warn = [&](const char* key, const std::string& message) {
            problems.push_back(placed_problem(source, {"annotations", fmt::format("{}", i), key},
                                              Severity::warning, message));
        };
        if (fits[i].smaller) {
            warn("size", smaller_text(fits[i], shot));
        }
        if (fits[i].outside) {
            warn("position", outside_text(fits[i], shot));
        }
    }
    return problems;
}

}  // namespace carom::pipeline
