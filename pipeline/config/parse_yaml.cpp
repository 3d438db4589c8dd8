#include "pipeline/config/parse_yaml.h"

#include <algorithm>
#include <istream>
#include <streambuf>
#include <string>
#include <utility>

#include <fmt/core.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "pipeline/config/closing_check.h"
#include "pipeline/config/syntax_problem.h"
#include "pipeline/config/text.h"
#include "pipeline/config/tree_builder.h"

namespace carom::pipeline::config {

namespace {

/// A stream buffer that reads a text without copying it.
class TextBuffer : public std::streambuf {
  public:
    explicit TextBuffer(std::string& text) {
        setg(text.data(), text.data(), text.data() + text.size());
    }
};

/// yaml-cpp scans a whole sequence of opening brackets before it reports the first. A text with an
/// extreme number of them is refused before that. Brackets in strings count, too, so the limit is
/// generous.
bool has_extreme_nesting(std::string_view text, std::size_t& offset) {
    constexpr int kLimit = 2000;
    int open = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '[' || text[i] == '{') {
            if (++open > kLimit) {
                offset = i;
                return true;
            }
        } else if (text[i] == ']' || text[i] == '}') {
            open = std::max(0, open - 1);
        }
    }
    return false;
}

bool check_raw_text(const SourceSet& sources, int source, ProblemList& problems,
                    const YamlLimits& limits) {
    const std::string& text = sources.at(source).text;
    if (text.size() > limits.bytes) {
        problems.error({source, 0, 0, 1},
                       fmt::format("the file has {} bytes; at most {} are allowed{}", text.size(),
                                   limits.bytes, how_to_raise_limits()));
        return false;
    }
    const std::size_t invalid = find_invalid_utf8(text);
    if (invalid != std::string_view::npos) {
        problems.error(sources.place_at(source, invalid, 1), "this is not valid UTF-8 text");
        return false;
    }
    std::size_t offset = 0;
    if (has_extreme_nesting(text, offset)) {
        problems.error(
            sources.place_at(source, offset, 1),
            fmt::format("maps and lists are nested more than {} levels deep", limits.depth));
        return false;
    }
    return true;
}

}  // namespace

std::optional<Node> parse_yaml(const SourceSet& sources, int source, ProblemList& problems,
                               const YamlLimits& limits, std::size_t skipped_bytes) {
    if (!check_raw_text(sources, source, problems, limits)) {
        return std::nullopt;
    }
    std::string text = sources.at(source).text;
    std::fill_n(text.begin(), std::min(skipped_bytes, text.size()), ' ');
    if (const std::optional<ClosingProblem> problem = find_closing_problem(text)) {
        problems.error(sources.place_at(source, problem->offset, problem->length),
                       problem->message);
        return std::nullopt;
    }
    TextBuffer buffer(text);
    std::istream stream(&buffer);
    TreeBuilder builder(sources, source, problems, limits);
    try {
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const TreeBuilder::Refused&) {
        return std::nullopt;
    } catch (const YAML::Exception& failure) {
        const std::size_t offset =
            sources.offset_of(source, failure.mark.line, failure.mark.column);
        const SyntaxProblem problem =
            describe_syntax_error(sources, source, offset, failure.msg, builder.innermost());
        problems.error(problem.place, problem.message);
        return std::nullopt;
    }
    Node root = builder.take_root();
    if (root.place.source < 0) {
        root.place = sources.place_at(source, 0, 1);
    }
    return root;
}

}  // namespace carom::pipeline::config
