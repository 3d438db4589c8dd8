// How help is laid out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace carom::cli {

/// CLI11's layout with descriptions wrapped to fit a terminal of 80 columns.
class HelpFormatter : public CLI::Formatter {
  public:
    std::string make_option_desc(const CLI::Option* option) const override;
};

/// Line breaks put between words so that no line is longer than `width`, unless a word is.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width);

/// The candidate that `word` is most likely a misspelling of, or empty if none is near.
[[nodiscard]] std::string nearest(std::string_view word,
                                  const std::vector<std::string>& candidates);

}  // namespace carom::cli
