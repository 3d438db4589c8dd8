#include "pipeline/cli/named_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "core/printable.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/check/file_check.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/config/find_place.h"

namespace carom::cli {
namespace {

using pipeline::FileKind;
using pipeline::NamedFile;
using pipeline::Problem;

bool uses_ocio(const pipeline::OutputSettings& output) {
    return output.view == pipeline::ViewTransform::ocio && !output.hdr10;
}

/// Reads the sound to its end.
void play(const sound::SampleReader& read) {
    std::array<double, 4096> left{};
    std::array<double, 4096> right{};
    while (read(left, right) > 0) {
    }
}

/// `seconds`: the length of the film.
pipeline::FileReport report_of(std::span<const NamedFile> files, FileReading reading,
                               double seconds, const CommandContext& context) {
    pipeline::FileCheckOptions options;
    if (reading == FileReading::full) {
        options.most_bytes = std::numeric_limits<std::uintmax_t>::max();
    }
    if (context.music != nullptr) {
        options.try_music = [&context, seconds](const std::string& path) {
            pipeline::MusicSettings settings;
            settings.file = path;
            const auto samples = static_cast<std::int64_t>(seconds * sound::kSampleRate);
            play(context.music(settings, samples)());
        };
    }
    return pipeline::FileChecker().check(files, options);
}

bool has_music(std::span<const NamedFile> files) {
    return std::ranges::find(files, FileKind::music, &NamedFile::kind) != files.end();
}

std::string by_header_text(const std::vector<NamedFile>& files) {
    std::string names;
    for (const NamedFile& file : files) {
        std::error_code ignored;
        constexpr double kMegabyte = 1e6;
        const auto bytes = static_cast<double>(std::filesystem::file_size(file.path, ignored));
        names += fmt::format("{}'{}' ({:.0f} MB)", names.empty() ? "" : ", ", printable(file.path),
                             bytes / kMegabyte);
    }
    return names.empty()
               ? ""
               : "of large files only the headers were checked; --full reads all of " + names;
}

void append(std::vector<Problem>& problems, std::vector<Problem> more) {
    std::move(more.begin(), more.end(), std::back_inserter(problems));
}

/// The problem of a view by OpenColorIO; nothing if there is none.
void try_view(const ShotInput& input, const CommandContext& context,
              std::vector<Problem>& problems) {
    if (!uses_ocio(input.shot.output)) {
        return;
    }
    try {
        context.view(input.shot.output);
    } catch (const Error& failure) {
        const pipeline::config::Node& root = input.source->root();
        const pipeline::config::Entry* output = root.find("output");
        const bool has_names = output != nullptr && output->value.find("ocio") != nullptr;
        problems.push_back(input.source->problem_at({"output", has_names ? "ocio" : "view"},
                                                    pipeline::Severity::error, failure.what()));
    }
}

}  // namespace

void require_film_program(bool is_needed, const CommandContext& context) {
    if (is_needed && context.music == nullptr) {
        throw NeedsProgram("carom-film");
    }
}

std::string check_files(CheckedInput& checked, FileReading reading, const CommandContext& context) {
    if (reading == FileReading::none) {
        return {};
    }
    constexpr double kLongest = 3600;  // s, of music if the film is not known
    double seconds = kLongest;
    if (checked.input) {
        const pipeline::Shot& shot = checked.input->shot;
        seconds = static_cast<double>(pipeline::frame_count(shot.cameras, shot.timing)) /
                  shot.timing.fps.to_double();
    }
    require_film_program(
        has_music(checked.files) || (checked.input && uses_ocio(checked.input->shot.output)),
        context);
    pipeline::FileReport report = report_of(checked.files, reading, seconds, context);
    if (checked.input) {
        try_view(*checked.input, context, report.problems);
    }
    append(checked.problems, std::move(report.problems));
    if (pipeline::has_errors(checked.problems)) {
        checked.input.reset();
    }
    return by_header_text(report.read_by_header);
}

std::string check_files(pipeline::SequenceResult& loaded, FileReading reading,
                        const CommandContext& context) {
    if (reading == FileReading::none) {
        return {};
    }
    constexpr double kLongest = 3600;  // s
    const double seconds = loaded.sequence ? static_cast<double>(loaded.sequence->frames()) /
                                                 loaded.sequence->fps.to_double()
                                           : kLongest;
    require_film_program(
        has_music(loaded.named_files) || (loaded.sequence && uses_ocio(loaded.sequence->output)),
        context);
    pipeline::FileReport report = report_of(loaded.named_files, reading, seconds, context);
    append(loaded.problems, std::move(report.problems));
    if (loaded.sequence && uses_ocio(loaded.sequence->output)) {
        try {
            context.view(loaded.sequence->output);
        } catch (const Error& failure) {
            Problem problem = loaded.output_place;
            problem.message = failure.what();
            loaded.problems.push_back(std::move(problem));
        }
    }
    if (pipeline::has_errors(loaded.problems)) {
        loaded.sequence.reset();
    }
    return by_header_text(report.read_by_header);
}

ShotInput read_checked_input(const InputOptions& input, FileReading reading,
                             CommandContext& context, Subject subject) {
    CheckedInput checked = load_shot_input(input);
    check_files(checked, reading, context);
    return require_shot_input(std::move(checked), input, context.console, subject);
}

pipeline::Sequence read_checked_sequence(const InputOptions& input, FileReading reading,
                                         CommandContext& context) {
    pipeline::SequenceResult loaded = load_sequence_input(input);
    check_files(loaded, reading, context);
    return require_sequence(std::move(loaded), input, context.console);
}

}  // namespace carom::cli
