// The cells of comma-separated values, with their places.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/source_set.h"

namespace carom::pipeline {

struct CsvCell {
    std::string text;  // without quotation marks and the blanks around it
    config::Place place;
};

struct CsvLine {
    config::Place place;
    std::vector<CsvCell> cells;
};

/// RFC 4180 without line breaks in cells. The first line decides what separates: commas, else
/// semicolons, else tabs. Without empty lines and those that begin with #.
[[nodiscard]] std::vector<CsvLine> csv_lines(const config::SourceSet& sources, int source);

}  // namespace carom::pipeline
