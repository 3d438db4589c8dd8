#include "pipeline/check/placed_problem.h"

#include <utility>

namespace carom::pipeline {

namespace {

Problem without_place(Severity severity, std::string message) {
    Problem problem;
    problem.severity = severity;
    problem.message = std::move(message);
    return problem;
}

}  // namespace

Problem placed_problem(const ShotSource* source, const std::vector<std::string>& path,
                       Severity severity, std::string message) {
    return source != nullptr ? source->problem_at(path, severity, std::move(message))
                             : without_place(severity, std::move(message));
}

Problem placed_problem(const ShotSource* source, const Diagnostic& diagnostic) {
    return source != nullptr ? source->problem_of(diagnostic)
                             : without_place(diagnostic.severity, diagnostic.sentence);
}

}  // namespace carom::pipeline
