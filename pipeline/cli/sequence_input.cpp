#include "pipeline/cli/sequence_input.h"

#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "core/printable.h"
#include "core/text.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/plan/plan_svg.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

namespace fs = std::filesystem;
using pipeline::Sequence;
using pipeline::SequencePart;
using pipeline::ShotPart;

pipeline::SequenceResult load_sequence_input(const InputOptions& input,
                                             const std::string& folder_of_shots) {
    if (!input.camera_file.empty()) {
        throw InputError("--camera replaces the cameras of one shot, but '" + input.path +
                         "' is a film of several");
    }
    return pipeline::load_sequence(input.path,
                                   {.overrides = input.overrides,
                                    .quality = input.quality,
                                    .root = input.root,
                                    .texts = input.texts.get()},
                                   folder_of_shots);
}

Sequence read_sequence_input(const InputOptions& input, Console& console,
                             const std::string& folder_of_shots) {
    return require_sequence(load_sequence_input(input, folder_of_shots), input, console);
}

Sequence require_sequence(pipeline::SequenceResult loaded, const InputOptions& input,
                          Console& console) {
    report_problems(loaded.problems, console);
    if (!loaded.sequence) {
        throw InputError("'" + input.path + "' has " + count_text(loaded.problems));
    }
    return std::move(*loaded.sequence);
}

ShotInput input_of(ShotPart& part) {
    ShotInput input;
    input.shot = std::move(part.shot);
    input.source = part.source;
    if (part.bake) {
        input.bake = *part.bake;
    }
    return input;
}

void take_back(ShotInput input, ShotPart& part) {
    part.shot = std::move(input.shot);
    part.source = std::move(input.source);
}

std::string part_name(std::size_t index, const ShotPart& part) {
    return fmt::format("part {}, ", index + 1) + fs::path(part.path).filename().string();
}

namespace {

std::string line(const std::string& name, const std::string& value) {
    return fmt::format("{:<12}{}\n", name, printable(value));
}

std::string part_line(const Sequence& sequence, std::size_t index) {
    const SequencePart& part = sequence.parts[index];
    const double fps = sequence.fps.to_double();
    const std::int64_t start = sequence.starts()[index];
    const auto seconds = [&](std::int64_t frame) {
        return decimal_text(static_cast<double>(frame) / fps, 4) + " s";
    };
    std::string what;
    if (const auto* shot = std::get_if<ShotPart>(&part.content)) {
        what = shot->path + ", its film from " + seconds(shot->first) + " to " +
               seconds(shot->first + part.frames);
    } else {
        what = "title '" + std::get<pipeline::TitleCard>(part.content).text + "'";
    }
    return seconds(start) + " to " + seconds(start + part.frames) + ": " + what +
           (part.fade > 0 ? ", fades in for " + seconds(part.fade) : "");
}

}  // namespace

std::string sequence_summary(const Sequence& sequence) {
    const std::int64_t frames = sequence.frames();
    std::string text =
        line("film", sequence.name) +
        line("length",
             fmt::format("{} frames, {} per second, {} s, {}x{}, ", frames,
                         decimal_text(sequence.fps.to_double(), 6),
                         decimal_text(static_cast<double>(frames) / sequence.fps.to_double(), 4),
                         sequence.width, sequence.height) +
                 pipeline::default_extension(sequence.output));
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        text += line(i == 0 ? "parts" : "", part_line(sequence, i));
    }
    return text;
}

void plan_sequence(const PlanCommand& command, CommandContext& context) {
    const fs::path path(output_or_default(command.output, command.input.path, ".svg"));
    check_drawing_path(path.string(), "a plan");
    Sequence sequence = read_sequence_input(command.input, context.console);
    int page = 0;
    for (SequencePart& part : sequence.parts) {
        auto* shot = std::get_if<ShotPart>(&part.content);
        if (shot == nullptr) {
            continue;
        }
        ShotInput input = input_of(*shot);
        const sim::Timeline timeline = obtain_bake(input, InputOptions{shot->path, {}, {}, {}, {}},
                                                   command.cache, context, Subject::plan)
                                           .timeline;
        const fs::path file = path.parent_path() / fmt::format("{}-{}{}", path.stem().string(),
                                                               ++page, path.extension().string());
        write_drawing({file.string(), command.drawing.width},
                      pipeline::plan_svg(input.shot, timeline,
                                         {page_of(command.drawing.page, file.string())}));
    }
}

}  // namespace carom::cli
