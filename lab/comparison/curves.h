// Quantities of several structures over a common axis, as tables and panels of charts.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/comparison/line_chart.h"

namespace carom::pipeline {

struct Curves {
    std::vector<std::string> names;  // of the curves
    std::vector<double> across;      // the places at which they have values, ascending
};

/// The value of a curve at a place of `across`, both by index; empty if it is unknown.
using CurveValue = std::function<std::optional<double>(std::size_t curve, std::size_t place)>;

/// A row for each place, a column for each curve with a value; empty if no curve has one.
[[nodiscard]] std::string table_of(const Curves& curves, const std::string& title,
                                   const CurveValue& value);

/// Values and places that are not above 0 are left out.
[[nodiscard]] LinePanel panel_of(const Curves& curves, const std::string& title,
                                 bool is_logarithmic, const CurveValue& value);

}  // namespace carom::pipeline
