#include "pipeline/import/csv_lines.h"

#include <algorithm>
#include <string_view>

namespace carom::pipeline {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::string_view kBlanks = " \t\r";

/// The end of the cell that begins at `from`: the position of its separator, or the end of the
/// line.
std::size_t end_of_cell(std::string_view line, std::size_t from, char separator) {
    bool is_quoted = false;
    for (std::size_t at = from; at < line.size(); ++at) {
        if (line[at] == '"') {
            is_quoted = !is_quoted;
        } else if (line[at] == separator && !is_quoted) {
            return at;
        }
    }
    return line.size();
}

/// The separator that divides the line into most cells.
char separator_of(std::string_view line) {
    char best = ',';
    std::ptrdiff_t most = 0;
    for (const char separator : {',', ';', '\t'}) {
        std::ptrdiff_t count = 0;
        for (std::size_t at = end_of_cell(line, 0, separator); at < line.size();
             at = end_of_cell(line, at + 1, separator)) {
            ++count;
        }
        if (count > most) {
            most = count;
            best = separator;
        }
    }
    return best;
}

/// The separator that a first line like Excel's "sep=;" declares; 0 for any other line.
char declared_separator(std::string_view line) {
    const std::size_t last = line.find_last_not_of("\r ");
    line = line.substr(0, last == std::string_view::npos ? 0 : last + 1);
    return line.size() == 5 && line.starts_with("sep=") ? line.back() : '\0';
}

std::string unquoted(std::string_view text) {
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') {
        return std::string(text);
    }
    std::string result;
    for (std::size_t at = 1; at + 1 < text.size(); ++at) {
        at += text[at] == '"' && text[at + 1] == '"' && at + 2 < text.size() ? 1 : 0;
        result += text[at];
    }
    return result;
}

}  // namespace

CsvTable csv_table(const config::SourceSet& sources, int source) {
    const std::string_view text = sources.at(source).text;
    CsvTable table;
    std::vector<CsvLine>& lines = table.lines;
    char& separator = table.separator;
    std::size_t begin = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find_first_of("\n\r", begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        const std::size_t first = line.find_first_not_of(kBlanks);
        const char declared = separator == 0 ? declared_separator(line) : '\0';
        if (declared != '\0') {
            separator = declared;
        } else if (first != std::string_view::npos && line[first] != '#') {
            separator = separator != 0 ? separator : separator_of(line);
            CsvLine result;
            result.place = sources.place_at(source, begin + first, line.size() - first);
            for (std::size_t at = 0; at <= line.size();) {
                const std::size_t stop = end_of_cell(line, at, separator);
                const std::string_view cell = line.substr(at, stop - at);
                const std::size_t from = std::min(cell.find_first_not_of(kBlanks), cell.size());
                const std::size_t to = cell.find_last_not_of(kBlanks) + 1;
                const std::string_view word = from < to ? cell.substr(from, to - from) : "";
                result.cells.push_back(
                    {unquoted(word), sources.place_at(source, begin + at + from,
                                                      std::max<std::size_t>(word.size(), 1))});
                at = stop + 1;
            }
            lines.push_back(std::move(result));
        }
        begin = end + 1;
    }
    return table;
}

}  // namespace carom::pipeline
