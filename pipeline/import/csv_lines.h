// Reads comma-separated values, with the position of each cell.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/source_set.h"

namespace carom::pipeline {

struct CsvCell {
    std::string text;  // without quotation marks and surrounding blanks
    config::Place place;
};

struct CsvLine {
    config::Place place;
    std::vector<CsvCell> cells;
};

/// Reads RFC 4180 without line breaks in cells. The first line determines the separator: commas,
/// otherwise semicolons, otherwise tabs. Empty lines and lines that begin with # are skipped.
[[nodiscard]] std::vector<CsvLine> csv_lines(const config::SourceSet& sources, int source);

}  // namespace carom::pipeline
