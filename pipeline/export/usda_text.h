// Writes the syntax of .usda files.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/vectors.h"

namespace carom::pipeline {

/// The shortest text that reads back as the same number; 0 for -0.
[[nodiscard]] std::string usda_number(double value);
[[nodiscard]] std::string usda_number(float value);
/// A number without an exponent, because some readers do not accept exponents in time codes.
[[nodiscard]] std::string usda_time_code(double value);
[[nodiscard]] std::string usda_tuple(const Vec3& v);
[[nodiscard]] std::string usda_tuple(const Imath::V3f& v);
[[nodiscard]] std::string usda_tuple(const Quat& q);  // (w, x, y, z), rounded to float
/// The text in quotation marks, escaped.
[[nodiscard]] std::string usda_string(std::string_view text);

/// Makes names valid for USD (letters, digits and _, no digit first) and unique.
class UsdaNames {
  public:
    [[nodiscard]] std::string unique(std::string_view wanted);

  private:
    std::set<std::string, std::less<>> taken_;
};

/// Builds lines of text, indented by the number of open blocks.
class UsdaText {
  public:
    using Metadata = std::vector<std::string>;  // "key = value" each

    void line(std::string_view text);
    /// Adds the line, then its metadata in parentheses, one entry per line. USD allows several
    /// entries per line, but three.js reads them line by line.
    void line(std::string_view text, const Metadata& metadata);
    /// Opens a prim: def Mesh "cue" ( metadata ) {. The metadata may be empty.
    void open(std::string_view head, const Metadata& metadata = {});
    void close();
    [[nodiscard]] std::string finish() { return std::move(text_); }

  private:
    std::string text_ = "#usda 1.0\n";
    std::size_t depth_ = 0;
};

}  // namespace carom::pipeline
