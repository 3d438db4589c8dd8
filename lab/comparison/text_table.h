// Tables of fixed-width text.
#pragma once

#include <string>
#include <vector>

namespace carom::pipeline {

/// The first column is aligned to the left, the others to the right; each is as wide as its widest
/// text, with two blanks between.
class TextTable {
  public:
    explicit TextTable(std::vector<std::string> header) { rows_.push_back(std::move(header)); }

    /// As many texts as the header has; shorter rows end early.
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    /// Lines without trailing blanks.
    [[nodiscard]] std::string text() const;

  private:
    std::vector<std::vector<std::string>> rows_;
};

/// Three significant digits or, from 100 on, whole numbers: "0.744", "65.9", "3375".
[[nodiscard]] std::string short_number(double value);

/// With a prefix from 1e4 on: "942 181" is "942k", 3169098000 is "3169M".
[[nodiscard]] std::string large_number(double value);

}  // namespace carom::pipeline
