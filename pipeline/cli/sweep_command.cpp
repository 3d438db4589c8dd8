#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/source_set.h"
#include "pipeline/config/text.h"
#include "pipeline/study/sweep.h"
#include "pipeline/study/sweep_plot.h"

namespace carom::cli {

namespace {

namespace measures = pipeline::measures;
namespace study = pipeline::study;
using pipeline::config::quote;

constexpr std::size_t kMostVariants = 1'000'000;

/// A problem of an option's value.
pipeline::Problem problem_of(const std::string& option, const std::string& text,
                             const measures::TextProblem& wrong) {
    pipeline::config::SourceSet texts;
    const pipeline::config::Place place =
        texts.place_at(texts.add({option, "", text}), wrong.offset, wrong.length);
    return {
        pipeline::Severity::error, texts.describe(place), {}, wrong.sentence, texts.line_of(place)};
}

pipeline::Problem problem_of_key(const std::string& text, std::string sentence) {
    return problem_of("--vary", text,
                      {std::move(sentence), 0, std::min(text.find_first_of("=~"), text.size())});
}

/// Whether one of the keys is the other or above it.
bool overlap(const std::string& a, const std::string& b) {
    const std::string& longer = a.size() < b.size() ? b : a;
    const std::string& shorter = a.size() < b.size() ? a : b;
    return longer.starts_with(shorter) &&
           (longer.size() == shorter.size() || longer[shorter.size()] == '.' ||
            longer[shorter.size()] == '[');
}

/// Reads the options of the command into a sweep.
class SweepReader {
  public:
    SweepReader(const SweepCommand& command, const pipeline::ShotVariants& variants)
        : command_(command), variants_(variants) {}

    /// Reads all; `problems` gets what is wrong.
    study::Sweep read(std::vector<pipeline::Problem>& problems) {
        for (const std::string& text : command_.vary) {
            read_key(text, problems);
        }
        for (const std::string& text : command_.measures) {
            auto parsed = measures::parse_measure(text, variants_.own_world());
            if (const auto* wrong = std::get_if<measures::TextProblem>(&parsed)) {
                problems.push_back(problem_of("--measure", text, *wrong));
            } else {
                sweep_.measures.push_back(std::move(std::get<measures::Measure>(parsed)));
            }
        }
        if (problems.empty()) {
            read_samples(problems);
        }
        return std::move(sweep_);
    }

  private:
    void read_key(const std::string& text, std::vector<pipeline::Problem>& problems) {
        auto parsed = study::parse_varied(
            text, [&](const std::string& key) { return variants_.text_of(key); });
        if (const auto* wrong = std::get_if<measures::TextProblem>(&parsed)) {
            problems.push_back(problem_of("--vary", text, *wrong));
            return;
        }
        auto& key = std::get<study::VariedKey>(parsed);
        const auto other = std::ranges::find_if(sweep_.keys, [&](const study::VariedKey& known) {
            return overlap(known.key, key.key);
        });
        if (other != sweep_.keys.end()) {
            problems.push_back(problem_of_key(
                text, other->key == key.key
                          ? quote(key.key) + " is varied twice"
                          : quote(key.key) + " and " + quote(other->key) +
                                " are both varied, and one of them is a part of the other"));
            return;
        }
        if (!pipeline::can_change_motion(key.key)) {
            problems.push_back(problem_of_key(
                text, quote(key.key) + " does not change how the shot moves, so that all variants "
                                       "would be equal"));
            return;
        }
        sweep_.keys.push_back(std::move(key));
    }

    void read_samples(std::vector<pipeline::Problem>& problems) {
        const std::ptrdiff_t sampled = std::ranges::count_if(
            sweep_.keys, [](const study::VariedKey& key) { return key.is_sampled(); });
        if (!command_.samples) {
            for (std::size_t i = 0; i < sweep_.keys.size(); ++i) {
                if (sweep_.keys[i].is_sampled()) {
                    problems.push_back(problem_of_key(
                        command_.vary[i],
                        quote(sweep_.keys[i].key) +
                            (sweep_.keys[i].is_normal
                                 ? " has an error, which is sampled; --samples says how often"
                                 : " has no step: add one, such as ':0.5', or --samples")));
                }
            }
            return;
        }
        if (sampled == 0) {
            throw InputError(
                "--samples has nothing to sample: every --vary lists its values; a range without a "
                "step, or an error such as KEY~0.1, would be sampled");
        }
        sweep_.samples = static_cast<std::size_t>(*command_.samples);
        sweep_.sampling = command_.sampling == "latin"    ? study::Sampling::latin
                          : command_.sampling == "random" ? study::Sampling::random
                                                          : study::Sampling::sobol;
        sweep_.seed = static_cast<std::uint64_t>(command_.seed);
        if (sweep_.sampling == study::Sampling::sobol &&
            sampled > static_cast<std::ptrdiff_t>(study::kMostSobolDimensions)) {
            throw InputError(
                fmt::format("--sampling sobol has at most {} sampled keys; use latin or random",
                            study::kMostSobolDimensions));
        }
    }

