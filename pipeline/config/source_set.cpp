#include "pipeline/config/source_set.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kLongestShownLineBytes = 4096;

std::vector<std::size_t> find_line_starts(std::string_view text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') {
            starts.push_back(i + 1);
        }
    }
    return starts;
}

}  // namespace

int character_count(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

int SourceSet::add(SourceText source) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (source.text.starts_with(kByteOrderMark)) {
        source.text.erase(0, kByteOrderMark.size());
    }
    std::vector<std::size_t> starts = find_line_starts(source.text);
    sources_.push_back({std::move(source), std::move(starts)});
    return size() - 1;
}

std::string_view SourceSet::line_text(const Entry& entry, std::size_t line) const {
    const std::string_view text = entry.source.text;
    const std::size_t begin = entry.line_starts[line];
    std::size_t end =
        line + 1 < entry.line_starts.size() ? entry.line_starts[line + 1] - 1 : text.size();
    if (end > begin && text[end - 1] == '\r') {
        --end;
    }
    return text.substr(begin, end - begin);
}

std::string SourceSet::line_of(const Place& place) const {
    if (place.source < 0 || place.line < 1) {
        return {};
    }
    const Entry& entry = sources_.at(place.source);
    const auto line = static_cast<std::size_t>(place.line) - 1;
    if (line >= entry.line_starts.size()) {
        return {};
    }
    const std::string_view text = line_text(entry, line);
    return text.size() > kLongestShownLineBytes ? std::string() : std::string(text);
}

SourcePlace SourceSet::describe(const Place& place) const {
    if (place.source < 0) {
        return {};
    }
    return {sources_.at(place.source).source.name, place.line, place.column,
            std::max(1, place.length)};
}

std::vector<SourcePlace> SourceSet::include_chain(const Place& place) const {
    std::vector<SourcePlace> places;
    for (int source = place.source; source >= 0;) {
        const Place& included_at = sources_.at(source).source.included_at;
        if (included_at.source >= 0) {
            SourcePlace by = describe(included_at);
            if (by.file.starts_with("--")) {
                by.line = by.column = 0;
            }
            places.push_back(std::move(by));
        }
        source = included_at.source;
    }
    return places;
}

std::string SourceSet::to_string(const Place& place) const {
    const SourcePlace where = describe(place);
    return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

Place SourceSet::place_at(int index, std::size_t offset, std::size_t length_bytes) const {
    const Entry& entry = sources_.at(index);
    const std::string_view text = entry.source.text;
    offset = std::min(offset, text.size());
    const auto after = std::upper_bound(entry.line_starts.begin(), entry.line_starts.end(), offset);
    const auto line = static_cast<std::size_t>(after - entry.line_starts.begin()) - 1;
    const std::size_t begin = entry.line_starts[line];
    const std::string_view whole = line_text(entry, line);
    const std::size_t column_bytes = std::min(offset - begin, whole.size());
    const std::string_view token = whole.substr(column_bytes, length_bytes);
    return {index, static_cast<int>(line) + 1, character_count(whole.substr(0, column_bytes)) + 1,
            std::max(1, character_count(token))};
}

std::size_t SourceSet::offset_of(int index, int line, int column_bytes) const {
    const Entry& entry = sources_.at(index);
    const auto row = static_cast<std::size_t>(std::max(0, line));
    if (row >= entry.line_starts.size()) {
        return entry.source.text.size();
    }
    return std::min(entry.line_starts[row] + static_cast<std::size_t>(std::max(0, column_bytes)),
                    entry.source.text.size());
}

}  // namespace carom::pipeline::config
