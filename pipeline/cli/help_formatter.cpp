#include "pipeline/cli/help_formatter.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace carom::cli {

namespace {

constexpr std::size_t kTerminalWidth = 80;

/// Insertions, deletions and replacements that turn one word into the other (Levenshtein 1966).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
    return wrapped(option->get_description(), kTerminalWidth - get_column_width());
}

std::string wrapped(std::string_view text, std::size_t width) {
    std::istringstream words{std::string(text)};
    std::string out;
    std::size_t length = 0;
    for (std::string word; words >> word;) {
        const bool fits = length + 1 + word.size() <= width;
        if (!out.empty()) {
            out += fits ? ' ' : '\n';
            length = fits ? length + 1 : 0;
        }
        out += word;
        length += word.size();
    }
    return out;
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(word.size() / 2, 1) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace carom::cli
