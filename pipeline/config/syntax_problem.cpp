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
             "a value cannot begin at this ':'; check the line's indentation and "
             "whether a quote is missing"},
    Sentence{"illegal map key", "a key cannot begin here"},
    Sentence{"illegal block entry", "a list cannot begin here"},
    Sentence{"illegal flow end", "this closing bracket has no opening bracket"},
    Sentence{"end of map not found",
             "a key is expected here; check that the line is indented like "
             "its neighbours"},
    Sentence{"end of sequence not found",
             "a '- ' is expected here; check that the line is indented like "
             "its neighbours"},
    Sentence{"illegal EOF in scalar", "the text ends inside a quoted string"},
    Sentence{"illegal document indicator in scalar", "the document ends inside a quoted string"},
    Sentence{"illegal tab when looking for indentation",
             "a tab cannot be used for indentation; use spaces"},
    Sentence{"the referenced anchor is not defined",
             "this alias refers to an anchor that does not exist"},
    Sentence{"cannot assign multiple anchors to the same node", "a value can have only one anchor"},
    Sentence{"cannot assign multiple tags to the same node", "a value can have only one tag"},
    Sentence{"aliases can't have any content, *including* tags",
             "an alias cannot have a value of its own"},
    Sentence{"alias not found after *",
             "a '*' needs the name of an anchor after it; put a text with '*' in quotes"},
    Sentence{"anchor not found after &",
             "a '&' needs the name of an anchor after it; put a text with '&' in quotes"},
    Sentence{"unknown token", "a value cannot begin with this character; put the text in quotes"},
};

std::size_t line_begin(std::string_view text, std::size_t offset) {
    const std::size_t end = text.rfind('\n', offset == 0 ? 0 : offset - 1);
    return end == std::string_view::npos ? 0 : end + 1;
}

/// The first tab in the indentation of the line of `offset`; npos if there is none.
std::size_t indenting_tab(std::string_view text, std::size_t offset) {
    const std::size_t begin = line_begin(text, offset);
    const std::size_t first = text.find_first_not_of(' ', begin);
    return first != std::string_view::npos && text[first] == '\t' ? first : std::string_view::npos;
}

/// The first opening bracket before `offset` on the same line that is part of a plain word, as in
/// "cue {at: ...", so that it opens no map or list; npos if there is none.
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

/// An unusual space on the line of `offset` or on the line before it.
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
        return {sources.place_at(source, tab, 1),
                "YAML syntax: a tab cannot be used for indentation; use spaces"};
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
                        "' is inside a word and opens nothing; is a ':' missing before it?"};
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
