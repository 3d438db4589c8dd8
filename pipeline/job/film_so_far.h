// The film of those frames that are rendered so far.
#pragma once

#include <functional>

#include "core/hash.h"
#include "pipeline/job/film_plan.h"

namespace carom::pipeline {

/// The plan of a film of the same length in which each frame that is not stored shows the nearest
/// stored one before it, or else the first stored one. Throws Error if none is stored.
[[nodiscard]] FilmPlan plan_so_far(const FilmPlan& plan,
                                   const std::function<bool(const Hash128&)>& is_stored);

}  // namespace carom::pipeline
