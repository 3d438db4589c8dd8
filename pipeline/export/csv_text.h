// Rows of comma-separated values.
#pragma once

#include <string>
#include <string_view>

#include "core/vectors.h"

namespace carom::pipeline {

/// Builds CSV as RFC 4180 has it, except that a row ends with a bare line feed, as the tools that
/// read such tables on Linux write it themselves. Numbers are the shortest decimal text that reads
/// back as the same double; -0 is written as 0.
class CsvText {
  public:
    /// The first row, as it stands.
    explicit CsvText(std::string_view header);

    /// Quoted if it holds a comma, a quotation mark or a line break.
    CsvText& add(std::string_view text);
    CsvText& add(double value);
    CsvText& add(const Vec3& value);  // three columns
    CsvText& add(const Quat& value);  // four: w x y z

    void end_row();

    /// Everything so far; the object is spent.
    [[nodiscard]] std::string finish() { return std::move(text_); }

  private:
    void separate();

    std::string text_;
    bool row_begun_ = false;
};

}  // namespace carom::pipeline
