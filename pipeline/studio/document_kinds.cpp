#include "pipeline/studio/document_kinds.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/plan/plan_svg.h"
#include "pipeline/plan/report_plot.h"
#include "pipeline/report/report_of_shot.h"
#include "pipeline/report/report_text.h"
#include "pipeline/sound/film_levels.h"
#include "pipeline/video/picture_kind.h"

namespace carom::studio {
namespace {

constexpr double kMostRate = 1e6;  // samples per second

constexpr std::array<DocumentKind, 7> kKinds{{
    {"plan", "plan", "-o", ".svg"},
    {"plot", "report", "--plot", ".svg"},
    {"report", "report", "-o", ".txt"},
    {"contact_sheet", "contact-sheet", "-o", ".png", true},
    {"frame", "frame", "-o", ".png", true},
    {"export", "export", "-o", ".csv"},
    {"events", "export", "--events", ".csv"},
}};

}  // namespace

const DocumentKind& kind_of(const Make& request) {
    const auto* const kind = std::ranges::find(kKinds, request.what, &DocumentKind::what);
    if (kind == kKinds.end()) {
        throw Error("'" + request.what + "' cannot be made");
    }
    if (request.frame < 0 || !(request.rate >= 0 && request.rate <= kMostRate)) {
        throw Error("neither frames nor rates can be negative");
    }
    if (request.output.empty() && kind->extension == ".csv") {
        throw Error("an export needs the name of a file");
    }
    return *kind;
}

std::vector<std::string> document_words(const DocumentKind& kind, const DocumentRequest& request,
                                        const ProgramOptions& options, const std::string& file) {
    std::vector<std::string> all{std::string(kind.command),
                                 "--log",
                                 "json",
                                 "--cache",
                                 options.cache_folder,
                                 "--root",
                                 request.root,
                                 std::string(kind.option),
                                 file};
    if (kind.what == "report" && pipeline::extension_of(file) == ".json") {
        all.emplace_back("--json");
    }
    if (kind.what == "frame") {
        all.insert(all.end(), {"--frame", std::to_string(request.make.frame)});
    }
    if (kind.what == "export" && request.make.rate > 0) {
        all.insert(all.end(), {"--rate", fmt::format("{}", request.make.rate)});
    }
    if (!options.quality.empty()) {
        all.insert(all.end(), {"--quality", options.quality});
    }
    for (const std::string& value : options.overrides) {
        all.insert(all.end(), {"--set", value});
    }
    all.insert(all.end(), {"--", request.shot});
    return all;
}

std::string draw_document(const DocumentKind& kind, const pipeline::Shot& shot,
                          const sim::Timeline& timeline) {
    if (kind.what == "plan") {
        return pipeline::plan_svg(
            shot, timeline, {pipeline::PlanPage::automatic, pipeline::film_levels(shot, timeline)});
    }
    if (kind.what == "plot") {
        return pipeline::report_plot_svg(shot, timeline, pipeline::PlanPage::automatic,
                                         pipeline::film_levels(shot, timeline));
    }
    return pipeline::report_text(pipeline::report_of_shot(shot, timeline));
}

}  // namespace carom::studio