    const SweepCommand& command_;
    const pipeline::ShotVariants& variants_;
    study::Sweep sweep_;
};

/// Reports the problems; throws InputError if there are any.
void require_none(const std::vector<pipeline::Problem>& problems, Console& console) {
    if (!problems.empty()) {
        report_problems(problems, console);
        throw InputError("the sweep has " + count_text(problems));
    }
}

std::string list_of_measures() {
    std::string text;
    for (const measures::MeasureInfo& info : measures::measure_list()) {
        const std::string name = std::string(info.name) + ":" + std::string(info.arguments);
        const std::string unit(info.unit.empty() ? "-" : info.unit);
        text += fmt::format("{:<28} {:<6} {}\n", name, unit, info.meaning);
    }
    return text;
}

void check_usage(const SweepCommand& command) {
    if (command.input.path.empty()) {
        throw InputError("the argument SHOT is missing");
    }
    if (command.vary.empty() || command.measures.empty()) {
        throw InputError(command.vary.empty()
                             ? "--vary is missing: it says which value is varied, as in --vary "
                               "'events[0].strike.speed=1..8 m/s:0.5'"
                             : "--measure is missing: it says what is measured; --measures lists "
                               "what there is");
    }
    const std::string ending = std::filesystem::path(command.output).extension().string();
    if (!command.output.empty() && command.output != "-" && ending != ".csv" &&
        ending != ".jsonl") {
        throw InputError("'" + command.output + "': a sweep can only be written as .csv or .jsonl");
    }
    check_output_folder(command.output);
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
}

study::Sweep read_sweep(const SweepCommand& command, const pipeline::ShotVariants& variants,
                        Console& console) {
    std::vector<pipeline::Problem> problems;
    study::Sweep sweep = SweepReader(command, variants).read(problems);
    require_none(problems, console);
    if (study::variant_count(sweep) > kMostVariants) {
        throw InputError(
            fmt::format("the sweep has more than {} variants; use larger steps", kMostVariants));
    }
    if (!command.plot.empty()) {
        const std::string problem = study::plot_problem(sweep);
        if (!problem.empty()) {
            throw InputError("--plot: " + problem);
        }
    }
    return sweep;
}

}  // namespace

void run(const SweepCommand& command, CommandContext& context) {
    if (command.lists_measures) {
        return print_text(list_of_measures());
    }
    check_usage(command);
    if (is_sequence(command.input)) {
        throw InputError("a sweep varies one shot; give one of those that '" + command.input.path +
                         "' names");
    }
    if (is_bake(command.input)) {
        throw InputError("'" + command.input.path +
                         "' is a bake, whose motion cannot be varied; give the shot");
    }
    Console& console = context.console;
    const ShotInput input = read_shot_input(command.input, console, Subject::motion);
    if (!input.shot.solved.empty()) {
        throw InputError("'" + command.input.path +
                         "' has 'solve', whose strike would be another one in each variant; write "
                         "the one to vary with 'carom solve " +
                         command.input.path + " -o SOLVED.yaml'");
    }
    const pipeline::ShotVariants variants(command.input.path, load_options(command.input),
                                          "--vary");
    const study::Sweep sweep = read_sweep(command, variants, console);
    require_none(
        study::find_problems(sweep, variants,
                             {command.threads, {progress_on(console, "check"), context.stop}}),
        console);
    const study::SweepTable table = study::run_sweep(
        sweep, variants, {command.threads, {progress_on(console, "sweep"), context.stop}});
    console.end_progress();
    if (table.unfinished > 0) {
        console.warning(counted(table.unfinished, "variant") +
                        " took too long to be simulated; their measures are empty");
    }
    if (table.warned > 0) {
        console.warning(fmt::format("the simulation warns of {}; the first: {}",
                                    counted(table.warned, "variant"), table.first_warning));
    }
    if (command.plot.empty() || !command.output.empty()) {
        const bool is_json = std::filesystem::path(command.output).extension() == ".jsonl";
        write_text_output(command.output.empty() ? "-" : command.output,
                          is_json ? study::json_lines_of(table) : study::csv_of(table));
    }
    if (!command.plot.empty()) {
        write_drawing({command.plot, command.drawing.width},
                      study::sweep_plot_svg(sweep, table, input.shot.name,
                                            page_of(command.drawing.page, command.plot)));
    }
    if (table.rows.size() < table.variants) {
        console.warning(
            fmt::format("{} of {} variants were simulated", table.rows.size(), table.variants));
        throw Stopped();
    }
}

}  // namespace carom::cli
