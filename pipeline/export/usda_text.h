// Text of a .usda file.
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
/// Without an exponent, which not every reader expects in the key of a time sample.
[[nodiscard]] std::string usda_time_code(double value);
[[nodiscard]] std::string usda_tuple(const Vec3& v);
[[nodiscard]] std::string usda_tuple(const Imath::V3f& v);
[[nodiscard]] std::string usda_tuple(const Quat& q);  // (w, x, y, z), rounded to float
/// In quotation marks.
[[nodiscard]] std::string usda_string(std::string_view text);

/// Names that USD allows (letters, digits and _, no digit first), each once.
class UsdaNames {
  public:
    [[nodiscard]] std::string unique(std::string_view wanted);

  private:
    std::set<std::string, std::less<>> taken_;
};

/// Lines, indented by how many blocks are open.
class UsdaText {
  public:
    using Metadata = std::vector<std::string>;  // "key = value" each

    void line(std::string_view text);
    /// The line, then its metadata in parentheses, one entry to a line: USD itself also takes
    /// entries side by side, but three.js reads them line by line.
    void line(std::string_view text, const Metadata& metadata);
    /// The beginning of a prim: def Mesh "cue" ( metadata ) {. The metadata may be empty.
    void open(std::string_view head, const Metadata& metadata = {});
    void close();
    [[nodiscard]] std::string finish() { return std::move(text_); }

  private:
    std::string text_ = "#usda 1.0\n";
    std::size_t depth_ = 0;
};

}  // namespace carom::pipeline
