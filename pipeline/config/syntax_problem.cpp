#include "pipeline/config/syntax_problem.h"

#include <algorithm>
#include <array>
#include <optional>

#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

struct Sentence {
    std::string_view theirs;
    std::string_view ours;
};

constexpr std::array kSentences{
    Sentence{"illegal map value",
             "a ':' where no value can begin (is the line indented as its "
             "neighbours, or is a quote missing?)"},
    Sentence{"illegal map key", "a key where none can begin"},
    Sentence{"illegal block entry", "a '- ' where no list can begin"},
    Sentence{"illegal flow end", "a closing bracket that was never opened"},
    Sentence{"end of map not found",
             "a key is expected here (is the line indented as its "
             "neighbours?)"},
    Sentence{"end of sequence not found",
             "a '- ' is expected here (is the line indented as its "
             "neighbours?)"},
    Sentence{"illegal EOF in scalar", "the text ends inside a quoted string"},
    Sentence{"illegal document indicator in scalar", "a document's end inside a quoted string"},
    Sentence{"illegal tab when looking for indentation", "a tab cannot indent; use spaces"},
    Sentence{"the referenced anchor is not defined", "an alias to an anchor that is not there"},
    Sentence{"cannot assign multiple anchors to the same node", "a second anchor for one value"},
    Sentence{"cannot assign multiple tags to the same node", "a second tag for one value"},
    Sentence{"aliases can't have any content, *including* tags",
             "an alias with a value of its own"},
    Sentence{"alias not found after *", "a '*' without a name (a text with it needs quotes)"},
    Sentence{"anchor not found after &", "a '&' without a name (a text with it needs quotes)"},
    Sentence{"unknown token",
             "a character that cannot begin a value (a text with it needs quotes)"},
};

std::size_t line_begin(std::string_view text, std::size_t offset) {
    const std::size_t end = text.rfind('\n', offset == 0 ? 0 : offset - 1);
    return end == std::string_view::npos ? 0 : end + 1;
}

/// The first tab that indents the line of `offset`; npos if there is none.
std::size_t indenting_tab(std::string_view text, std::size_t offset) {
    const std::size_t begin = line_begin(text, offset);
    const std::size_t first = text.find_first_not_of(' ', begin);
    return first != std::string_view::npos && text[first] == '\t' ? first : std::string_view::npos;
}

/// The opening bracket of that kind before `offset` on the same line that stands within a plain
/// word ("cue {at: ..."), so that it opens nothing; npos if there is none.
std::size_t bracket_without_colon(std::string_view text, std::size_t offset) {
    const std::size_t begin = line_begin(text, offset);
    const std::string_view line = text.substr(begin, offset - begin);
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] != '{' && line[i] != '[') {
            continue;
        }
        const std::size_t before = line.find_last_not_of(' ', i - 1);
        if (before != std::string_view::npos &&
            std::string_view(":,[{-").find(line[before]) == std::string_view::npos) {
            return begin + i;
        }
    }
    return std::string_view::npos;
}

/// A space of another kind on the line of `offset` or on the line before it.
std::optional<OddSpace> odd_space_near(std::string_view text, std::size_t offset) {
    const std::size_t line = line_begin(text, offset);
    const std::size_t begin = line == 0 ? 0 : line_begin(text, line - 1);
    const std::size_t end = std::min(text.find('\n', offset), text.size());
    const std::string_view lines = text.substr(begin, end - begin);
    std::optional<OddSpace> space = find_odd_space(lines);
    const std::size_t comment = space ? lines.rfind('#', space->offset) : std::string_view::npos;
    if (comment != std::string_view::npos && comment > lines.rfind('\n', space->offset) + 1) {
        return std::nullopt;
    }
    if (space) {
        space->offset += begin;
    }
    return space;
}

}  // namespace

SyntaxProblem describe_syntax_error(const SourceSet& sources, int source, std::size_t offset,
                                    std::string_view message, const Node* innermost) {
    const bool is_open_map = message == "end of map flow not found";
    const bool is_open_list = message == "end of sequence flow not found";
    if ((is_open_map || is_open_list) && innermost != nullptr) {
        return {innermost->place, std::string("YAML syntax: this ") +
                                      (is_open_map ? "'{'" : "'['") +
                                      " is never closed, or a comma is missing after a value"};
    }
    const std::string_view text = sources.at(source).text;
    const std::size_t tab = indenting_tab(text, std::min(offset, text.size()));
    if (tab != std::string_view::npos) {
        return {sources.place_at(source, tab, 1), "YAML syntax: a tab cannot indent; use spaces"};
    }
    if (const std::optional<OddSpace> space = odd_space_near(text, std::min(offset, text.size()))) {
        return {
            sources.place_at(source, space->offset, space->length),
            "YAML syntax: " + space->name + " does not separate words; write an ordinary space"};
    }
    if (message == "illegal flow end" || message == "illegal map value") {
        const std::size_t bracket = bracket_without_colon(text, offset);
        if (bracket != std::string_view::npos) {
            return {sources.place_at(source, bracket, 1),
                    std::string("YAML syntax: this '") + text[bracket] +
                        "' stands inside a word and opens nothing; a ':' is missing before it"};
        }
    }
    for (const Sentence& sentence : kSentences) {
        if (message == sentence.theirs) {
            return {sources.place_at(source, offset, 1),
                    "YAML syntax: " + std::string(sentence.ours)};
        }
    }
    return {sources.place_at(source, offset, 1), "YAML syntax: " + std::string(message)};
}

}  // namespace carom::pipeline::config
