// Text of a .usda file.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "sim/timeline/vocabulary.h"

namespace carom::pipeline {

/// The shortest text that reads back as the same number; 0 for -0.
[[nodiscard]] std::string usda_number(double value);
[[nodiscard]] std::string usda_number(float value);
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
    void line(std::string_view text);
    /// "def Mesh "cue" (metadata) {"; metadata may be empty.
    void open(std::string_view head, std::string_view metadata = {});
    void close();
    [[nodiscard]] std::string finish() { return std::move(text_); }

  private:
    std::string text_ = "#usda 1.0\n";
    std::size_t depth_ = 0;
};

}  // namespace carom::pipeline
