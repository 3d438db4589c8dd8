#include <algorithm>
#include <functional>
#include <map>
#include <numbers>

#include <fmt/core.h>

#include "core/json_text.h"
#include "core/text.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/solve/answers.h"
#include "pipeline/solve/explain.h"
#include "pipeline/study/solve_plot.h"
#include "sim/bake.h"

namespace carom::cli {

namespace {

namespace solve = pipeline::solve;

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::size_t kListed = 3;

std::string strike_text(const sim::Strike& strike) {
    std::string text =
        fmt::format("direction {} deg", decimal_text(strike.direction.value_or(0) / kDegree, 3));
    if (strike.ball_speed) {
        text += fmt::format(", ball speed {} m/s", decimal_text(*strike.ball_speed, 2));
    } else {
        text += fmt::format(", speed {} m/s", decimal_text(strike.speed.value_or(0), 2));
    }
    text +=
        fmt::format(", tip [{}, {}]", decimal_text(strike.tip.x, 2), decimal_text(strike.tip.y, 2));
    if (strike.elevation > 0) {
        text += fmt::format(", elevation {} deg", decimal_text(strike.elevation / kDegree, 1));
    }
    return text;
}

std::string rest_text(const solve::Solution& solution) {
    return solution.rest
               ? fmt::format("   '{}' rests at [{}, {}]\n", solution.ball,
                             decimal_text(solution.rest->x, 3), decimal_text(solution.rest->y, 3))
               : fmt::format("   '{}' leaves the table\n", solution.ball);
}

/// Of a strike that meets its wants, all of them happen. Empty if the question is not known.
std::vector<std::pair<std::string, std::optional<double>>> measured_values(
    const solve::SolveQuestion* question, const solve::Solution& solution) {
    return question != nullptr
               ? solve::measured_values(question->world, question->problem, solution.strike)
               : std::vector<std::pair<std::string, std::optional<double>>>{};
}

/// `question`: null if it is not known.
std::string text_of(std::size_t event, const solve::SolveResult& result,
                    const solve::SolveQuestion* question, bool lists_all) {
    const auto& solutions = result.solutions;
    const auto count =
        static_cast<std::size_t>(std::ranges::count_if(solutions, &solve::Solution::is_solved));
    std::string text = fmt::format("events[{}]: {}", event, counted(count, "solution"));
    text +=
        result.is_complete ? fmt::format(" in {} simulations\n", result.simulations) : " so far\n";
    const std::size_t listed = lists_all ? count : std::min(count, kListed);
    for (std::size_t i = 0; i < listed; ++i) {
        const solve::Solution& each = solutions[i];
        text += fmt::format("{}. {}\n   {}\n", i + 1, each.route, strike_text(each.strike));
        if (each.window_width() > 0) {
            text += fmt::format("   succeeds within {} deg; ",
                                decimal_text(each.window_width() / kDegree, 2));
        } else {
            text += "   ";
        }
        // Of what was found just before an interruption the chance is not known.
        text += result.is_complete || each.chance > 0
                    ? fmt::format("chance {:.0f} % (standard error {:.0f} %)\n", 100 * each.chance,
                                  100 * each.chance_error)
                    : "chance not yet known\n";
        text += rest_text(each);
        for (const auto& [title, value] : measured_values(question, each)) {
            text += fmt::format("   '{}' is {:.4g}\n", title, value.value_or(0));
        }
    }
    if (listed < count) {
        text += fmt::format("{} more: --all lists them\n", count - listed);
    }
    return text;
}

/// A JSON object in each line.
std::string json_of(std::size_t event, const solve::SolveResult& result,
                    const solve::SolveQuestion* question) {
    std::string lines;
    for (const solve::Solution& each : result.solutions) {
        if (!each.is_solved) {
            continue;
        }
        JsonMembers one;
        one.add("event", static_cast<std::int64_t>(event));
        one.add("route", each.route);
        one.add("direction_deg", each.strike.direction.value_or(0) / kDegree);
        one.add(each.strike.ball_speed ? "ball_speed" : "speed",
                each.strike.ball_speed.value_or(each.strike.speed.value_or(0)));
        one.add("tip", {each.strike.tip.x, each.strike.tip.y});
        one.add("elevation_deg", each.strike.elevation / kDegree);
        one.add("window_deg", each.window_width() / kDegree);
        one.add("chance", each.chance);
        one.add("chance_error", each.chance_error);
        if (each.rest) {
            one.add("rest", {each.rest->x, each.rest->y});
        }
        one.add("simulations", static_cast<std::int64_t>(result.simulations));
        for (const auto& [title, value] : measured_values(question, each)) {
            one.add(title, value.value_or(0));
        }
        if (!result.is_complete) {
            one.add("complete", false);
        }
        lines += one.object() + "\n";
    }
    return lines;
}

/// What is found until the search ends or is interrupted.
class FoundSoFar {
  public:
    void add(std::size_t event, const solve::Solution& solution) {
        solve::SolveResult& result = results_[event];
        result.is_complete = false;
        const auto same =
            std::ranges::find(result.solutions, solution.route, &solve::Solution::route);
        if (same != result.solutions.end()) {
            *same = solution;
        } else {
            result.solutions.push_back(solution);
        }
    }
    /// The best ones first, as far as their chances are known.
    [[nodiscard]] std::map<std::size_t, solve::SolveResult> results() && {
        for (auto& [event, result] : results_) {
            std::ranges::stable_sort(result.solutions, std::greater<>(), &solve::Solution::chance);
        }
        return std::move(results_);
    }

