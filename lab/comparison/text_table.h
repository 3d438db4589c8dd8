// Tables of fixed-width text.
#pragma once

#include <string>
#include <vector>

namespace carom::pipeline {

/// The first column is left-aligned, the others right-aligned; each is as wide as its widest text,
/// with two blanks between columns.
class TextTable {
  public:
    explicit TextTable(std::vector<std::string> header) { rows_.push_back(std::move(header)); }

    /// At most as many texts as the header has; shorter rows end early.
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    /// Lines without trailing blanks.
    [[nodiscard]] std::string text() const;

  private:
    std::vector<std::vector<std::string>> rows_;
};

/// Three significant digits or, from 100 on, whole numbers: "0.744", "65.9", "3375".
[[nodiscard]] std::string short_number(double value);

/// With a unit prefix from 1e4 on: "942 181" becomes "942k", 3169098000 "3169M".
[[nodiscard]] std::string large_number(double value);

}  // namespace carom::pipeline
