// The answers of a solver, kept as files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pipeline/solve/question.h"

namespace carom::pipeline::solve {

/// Where answers are kept, each under the hash of its question.
struct AnswerFolder {
    std::string path;  // empty: nowhere
    bool is_read_only = false;
};

/// How the questions of a shot are answered while it is read.
struct AnswerWork {
    AnswerFolder folder{};
    PartsWork parts{};
    /// Told of solutions of the strike with that number in `events`, by one thread at a time.
    std::function<void(std::size_t event, const Solution&)> found{};
    /// Told that a search ended without a strike that does all that is wanted.
    std::function<void()> none_found{};
    /// After a stop the best that had been found is taken; otherwise Stopped is thrown.
    bool takes_incomplete = false;
};

/// The answer from the folder, or else of a search, which is kept there if it is complete and the
/// folder can be written to. One from the folder lacks outcomes. Throws as Solver::solve.
[[nodiscard]] SolveResult answer(const SolveQuestion& question, const AnswerWork& work);

/// The text of an answer, without outcomes. Numbers have all digits.
[[nodiscard]] std::string answer_text(const SolveResult& result);

/// What the text says; empty if it is damaged. Outcomes are empty.
[[nodiscard]] std::optional<SolveResult> parse_answer(std::string_view text,
                                                      const SolveQuestion& question);

}  // namespace carom::pipeline::solve
