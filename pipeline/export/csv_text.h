// Writes comma-separated values.
#pragma once

#include <string>
#include <string_view>

#include "core/vectors.h"

namespace carom::pipeline {

/// Builds CSV according to RFC 4180, except that a row ends with a line feed alone, as is usual on
/// Linux. Numbers are the shortest decimal text that reads back as the same double; -0 is written
/// as 0.
class CsvText {
  public:
    /// Without a row.
    CsvText() = default;
    /// `header` is the first row, without quoting.
    explicit CsvText(std::string_view header);

    /// The text is quoted if it contains a comma, a quotation mark or a line break.
    CsvText& add(std::string_view text);
    CsvText& add(double value);
    CsvText& add(const Vec3& value);  // three columns
    CsvText& add(const Quat& value);  // four: w x y z

    void end_row();

    /// Returns the text. The object must not be used afterwards.
    [[nodiscard]] std::string finish() { return std::move(text_); }

  private:
    void separate();

    std::string text_;
    bool row_begun_ = false;
};

}  // namespace carom::pipeline
