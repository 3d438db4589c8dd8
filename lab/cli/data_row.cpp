#include "lab/cli/data_row.h"

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

std::string DataRow::csv(const DataRow& first, const std::vector<DataRow>& rows) {
    const auto joined = [](const std::string& before, const std::string& after) {
        return before + (before.empty() || after.empty() ? "" : ",") + after;
    };
    std::string text;
    for (const DataRow& row : rows) {
        if (text.empty()) {
            text = joined(first.header_, row.header_) + "\n";
        }
        text += joined(pipeline::CsvText(first.cells_).finish(),
                       pipeline::CsvText(row.cells_).finish()) +
                "\n";
    }
    return text;
}

std::string DataRow::json(const std::vector<DataRow>& rows) {
    std::string text;
    for (const DataRow& row : rows) {
        text += (text.empty() ? "\n" : ",\n") + row.members_.object();
    }
    return "[" + text + "]";
}

}  // namespace carom::cli
