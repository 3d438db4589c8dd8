// What was measured, as CSV and as JSON.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/json_text.h"
#include "lab/comparison/comparison.h"
#include "lab/comparison/growth.h"
#include "lab/comparison/motion.h"
#include "lab/comparison/size_curve.h"
#include "lab/triangle/measure.h"
#include "pipeline/export/csv_text.h"

namespace carom::cli {

/// Named values: a line of CSV with its header, and the members of a JSON object.
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
    /// Names and values with commas between them.
    [[nodiscard]] const std::string& header() const { return header_; }
    [[nodiscard]] std::string cells() const { return pipeline::CsvText(cells_).finish(); }

  private:
    pipeline::CsvText& cell(std::string_view name);

    JsonMembers members_;
    std::string header_;
    pipeline::CsvText cells_;
};

/// Numbers have full precision.
struct ReportData {
    DataRow first;   // also the first columns of the CSV
    DataRow others;  // further members of the JSON object
    /// Its lists, with an object in each line. The rows of a list have the same names.
    std::vector<std::pair<std::string, std::vector<DataRow>>> lists;

    /// The first list, below a header; unknown values are empty.
    [[nodiscard]] std::string csv() const;
    /// One object; unknown values are missing.
    [[nodiscard]] std::string json() const;
};

/// "structures": one in each row.
[[nodiscard]] ReportData report_data(const pipeline::Comparison& comparison);
/// "points": a structure with one value of the size, number of shapes or time of the shutter.
[[nodiscard]] ReportData report_data(const pipeline::SizeCurve& curve);
[[nodiscard]] ReportData report_data(const pipeline::Growth& growth);
[[nodiscard]] ReportData report_data(const pipeline::Motion& motion);
/// "kernels" with one variant each, its rates (the best of all rounds) and errors,
/// "planes_against_wald", "techniques_against_plain", "second_against_first_compiler", and "memory"
/// with one input each.
[[nodiscard]] ReportData report_data(const render::triangle::KernelMeasurements& measured);

}  // namespace carom::cli
