#include "pipeline/config/shot_source.h"

#include "pipeline/config/find_place.h"

namespace carom::pipeline {

Problem ShotSource::problem_at(const std::vector<std::string>& path, Severity severity,
                               std::string message) const {
    config::FoundPlace found = config::find_place(*root_, path);
    return {
        severity,           sources_->describe(found.place), std::move(found.key_path),
        std::move(message), sources_->line_of(found.place),  sources_->include_chain(found.place)};
}

Problem ShotSource::problem_of(const Diagnostic& diagnostic) const {
    const std::vector<std::string> path = config::path_of(diagnostic, *root_);
    if (path.empty()) {
        return {diagnostic.severity, {}, {}, diagnostic.sentence, {}, {}};
    }
    return problem_at(path, diagnostic.severity, diagnostic.sentence);
}

}  // namespace carom::pipeline
