// Rows of named values, as CSV and as JSON.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/json_text.h"
#include "pipeline/export/csv_text.h"

namespace carom::cli {

/// A line of CSV with its header, and the members of a JSON object.
class DataRow {
  public:
    DataRow& add(std::string_view name, std::string_view text);
    /// One that is not finite is null in JSON and empty in CSV.
    DataRow& add(std::string_view name, double number);
    template <std::integral Number>
    DataRow& add(std::string_view name, Number number) {
        members_.add(name, static_cast<std::int64_t>(number));
        cell(name).add(static_cast<double>(number));
        return *this;
    }
    /// No member, an empty cell.
    DataRow& add_unknown(std::string_view name);

    [[nodiscard]] const JsonMembers& members() const { return members_; }

    /// A header line, then a line for each row, with the values of `first` before its own; all rows
    /// have the same names.
    [[nodiscard]] static std::string csv(const DataRow& first, const std::vector<DataRow>& rows);
    /// "[...]", an object in each line.
    [[nodiscard]] static std::string json(const std::vector<DataRow>& rows);

  private:
    pipeline::CsvText& cell(std::string_view name);

    JsonMembers members_;
    std::string header_;
    pipeline::CsvText cells_;
};

}  // namespace carom::cli
