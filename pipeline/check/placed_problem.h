// Problems of a shot, with their place if its source is at hand.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/shot_source.h"

namespace carom::pipeline {

/// A problem at the value of that path (ShotSource::problem_at); without a place if `source` is
/// null.
[[nodiscard]] Problem placed_problem(const ShotSource* source, const std::vector<std::string>& path,
                                     Severity severity, std::string message);

/// A problem of the simulation, at the value to which it refers; without a place if `source` is
/// null.
[[nodiscard]] Problem placed_problem(const ShotSource* source, const Diagnostic& diagnostic);

}  // namespace carom::pipeline
