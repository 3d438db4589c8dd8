// The values of a sweep, arranged for a drawing.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/study/sweep.h"

namespace carom::pipeline::study {

/// The keys along the axes of a drawing, as indices, and those of words.
struct PlotKeys {
    std::vector<std::size_t> axes;
    std::vector<std::size_t> words;
    bool averages = false;  // over samples
};

[[nodiscard]] PlotKeys plot_keys(const Sweep& sweep);

/// What was measured at one place of a drawing, of one or more samples.
struct PlotCell {
    std::vector<double> numbers;
    std::vector<std::string> names;  // as often as they occur

    [[nodiscard]] std::optional<double> mean() const;
    /// Of the mean; nothing for a single number.
    [[nodiscard]] std::optional<double> standard_error() const;
    /// The most frequent; of several the first in the alphabet. Empty: none.
    [[nodiscard]] std::string name() const;
};

/// The cells of a measure by their place; the second number is 0 with one axis.
using PlotCells = std::map<std::pair<double, double>, PlotCell>;

/// By the words of the keys that have them: "mathavan2010, worn"; in the order of the sweep.
struct PlotSeries {
    std::string name;
    std::vector<PlotCells> cells;  // of each measure
};

[[nodiscard]] std::vector<PlotSeries> plot_series(const Sweep& sweep, const SweepTable& table);

}  // namespace carom::pipeline::study
