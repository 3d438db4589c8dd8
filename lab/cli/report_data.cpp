#include "lab/cli/report_data.h"

#include <cmath>

namespace carom::cli {

pipeline::CsvText& DataRow::cell(std::string_view name) {
    header_ += (header_.empty() ? "" : ",") + std::string(name);
    return cells_;
}

DataRow& DataRow::add(std::string_view name, std::string_view text) {
    members_.add(name, text);
    cell(name).add(text);
    return *this;
}

DataRow& DataRow::add(std::string_view name, double number) {
    members_.add(name, number);
    std::isfinite(number) ? cell(name).add(number) : cell(name).add("");
    return *this;
}

DataRow& DataRow::add_unknown(std::string_view name) {
    cell(name).add("");
    return *this;
}

std::string ReportData::csv() const {
    std::string text;
    const std::string comma = first.header().empty() ? "" : ",";
    for (const DataRow& row : lists.front().second) {
        if (text.empty()) {
            text = first.header() + comma + row.header() + "\n";
        }
        text += first.cells() + comma + row.cells() + "\n";
    }
    return text;
}

std::string ReportData::json() const {
    std::string text = "{" + JsonMembers(first.members()).add(others.members()).text();
    for (const auto& [name, rows] : lists) {
        text += ",\n" + json_string(name) + ":[";
        for (const DataRow& row : rows) {
            text += (&row == &rows.front() ? "\n" : ",\n") + row.members().object();
        }
        text += "]";
    }
    return text + "}\n";
}

}  // namespace carom::cli
