#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/named_files.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/report_filter.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/export/scene_glb.h"
#include "pipeline/export/scene_usda.h"
#include "pipeline/export/timeline_csv.h"
#include "pipeline/export/timeline_json.h"
#include "pipeline/sequence/load_sequence.h"

namespace carom::cli {

namespace {

enum class Format { csv, json, glb, usda };

Format format_of(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    if (path == "-" || extension == ".csv") {
        return Format::csv;
    }
    if (extension == ".json") {
        return Format::json;
    }
    if (extension == ".glb") {
        return Format::glb;
    }
    if (extension == ".usda") {
        return Format::usda;
    }
    throw InputError("'" + path + "': an export can only be written as .csv, .json, .glb or .usda");
}

/// `shot` is empty if only tables of a bake are written, which do not need the shot.
struct Source {
    std::optional<pipeline::Shot> shot;
    sim::Timeline timeline;
};

Source read_source(const ExportCommand& command, bool shot_wanted, CommandContext& context) {
    if (!shot_wanted && is_bake(command.input)) {
        return {std::nullopt, read_timeline_of_bake(command.input, context.console)};
    }
    ShotInput input =
        read_checked_input(command.input, FileReading::usual, context, Subject::motion);
    sim::Timeline timeline =
        obtain_bake(input, command.input, command.cache, context, Subject::motion).timeline;
    return {std::move(input.shot), std::move(timeline)};
}

/// Throws InputError if two tables would be written to the same file.
void check_different(const std::string& path, const std::string& other, const char* contents) {
    if (!path.empty() && path == other) {
        throw InputError("'" + path + "' cannot contain both " + contents + "; give two files");
    }
}

/// Throws InputError if a word names no part.
pipeline::JsonParts json_parts(const ExportCommand& command) {
    const std::vector<std::string> names = pipeline::json_part_names();
    const std::vector<std::string> only = words_of("--only", command.only, names);
    const std::vector<std::string> without = words_of("--without", command.without, names);
    const auto has = [](const std::vector<std::string>& words, const char* name) {
        return std::ranges::find(words, name) != words.end();
    };
    pipeline::JsonParts parts;
    for (const pipeline::JsonPart& part : pipeline::kJsonParts) {
        parts.*part.wanted = (only.empty() || has(only, part.name)) && !has(without, part.name);
    }
    parts.objects = parts.objects || (parts.meshes && has(only, "meshes"));
    return parts;
}

/// A file and those that belong to it.
struct Output {
    std::string text;
    std::vector<pipeline::CompanionFile> companions;
};

Output tracks_output(const Source& source, Format format, const ExportCommand& command,
                     const pipeline::JsonParts& parts, const std::string& path) {
    const sim::Timeline& timeline = source.timeline;
    if (format == Format::csv) {
        return {command.rate ? pipeline::samples_to_csv(timeline, *command.rate)
                             : pipeline::keys_to_csv(timeline),
                {}};
    }
    const pipeline::ExportScene scene = pipeline::export_scene(*source.shot, timeline);
    if (format == Format::usda) {
        pipeline::UsdaFiles files = pipeline::scene_to_usda(scene, path);
        return {std::move(files.text), std::move(files.pictures)};
    }
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return {format == Format::json ? pipeline::timeline_json(*source.shot, timeline, scene,
                                                             command.rate, folder, parts)
                                   : pipeline::scene_to_glb(scene),
            {}};
}

/// Writes the files that belong to `path` into folders beside it. All are complete before the first
/// gets its name.
void write_companions(const std::string& path,
                      const std::vector<pipeline::CompanionFile>& companions) {
    namespace fs = std::filesystem;
    std::vector<std::unique_ptr<AtomicWriter>> writers;
    for (const pipeline::CompanionFile& file : companions) {
        const fs::path place = fs::path(path).parent_path() / file.name;
        std::error_code error;
        fs::create_directories(place.parent_path(), error);
        if (error) {
            throw Error("cannot make the folder '" + place.parent_path().string() +
                        "': " + error.message());
        }
        writers.push_back(std::make_unique<AtomicWriter>(place.string()));
        writers.back()->write(file.bytes);
    }
    for (const std::unique_ptr<AtomicWriter>& writer : writers) {
        writer->finish();
    }
}

/// Says of what a large file consists, if nothing was left out.
void advise_on_size(const ExportCommand& command, const std::string& text, Console& console) {
    constexpr std::size_t kLarge = 1'000'000;  // bytes
    if (text.size() > kLarge && command.only.empty() && command.without.empty()) {
        console.info(fmt::format(
            "'{}' has {:.1f} MB; --without meshes,energy or --only tracks,events leave parts out",
            command.output, static_cast<double>(text.size()) / 1e6));
    }
}

}  // namespace

void run(const ExportCommand& command, CommandContext& context) {
    if (is_sequence(command.input)) {
        throw InputError("'" + command.input.path +
                         "' is a film of several shots; export one of those that it names");
    }
    // With --events or --contacts and without -o only those tables are written.
    const bool tracks_wanted =
        !command.output.empty() || (command.events.empty() && command.contacts.empty());
    const std::string path = output_or_default(command.output, command.input.path, ".csv");
    const Format format = tracks_wanted ? format_of(path) : Format::csv;
    if (tracks_wanted) {
        check_different(path, command.events, "the tracks and the events");
        check_different(path, command.contacts, "the tracks and the lasting contacts");
        if (command.rate && (format == Format::glb || format == Format::usda)) {
            throw InputError("'" + path +
                             "' has as many keys as it needs; --rate is only for .csv and .json");
        }
        check_output_folder(path);
    }
    if (format != Format::json && !(command.only.empty() && command.without.empty())) {
        throw InputError("--only and --without leave out parts of a .json");
    }
    const pipeline::JsonParts parts = json_parts(command);
    check_different(command.events, command.contacts, "the events and the lasting contacts");
    check_output_folder(command.events);
    check_output_folder(command.contacts);

    const Source source = read_source(command, format != Format::csv, context);
    if (tracks_wanted) {
        const Output output = tracks_output(source, format, command, parts, path);
        write_companions(path, output.companions);
        write_text_output(path, output.text);
        if (format == Format::json) {
            advise_on_size(command, output.text, context.console);
        }
    }
    if (!command.events.empty()) {
        write_text_output(command.events, pipeline::events_to_csv(source.timeline));
    }
    if (!command.contacts.empty()) {
        write_text_output(command.contacts, pipeline::contacts_to_csv(source.timeline));
    }
}

}  // namespace carom::cli
