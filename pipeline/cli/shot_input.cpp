#include "pipeline/cli/shot_input.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/config/bake_shot.h"
#include "pipeline/sequence/load_sequence.h"

namespace carom::cli {

namespace {

/// A problem in the format of a compiler, with the severity in colour.
std::string text_of(const pipeline::Problem& problem, const Console& console) {
    const std::string word = problem.severity == pipeline::Severity::error
                                 ? console.error_word("error:")
                                 : console.warning_word("warning:");
    return (problem.place.file.empty() ? "carom: " : "") + format(problem, word);
}

/// What was read from standard input; nullptr if the shot is a file.
const std::string* piped(const InputOptions& input) {
    return input.texts ? &input.texts->begin()->second : nullptr;
}

/// The shot in a bake, with the options applied. They may change the look but not the physics.
pipeline::LoadResult load_shot_of_bake(const sim::Bake& bake, const InputOptions& input) {
    const pipeline::LoadOptions options = load_options(input);
    pipeline::LoadResult loaded = pipeline::load_bake_shot(bake, input.path, options);
    if (loaded.shot && pipeline::changes_physics(bake, *loaded.shot, input.path, options)) {
        throw InputError("'" + input.path +
                         "' is a bake: --set cannot change its physics; change the shot and bake "
                         "it again");
    }
    return loaded;
}

/// The file to correct, in quotes: the input, or the camera file if it has all errors.
std::string faulty_file(const InputOptions& input, const std::vector<pipeline::Problem>& problems) {
    const auto is_elsewhere = [&](const pipeline::Problem& problem) {
        return problem.severity == pipeline::Severity::error &&
               problem.place.file != input.camera_file;
    };
    const bool is_camera_file =
        !input.camera_file.empty() && std::none_of(problems.begin(), problems.end(), is_elsewhere);
    return "'" + (is_camera_file ? input.camera_file : input.path) + "'";
}

/// Whether it is a warning about what only pictures and sound have.
bool is_picture_warning(const pipeline::Problem& problem) {
    constexpr std::array<std::string_view, 7> kSections{
        "annotations", "cameras", "lights", "materials", "output", "render", "sound"};
    const std::string_view section =
        std::string_view(problem.key_path).substr(0, problem.key_path.find_first_of(".["));
    return problem.severity == pipeline::Severity::warning &&
           std::ranges::find(kSections, section) != kSections.end();
}

}  // namespace

pipeline::LoadOptions load_options(const InputOptions& input) {
    return {.overrides = input.overrides,
            .quality = input.quality,
            .camera_file = input.camera_file,
            .root = input.root,
            .texts = input.texts.get(),
            .answers = input.answers.get()};
}

bool is_bake(const InputOptions& input) {
    const auto is_head = [](std::string_view bytes) {
        return sim::has_bake_identifier(std::as_bytes(std::span(bytes)));
    };
    if (const std::string* bytes = piped(input)) {
        return is_head(*bytes);
    }
    if (std::filesystem::path(input.path).extension() == ".bake") {
        return true;
    }
    // Opening a pipe would block until another process writes to it.
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(input.path, ignored)) {
        return false;
    }
    std::array<char, sim::kBakeHeadBytes> head{};
    std::ifstream file(input.path, std::ios::binary);
    return file.read(head.data(), head.size()) && is_head({head.data(), head.size()});
}

bool is_sequence(const InputOptions& input) {
    return pipeline::is_sequence_file(input.path, input.texts.get());
}

sim::Bake read_bake_input(const InputOptions& input) {
    try {
        const std::string* bytes = piped(input);
        return bytes != nullptr ? sim::decode_bake(std::as_bytes(std::span(*bytes)), input.path)
                                : sim::read_bake(input.path);
    } catch (const Error& error) {
        throw InputError(error.what());
    }
}

CheckedInput load_shot_input(const InputOptions& input) {
    ShotInput result;
    pipeline::LoadResult loaded;
    if (is_bake(input)) {
        result.bake = read_bake_input(input);
        loaded = load_shot_of_bake(*result.bake, input);
    } else {
        loaded = pipeline::load_shot(input.path, load_options(input));
    }
    CheckedInput checked{std::move(loaded.problems), {}, std::move(loaded.named_files)};
    if (loaded.shot) {
        result.shot = std::move(*loaded.shot);
        result.source = std::move(loaded.source);
        checked.input = std::move(result);
    }
    return checked;
}

ShotInput require_shot_input(CheckedInput checked, const InputOptions& input, Console& console,
                             Subject subject) {
    if (subject == Subject::motion) {
        std::erase_if(checked.problems, is_picture_warning);
    }
    report_problems(checked.problems, console);
    if (!checked.input) {
        throw InputError(faulty_file(input, checked.problems) + " has " +
                         count_text(checked.problems));
    }
    return std::move(*checked.input);
}

ShotInput read_shot_input(const InputOptions& input, Console& console, Subject subject) {
    return require_shot_input(load_shot_input(input), input, console, subject);
}

JsonMembers members_of(const pipeline::Problem& problem) {
    const pipeline::SourcePlace& place = problem.place;
    JsonMembers members;
    members.add("severity", problem.severity == pipeline::Severity::error ? "error" : "warning")
        .add("file", place.file)
        .add("line", place.line)
        .add("column", place.column)
        .add("end_column", place.column + place.length)
        .add("key", problem.key_path)
        .add("message", problem.message);
    if (!problem.suggestion.empty()) {
        members.add("suggestion", problem.suggestion);
    }
    std::string trail;  // innermost first
    for (const pipeline::SourcePlace& by : problem.included_by) {
        trail += (trail.empty() ? "" : " ") + by.file +
                 (by.line > 0 ? fmt::format(":{}:{}", by.line, by.column) : "");
    }
    if (!trail.empty()) {
        members.add("included_by", trail);
    }
    return members;
}

void report_problems(const std::vector<pipeline::Problem>& problems, Console& console,
                     bool is_asked) {
    for (const pipeline::Problem& problem : problems) {
        console.event("problem", members_of(problem), text_of(problem, console),
                      is_asked || problem.severity == pipeline::Severity::error);
    }
}

std::string count_text(const std::vector<pipeline::Problem>& problems) {
    const std::ptrdiff_t errors =
        std::count_if(problems.begin(), problems.end(), [](const pipeline::Problem& problem) {
            return problem.severity == pipeline::Severity::error;
        });
    const std::ptrdiff_t warnings = std::ssize(problems) - errors;
    std::string text;
    if (errors > 0) {
        text += counted(errors, "error");
    }
    if (warnings > 0) {
        text += (text.empty() ? "" : " and ") + counted(warnings, "warning");
    }
    return text;
}

}  // namespace carom::cli