  private:
    std::map<std::size_t, solve::SolveResult> results_;
};

std::string text_of(const SolveCommand& command, std::size_t event,
                    const solve::SolveResult& result, const solve::SolveQuestion* question) {
    return command.json ? json_of(event, result, question)
                        : text_of(event, result, question, command.lists_all);
}

/// The shot with its strikes; after an interruption what was found is printed, or taken.
ShotInput find_strikes(const SolveCommand& command, CommandContext& context) {
    FoundSoFar found;
    command.input.answers->takes_incomplete = true;
    command.input.answers->found = [&](std::size_t event, const solve::Solution& solution) {
        found.add(event, solution);
    };
    bool is_none_found = false;
    command.input.answers->none_found = [&] { is_none_found = true; };
    try {
        ShotInput input = read_shot_input(command.input, context.console, Subject::motion);
        context.console.end_progress();
        return input;
    } catch (const Stopped&) {
        context.console.end_progress();
        for (const auto& [event, result] : std::move(found).results()) {
            print_text(text_of(command, event, result, nullptr));
        }
        throw;
    } catch (const InputError& error) {
        if (is_none_found) {  // it is not the shot that is wrong
            throw Error(error.what());
        }
        throw;
    }
}

/// Writes the strikes into the shot's file, once it is sure that the text gives the same motion.
void write_into_shot(const SolveCommand& command, const ShotInput& input) {
    const std::string text = pipeline::solved_text(input.shot, *input.source);
    const pipeline::LoadResult written =
        pipeline::load_shot_text(text, command.input.path, load_options(command.input));
    if (!written.shot ||
        sim::physics_hash(written.shot->world) != sim::physics_hash(input.shot.world)) {
        throw Error("the strike cannot be written into '" + command.input.path +
                    "'; -o writes a new file");
    }
    write_text_output(command.input.path, text);
}

}  // namespace

void run(const SolveCommand& command, CommandContext& context) {
    if (is_sequence(command.input)) {
        throw InputError(
            "a film of several shots has no strike of its own; give one of those that "
            "'" +
            command.input.path + "' names");
    }
    if (is_bake(command.input)) {
        throw InputError("'" + command.input.path +
                         "' is a bake, whose strikes are done; give the shot");
    }
    if (!command.output.empty()) {
        check_output_folder(command.output);
    }
    for (const std::string& path : {command.map, command.plans}) {
        if (!path.empty()) {
            check_drawing_path(path, "a drawing");
        }
    }
    const ShotInput input = find_strikes(command, context);
    if (input.shot.solved.empty()) {
        throw InputError("'" + command.input.path +
                         "' has no 'solve', which says what the strike shall bring about "
                         "(docs/solving.md)");
    }
    std::string text;
    for (const pipeline::SolvedStrike& solved : input.shot.solved) {
        text += text_of(command, solved.event, *solved.result, solved.question.get());
    }
    print_text(text);
    const bool is_complete = std::ranges::all_of(
        input.shot.solved,
        [](const pipeline::SolvedStrike& solved) { return solved.result->is_complete; });
    const auto draw = [&](const std::string& path, auto make) {
        if (!path.empty()) {
            const std::string svg =
                make(input.shot, page_of(command.drawing.page, path),
                     pipeline::PartsWork{0, {progress_on(context.console, "draw"), context.stop}});
            context.console.end_progress();
            write_drawing({path, command.drawing.width}, svg);
        }
    };
    if (is_complete) {
        draw(command.map, pipeline::study::solve_map_svg);
        draw(command.plans, pipeline::study::solve_plans_svg);
    }
    if (!command.output.empty()) {
        write_text_output(command.output, input.shot.resolved_text);
    }
    if (command.writes) {
        write_into_shot(command, input);
    }
    if (!is_complete) {
        throw Stopped();
    }
}

}  // namespace carom::cli
