#include "pipeline/config/closing_check.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kNotFound = std::string_view::npos;

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

/// A simplified tokenizer. It determines only which quotes open a quoted text, which brackets open
/// a list or a map, and the indentation of their key (or dash).
class ClosingFinder {
  public:
    explicit ClosingFinder(std::string_view text) : text_(text) {}

    std::optional<ClosingProblem> find() {
        while (at_ < text_.size() && !problem_) {
            if (at_ == line_start_ && begin_line()) {
                continue;
            }
            read_token();
        }
        return std::move(problem_);
    }

  private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\n';
    }
    [[nodiscard]] bool ends_word(std::size_t ahead) const {
        return is_blank(peek(ahead)) || is_line_end(peek(ahead));
    }
    [[nodiscard]] int column(std::size_t offset) const {
        return static_cast<int>(offset - line_start_);
    }
    [[nodiscard]] std::size_t line_end(std::size_t offset) const {
        return std::min(text_.find('\n', offset), text_.size());
    }
    [[nodiscard]] std::size_t line_number(std::size_t offset) const {
        return 1 + static_cast<std::size_t>(std::count(
                       text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
    }

    [[nodiscard]] bool in_flow() const { return !open_.empty(); }

    void go_to_next_line() {
        at_ = line_end(at_);
        at_ += at_ < text_.size() ? 1 : 0;
        line_start_ = at_;
    }

    /// "---" or "...".
    [[nodiscard]] bool begins_document() const {
        const std::string_view start = text_.substr(at_, 3);
        return (start == "---" || start == "...") && ends_word(3);
    }

    /// Reads the beginning of a line. True if the caller must call it again, at the next line.
    bool begin_line() {
        const std::size_t first = text_.find_first_not_of(" \t\r", at_);
        if (first == kNotFound || text_[first] == '\n') {
            go_to_next_line();
            return true;
        }
        if (begins_document()) {
            parent_ = -1;
            is_plain_open_ = false;
            at_ += 3;
            return true;
        }
        at_ = first;
        return in_flow() ? continue_flow() : begin_block_line();
    }

    /// Like begin_line, on a line within brackets.
    bool continue_flow() {
        const bool continues = std::exchange(is_plain_open_, false) && peek() != '#';
        if (column(at_) <= parent_ && peek() != '#') {
            return check_open_brackets();
        }
        if (continues && std::string_view(",]}[{:").find(peek()) == kNotFound) {
            read_plain();
            return true;
        }
        return false;
    }

    /// Like begin_line, on any other line.
    bool begin_block_line() {
        if (is_plain_open_ && peek() != '#' && column(at_) > plain_parent_) {
            go_to_next_line();
            return true;
        }
        is_plain_open_ = false;
        if (column(at_) <= parent_ && peek() != '-' && peek() != '#') {
            // The block with deeper indentation has ended. A bracket or a quote here is not the
            // value of a key above, and the keys that follow are not continuation lines of it.
            const bool is_opening = std::string_view("[{'\"").find(peek()) != kNotFound;
            parent_ = std::max(column(at_) - 1, is_opening ? 0 : -1);
        }
        return false;
    }

    void read_token() {
        const char c = peek();
        if (c == '\n' || (c == '#' && (column(at_) == 0 || is_blank(text_[at_ - 1])))) {
            go_to_next_line();
        } else if (is_blank(c) || c == '\r' || (in_flow() && c == ',')) {
            ++at_;
        } else if (c == '\'' || c == '"') {
            read_quoted();
        } else if (!in_flow() && (c == '-' || c == '?') && ends_word(1)) {
            parent_ = column(at_++);
        } else if (c == ':' && (in_flow() || ends_word(1))) {
            parent_ = in_flow() ? parent_ : token_column_;
            ++at_;
        } else if (c == '[' || c == '{') {
            open_.push_back(at_++);
        } else if (in_flow() && (c == ']' || c == '}')) {
            close_bracket();
        } else if (c == '&' || c == '*' || c == '!') {
            skip_property();
        } else if (!in_flow() && (c == '|' || c == '>')) {
            skip_block_text();
        } else {
            read_plain();
        }
    }

    [[nodiscard]] std::string describe_bracket(std::size_t bracket) const {
        return std::string("this '") + text_[bracket] + "'";
    }

    void close_bracket() {
        const std::size_t bracket = open_.back();
        if ((text_[bracket] == '[') != (peek() == ']')) {
            const std::string closed_by = std::string(" is closed by a '") + peek() + "'";
            const std::size_t line = line_number(at_);
            at_ = bracket;
            report(describe_bracket(bracket) + closed_by +
                       (line == line_number(bracket) ? "" : fmt::format(" on line {}", line)),
                   1);
            return;
        }
        open_.pop_back();
        ++at_;
    }

    /// Checks a line that is not indented more deeply than the key of the open brackets. It must
    /// begin with a closing bracket. True after a problem.
    bool check_open_brackets() {
        if (peek() == ']' || peek() == '}') {
            return false;
        }
        const std::string line = fmt::format("{}", line_number(at_));
        at_ = open_.back();
        report(describe_bracket(at_) + " must be closed before line " + line +
                   ", which is not indented more deeply than its key",
               1);
        return true;
    }

    /// Skips an anchor, an alias or a tag.
    void skip_property() {
        token_column_ = column(at_);
        const std::string_view ends = in_flow() ? " \t\r\n,[]{}" : " \t\r\n";
        at_ = std::min(text_.find_first_of(ends, at_ + 1), text_.size());
    }

    void skip_block_text() {
        for (go_to_next_line(); at_ < text_.size(); go_to_next_line()) {
            const std::size_t first = text_.find_first_not_of(" \r", at_);
            const bool is_empty = first == kNotFound || text_[first] == '\n';
            if (!is_empty && column(first) <= parent_) {
                return;
            }
        }
    }

    /// Reads a scalar without quotes up to its end on this line.
    void read_plain() {
        token_column_ = column(at_);
        plain_parent_ = parent_;
        ++at_;
        while (at_ < text_.size() && !is_line_end(peek())) {
            const bool is_value =
                peek() == ':' && (ends_word(1) || (in_flow() && (peek(1) == ',' || peek(1) == ']' ||
                                                                 peek(1) == '}')));
            if (is_value || (peek() == '#' && is_blank(text_[at_ - 1])) ||
                (in_flow() && std::string_view(",[]{}").find(peek()) != kNotFound)) {
                return;
            }
            ++at_;
        }
        is_plain_open_ = true;
    }

    /// The offset of the quote that closes the text at `at_`, or kNotFound.
    [[nodiscard]] std::size_t find_closing_quote() const {
        const char mark = peek();
        for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
            if (mark == '"' && text_[i] == '\\') {
                ++i;
            } else if (text_[i] == mark) {
                if (mark == '"' || i + 1 >= text_.size() || text_[i + 1] != mark) {
                    return i;
                }
                ++i;  // '' is an apostrophe
            }
        }
        return kNotFound;
    }

    /// The first line between the quotes that is not indented as a continuation line, or kNotFound.
    [[nodiscard]] std::size_t find_shallow_line(std::size_t close) const {
        const std::string_view inside = text_.substr(0, close);
        for (std::size_t end = inside.find('\n', at_); end != kNotFound;
             end = inside.find('\n', end)) {
            const std::size_t start = ++end;
            const std::size_t first = text_.find_first_not_of(" \t\r", start);
            const std::size_t indent = text_.find_first_not_of(' ', start);
            if (first != kNotFound && text_[first] != '\n' &&
                static_cast<int>(indent - start) <= parent_) {
                return start;
            }
        }
        return kNotFound;
    }

    void read_quoted() {
        const std::size_t close = find_closing_quote();
        if (close == kNotFound) {
            report("the quote opened here is never closed");
            return;
        }
        const std::size_t shallow = find_shallow_line(close);
        if (shallow != kNotFound) {
            report(
                fmt::format("{}; further lines of a quoted text must be indented more deeply than "
                            "its key, but line {} is not",
                            describe_late_quote(close), line_number(shallow)));
            return;
        }
        token_column_ = column(at_);
        check_after_quote(close);
        if (problem_) {
            return;
        }
        const std::size_t last_line_end = text_.substr(at_, close - at_).rfind('\n');
        if (last_line_end != kNotFound) {
            line_start_ = at_ + last_line_end + 1;
        }
        at_ = close + 1;
    }

    [[nodiscard]] std::string describe_late_quote(std::size_t close) const {
        return fmt::format("the quote opened here is closed only on line {}", line_number(close));
    }

    /// Checks that the value ends at the closing quote.
    void check_after_quote(std::size_t close) {
        std::size_t next = close + 1;
        while (next < text_.size() && is_blank(text_[next])) {
            ++next;
        }
        const bool is_end = next >= text_.size() || is_line_end(text_[next]) ||
                            std::string_view(",]}:").find(text_[next]) != kNotFound ||
                            (text_[next] == '#' && next > close + 1);
        if (is_end) {
            return;
        }
        const std::size_t end = std::min(text_.find_first_of("\r\n", next), text_.size());
        const std::string rest = quote(text_.substr(next, end - next));
        if (text_.substr(at_, close - at_).find('\n') != kNotFound) {
            report(describe_late_quote(close) + ", where " + rest + " follows it");
            return;
        }
        const bool is_single = peek() == '\'';
        at_ = next;
        report(rest + " follows a closing quote; is a quote or a comma missing?" +
               (is_single ? " An apostrophe in single quotes is written twice: ''" : ""));
    }

    /// Reports a problem at `at_`, up to the end of the line unless a length is given.
    void report(const std::string& message, std::size_t length = kNotFound) {
        const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
        problem_ = ClosingProblem{at_, std::clamp<std::size_t>(end - at_, 1, length),
                                  "YAML syntax: " + message};
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_start_ = 0;
    std::vector<std::size_t> open_;  // brackets, the innermost last
    int parent_ = -1;             // column of the key or dash of the next value; -1: the document
    int token_column_ = 0;        // column of the last scalar
    bool is_plain_open_ = false;  // the next line may continue a text without quotes ...
    int plain_parent_ = -1;       // ... of the key in this column
    std::optional<ClosingProblem> problem_;
};

}  // namespace

std::optional<ClosingProblem> find_closing_problem(std::string_view text) {
    return ClosingFinder(text).find();
}

}  // namespace carom::pipeline::config
