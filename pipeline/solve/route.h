// How an outcome came about, in words.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/solve/wants.h"

namespace carom::pipeline::solve {

/// The impacts that led to what was wanted, and the pots, in order: "cue - one", "one - back
/// cushion", "one in corner_left_back". Two solutions with the same words are the same shot with
/// other settings.
struct Route {
    std::vector<std::string> steps;

    /// The steps, separated by commas; "no contact" if there are none.
    [[nodiscard]] std::string text() const;
};

/// By what solutions are sorted, the smallest first: a simple shot is taken before one that is
/// hardly more likely. `route`: Route::text().
[[nodiscard]] std::pair<double, double> rank_of(double miss, std::string_view route, double chance);

[[nodiscard]] Route route_of(const std::vector<Want>& wants, const Trial& trial);

}  // namespace carom::pipeline::solve
