#include "pipeline/config/problem.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "core/printable.h"

namespace carom::pipeline {

namespace {

constexpr std::size_t kWidestShownLine = 160;  // characters; longer lines are shown in part

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The text as a list of its characters.
std::vector<std::string> characters(std::string_view text) {
    std::vector<std::string> all;
    for (const char c : text) {
        if (all.empty() || !is_continuation(c)) {
            all.emplace_back();
        }
        all.back() += c;
    }
    return all;
}

struct ShownLine {
    std::string text;
    std::string caret;
};

/// The line, or the part of a long one around the place, and the caret line under it.
ShownLine show_line(const Problem& problem) {
    const std::vector<std::string> all = characters(printable(problem.source_line));
    const auto column = static_cast<std::size_t>(std::max(1, problem.place.column)) - 1;
    std::size_t first = 0;
    std::size_t last = all.size();
    if (all.size() > kWidestShownLine) {
        first = column > kWidestShownLine / 2 ? column - kWidestShownLine / 2 : 0;
        first = std::min(first, all.size() - kWidestShownLine);
        last = first + kWidestShownLine;
    }
    ShownLine shown;
    if (first > 0) {
        shown.text = shown.caret = "...";
        shown.caret = "   ";
    }
    for (std::size_t i = first; i < last; ++i) {
        shown.text += all[i];
        if (i < column) {
            shown.caret += all[i] == "\t" ? '\t' : ' ';
        }
    }
    shown.text += last < all.size() ? "..." : "";
    shown.caret.append(column > last ? column - last : 0, ' ');
    const auto length = static_cast<std::size_t>(std::max(1, problem.place.length));
    const std::size_t room = last > column ? last - column : 1;
    shown.caret += '^' + std::string(std::min(length, room) - 1, '~');
    return shown;
}

std::string place_text(const SourcePlace& place) {
    std::string text = place.file;
    if (place.line > 0) {
        text += fmt::format(":{}", place.line);
        if (place.column > 0) {
            text += fmt::format(":{}", place.column);
        }
    }
    return text;
}

/// The chain of includes, aligned with the line's number.
std::string include_chain_text(const Problem& problem, const std::string& blank) {
    std::string text;
    for (const SourcePlace& place : problem.included_by) {
        text += blank + " = included by " + printable(place_text(place)) + "\n";
    }
    return text;
}

}  // namespace

std::string format(const Problem& problem) {
    return format(problem, problem.severity == Severity::error ? "error:" : "warning:");
}

std::string format(const Problem& problem, const std::string& severity_word) {
    const std::string place = place_text(problem.place);
    std::string text = printable(place) + (place.empty() ? "" : ": ") + severity_word + " " +
                       printable(problem.message);
    if (problem.source_line.empty() || problem.place.line < 1) {
        return text + "\n" + include_chain_text(problem, "     ");
    }
    const std::string number = fmt::format("{}", problem.place.line);
    const std::string margin(number.size() < 5 ? 5 - number.size() : 0, ' ');
    const std::string blank(margin.size() + number.size(), ' ');
    const ShownLine shown = show_line(problem);
    return text + "\n" + margin + number + " | " + shown.text + "\n" + blank + " | " + shown.caret +
           "\n" + include_chain_text(problem, blank);
}

bool has_errors(const std::vector<Problem>& problems) {
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& p) { return p.severity == Severity::error; });
}

}  // namespace carom::pipeline
