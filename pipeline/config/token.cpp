#include "pipeline/config/token.h"

#include <algorithm>
#include <string_view>

namespace carom::pipeline::config {

namespace {

/// The number of bytes of the token that starts at `offset`: a quoted scalar with its quotes, an
/// alias, a plain scalar up to its end on this line, or one bracket.
std::size_t token_length(std::string_view text, std::size_t offset) {
    const std::string_view rest = text.substr(offset);
    const std::size_t line_end = std::min(rest.find_first_of("\r\n"), rest.size());
    if (rest.empty() || line_end == 0) {
        return 1;
    }
    const char first = rest[0];
    if (first == '"' || first == '\'') {
        std::size_t i = 1;
        while (i < line_end && rest[i] != first) {
            i += first == '"' && rest[i] == '\\' ? 2 : 1;
        }
        return std::min(i + 1, line_end);
    }
    if (first == '[' || first == '{' || first == '-' || first == '|' || first == '>') {
        const bool is_number = first == '-' && rest.size() > 1 && rest[1] != ' ';
        if (!is_number) {
            return 1;
        }
    }
    std::size_t end = 0;
    while (end < line_end) {
        const char c = rest[end];
        const char next = end + 1 < line_end ? rest[end + 1] : ' ';
        if (c == ',' || c == ']' || c == '}' || (c == ':' && (next == ' ' || next == '\t')) ||
            (c == '#' && end > 0 && rest[end - 1] == ' ')) {
            break;
        }
        ++end;
    }
    while (end > 1 && (rest[end - 1] == ' ' || rest[end - 1] == '\t')) {
        --end;
    }
    return std::max<std::size_t>(1, end);
}

/// `offset` moved after "&anchor " and "!tag ".
std::size_t skip_properties(std::string_view text, std::size_t offset) {
    while (offset < text.size() && (text[offset] == '&' || text[offset] == '!')) {
        const std::size_t blank = text.find_first_of(" \t\r\n", offset);
        const std::size_t next = blank == std::string_view::npos
                                     ? std::string_view::npos
                                     : text.find_first_not_of(" \t\r\n", blank);
        if (next == std::string_view::npos) {
            return offset;
        }
        offset = next;
    }
    return offset;
}

}  // namespace

Place token_at(const SourceSet& sources, int source, int line, int column_bytes) {
    const std::string& text = sources.at(source).text;
    const std::size_t offset = skip_properties(text, sources.offset_of(source, line, column_bytes));
    return sources.place_at(source, offset, token_length(text, offset));
}

}  // namespace carom::pipeline::config
