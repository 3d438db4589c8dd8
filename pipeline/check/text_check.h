// Warns of annotations that do not fit on the film's picture.
#pragma once

#include <vector>

#include "pipeline/check/motion_check.h"

namespace carom::pipeline {

/// Warnings about annotations that are made smaller than asked for, because they do not fit on the
/// picture even with their lines broken, and about those that run out of it. The motion must be
/// that of the shot, with its moments known. `source`: as in motion_check.h.
[[nodiscard]] std::vector<Problem> text_problems(const Shot& shot, const ShotSource* source,
                                                 const sim::Timeline& timeline);

}  // namespace carom::pipeline
