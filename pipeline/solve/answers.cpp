#include "pipeline/solve/answers.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/solve/player.h"

namespace carom::pipeline::solve {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "carom answer 1\n";

std::string hash_line(std::string_view text) {
    return Hasher().add(text).finish().to_string() + "\n";
}

/// Takes lines and numbers from a text that answer_text() made.
class AnswerReader {
  public:
    explicit AnswerReader(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool is_at_end() const { return rest_.empty(); }
    [[nodiscard]] std::string_view line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view taken = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return taken;
    }
    [[nodiscard]] std::vector<double> numbers() {
        std::vector<double> values;
        for (std::string_view words = line(); !words.empty();) {
            double value = 0;
            const auto [end, error] =
                std::from_chars(words.data(), words.data() + words.size(), value);
            if (error != std::errc()) {
                return {};
            }
            values.push_back(value);
            words.remove_prefix(
                std::min(static_cast<std::size_t>(end - words.data()) + 1, words.size()));
        }
        return values;
    }

  private:
    std::string_view rest_;
};

std::string file_of(const AnswerFolder& folder, const SolveQuestion& question) {
    return folder.path + "/" + hash_of(question).to_string() + ".answer";
}

std::optional<SolveResult> find(const AnswerFolder& folder, const SolveQuestion& question) {
    if (folder.path.empty()) {
        return std::nullopt;
    }
    const std::string path = file_of(folder, question);
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    std::optional<SolveResult> found = parse_answer(text, question);
    if (found && !folder.is_read_only) {
        std::error_code ignored;  // it only tells when the answer was used
        fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
    }
    return found;
}

void keep(const AnswerFolder& folder, const SolveQuestion& question, const SolveResult& result) {
    if (folder.path.empty() || folder.is_read_only) {
        return;
    }
    std::error_code ignored;
    fs::create_directories(folder.path, ignored);
    try {
        const std::string text = answer_text(result);
        write_file_atomically(file_of(folder, question), std::as_bytes(std::span(text)),
                              FileAccess::of_folder);
    } catch (const Error&) {
        // The next process searches again.
    }
}

}  // namespace

std::string answer_text(const SolveResult& result) {
    std::string text(kHead);
    text += fmt::format("{}\n", result.simulations);
    for (const Solution& each : result.solutions) {
        const Setting setting = setting_of(each.strike);
        text += each.route + "\n" + each.ball + "\n";
        text += fmt::format("{} {} {} {} {} {} {} {} {} {} {}", each.is_solved ? 1 : 0, each.miss,
                            each.window.x, each.window.y, each.chance, each.chance_error,
                            setting.direction, setting.speed, setting.tip.x, setting.tip.y,
                            setting.elevation);
        text += each.rest ? fmt::format(" {} {}\n", each.rest->x, each.rest->y) : "\n";
    }
    return text + hash_line(text);
}

std::optional<SolveResult> parse_answer(std::string_view text, const SolveQuestion& question) {
    constexpr std::size_t kHashLine = 33;
    if (!text.starts_with(kHead) || text.size() < kHead.size() + kHashLine ||
        text.substr(text.size() - kHashLine) !=
            hash_line(text.substr(0, text.size() - kHashLine))) {
        return std::nullopt;
    }
    AnswerReader reader(text.substr(kHead.size(), text.size() - kHead.size() - kHashLine));
    SolveResult result;
    const std::vector<double> simulations = reader.numbers();
    if (simulations.size() != 1) {
        return std::nullopt;
    }
    result.simulations = static_cast<std::size_t>(simulations[0]);
    const auto& strike =
        std::get<sim::Strike>(question.world.events.at(question.problem.event).action);
    while (!reader.is_at_end()) {
        Solution& each = result.solutions.emplace_back();
        each.route = reader.line();
        each.ball = reader.line();
        const std::vector<double> values = reader.numbers();
        if (values.size() != 11 && values.size() != 13) {
            return std::nullopt;
        }
        each.is_solved = values[0] == 1;
        each.miss = values[1];
        each.window = Vec2(values[2], values[3]);
        each.chance = values[4];
        each.chance_error = values[5];
        each.strike =
            with_setting(strike, {values[6], values[7], {values[8], values[9]}, values[10]});
        if (values.size() == 13) {
            each.rest = Vec2(values[11], values[12]);
        }
    }
    return result;
}

SolveResult answer(const SolveQuestion& question, const AnswerWork& work) {
    const auto tell = [&](const Solution& solution) {
        if (work.found && solution.is_solved) {
            work.found(question.problem.event, solution);
        }
    };
    std::optional<SolveResult> known = find(work.folder, question);
    if (known) {
        std::ranges::for_each(known->solutions, tell);
    } else {
        known = solve(sim::Trials(question.world), question.problem, {work.parts, tell});
        if (known->is_complete) {
            keep(work.folder, question, *known);
        }
    }
    const bool is_solved = !known->solutions.empty() && known->solutions.front().is_solved;
    if (known->is_complete && !is_solved && work.none_found) {
        work.none_found();
    }
    return std::move(*known);
}

}  // namespace carom::pipeline::solve
