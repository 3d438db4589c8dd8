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

struct CsvTable {
    char separator = 0;  // 0: the table is empty
    std::vector<CsvLine> lines;
};

/// Reads RFC 4180 without line breaks in cells. The separator is a comma, a semicolon or a tab,
/// whichever divides the first line into most cells, or as Excel's first line "sep=;" says. Empty
/// lines and lines that begin with # are skipped. Lines end with LF, CR LF or CR.
[[nodiscard]] CsvTable csv_table(const config::SourceSet& sources, int source);

}  // namespace carom::pipeline
