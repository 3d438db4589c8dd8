#include "pipeline/config/load_shot.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/camera/steady_up.h"
#include "pipeline/config/build/build_shot.h"
#include "pipeline/config/conditions.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/emit_yaml.h"
#include "pipeline/config/gather.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/repeat.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/config/text.h"

namespace carom::pipeline {

namespace fs = std::filesystem;
using namespace config;

namespace {

/// Each file once.
std::vector<sim::Asset> hash_assets(const std::vector<NamedFile>& files, const Node& root,
                                    Reader& reader) {
    std::vector<sim::Asset> assets;
    for (const NamedFile& file : files) {
        if (std::ranges::find(assets, file.path, &sim::Asset::path) != assets.end()) {
            continue;
        }
        try {
            assets.push_back({file.path, hash_file(file.path)});
        } catch (const Error& failure) {
            reader.error(root.place, failure.what());
        }
    }
    return assets;
}

/// The files among the texts, each once.
std::vector<ReadFile> files_of(const SourceSet& sources) {
    std::vector<ReadFile> files;
    for (int i = 0; i < sources.size(); ++i) {
        const SourceText& source = sources.at(i);
        const auto is_same = [&](const ReadFile& file) { return file.path == source.path; };
        if (!source.path.empty() && std::ranges::none_of(files, is_same)) {
            files.push_back({source.path, source.name});
        }
    }
    return files;
}

/// Builds the shot from the merged tree. After an error it is not complete.
Shot build_from(const Node& root, const ShotFile& file, const std::string& name, Reader& reader,
                const BuildAids& aids, std::vector<FoundStrike>& found) {
    try {
        Shot shot = build_shot(file, root, name, reader, aids, found);
        shot.moments = reader.moments();
        return shot;
    } catch (const Stopped&) {  // the search for a strike
        throw;
    } catch (const Error& failure) {  // geometry that the checks of single keys accept
        reader.error(root.place, failure.what());
        return {};
    }
}

ShotFile read_sections(const Node& root, Reader& reader) {
    ShotFile file;
    reader.set_root_place(root.place);
    shot_spec().read(reader, root, file);
    return file;
}

/// Gives the strikes in the tree the directions that were found, instead of their aims. Returns the
/// aims by these directions.
ShotSource::Notes write_directions(Node& root, const std::vector<sim::FoundDirection>& found) {
    ShotSource::Notes notes;
    for (const sim::FoundDirection& direction : found) {
        Node& strike = root.find("events")->value.items[direction.event].find("strike")->value;
        Node aim;
        aim.kind = Node::Kind::map;
        const auto is_of_aim = [](const Entry& entry) {
            return std::ranges::count(aim_keys(), entry.key) != 0;
        };
        const auto first = std::ranges::find_if(strike.entries, is_of_aim);
        std::ranges::copy_if(first, strike.entries.end(), std::back_inserter(aim.entries),
                             is_of_aim);
        first->key = "direction";
        strike.entries.erase(std::remove_if(first + 1, strike.entries.end(), is_of_aim),
                             strike.entries.end());
        Node& value = strike.find("direction")->value;
        const Place place = value.place;
        value = Node{};
        value.kind = Node::Kind::scalar;
        value.place = place;
        value.text = decimal_text(static_cast<double>(direction.microdegrees) / 1e6, 6) + " deg";
        notes[&value] = emit_flow(aim);
    }
    return notes;
}

/// Reads the merged tree; empty after an error. `is_whole`: false if a file is missing or an object
/// could not be repeated, which was reported, so that references must not be checked.
std::optional<Shot> read_shot(const Node& root, bool is_whole, const std::string& name,
                              Reader& reader, const BuildAids& aids,
                              const std::vector<OpenStrike>& open,
                              std::vector<FoundStrike>& found) {
    ShotFile file = read_sections(root, reader);
    file.open = open;
    if (!is_whole) {
        return std::nullopt;
    }
    Shot shot = build_from(root, file, name, reader, aids, found);
    if (!reader.has_error()) {
        shot.assets = hash_assets(reader.named_files(), root, reader);
    }
    return reader.has_error() ? std::nullopt : std::optional(std::move(shot));
}

}  // namespace

LoadResult load_shot_text(const std::string& text, const std::string& origin,
                          const LoadOptions& options) {
    SourceSet sources;
    ProblemList problems(sources);
    LoadResult result;
    ConfigFolders folders = config_folders_of(origin);
    folders.root = options.root;
    folders.texts = options.texts;
    folders.most_asset_bytes = options.most_asset_bytes;
    folders.missing = &result.missing;
    const int source = sources.add(text_of_shot(text, origin));
    Gathered gathered = gather(sources, source, folders,
                               {.own = options.own,
                                .overrides = options.overrides,
                                .quality = options.quality,
                                .camera_file = options.camera_file},
                               problems);
    std::shared_ptr<const Node> root;
    ShotSource::Replaced replaced;
    ShotSource::Notes notes;
    if (gathered.root) {
        const bool has_all_objects =
            repeat_objects(*gathered.root, sources, folders, problems, !gathered.is_complete);
        apply_conditions(*gathered.root, sources, folders, problems, !gathered.is_complete);
        Reader reader(sources, folders, problems);
        reader.set_partial(!gathered.is_complete);
        const std::vector<OpenStrike> open = open_strikes(*gathered.root);
        std::vector<FoundStrike> found;
        const auto tree = std::make_shared<Node>(std::move(*gathered.root));
        root = tree;
        result.shot = read_shot(*tree, gathered.is_complete && has_all_objects,
                                fs::path(origin).stem().string(), reader,
                                {options.tables, options.answers}, open, found);
        if (result.shot) {
            write_found(*tree, found);
            notes = write_directions(*tree, result.shot->found_directions);
            result.shot->resolved_text = emit_yaml(*tree, reader.replaced());
        }
        replaced = reader.replaced();
        result.named_files = reader.named_files();
    }
    if (problems.has_error()) {
        result.shot.reset();
    }
    result.problems = problems.take();
    result.files = files_of(sources);
    if (result.shot) {
        result.source = std::make_shared<ShotSource>(
            std::make_shared<const SourceSet>(std::move(sources)), std::move(root),
            std::move(replaced), result.problems, std::move(notes));
    }
    return result;
}

namespace {

bool is_same(const Problem& a, const Problem& b) {
    return a.message == b.message && a.place.file == b.place.file && a.place.line == b.place.line &&
           a.place.column == b.place.column;
}

/// The problems that were not found when the motion was not known.
std::vector<Problem> new_problems(ProblemList& problems, const ShotSource& source) {
    std::vector<Problem> found = problems.take();
    std::erase_if(found, [&](const Problem& problem) {
        return std::ranges::any_of(source.problems(),
                                   [&](const Problem& before) { return is_same(problem, before); });
    });
    return found;
}

/// "cameras[2]" for "cameras[2].scene[0]".
std::string element_of(const std::string& key_path) {
    return key_path.substr(0, key_path.find('.'));
}

/// Removes the cameras of these paths ("cameras[2]") from the shot, and from the tree, so that the
/// others' numbers remain those of their places.
Node without_cameras(const std::set<std::string>& paths, Node root, Shot& shot) {
    Entry* cameras = root.find("cameras");
    for (std::size_t i = shot.cameras.size(); i-- > 0;) {
        if (cameras != nullptr && i < cameras->value.items.size() &&
            paths.contains("cameras[" + std::to_string(i) + "]")) {
            const auto at = static_cast<std::ptrdiff_t>(i);
            shot.cameras.erase(shot.cameras.begin() + at);
            cameras->value.items.erase(cameras->value.items.begin() + at);
        }
    }
    return root;
}

}  // namespace

std::string solved_text(const Shot& shot, const ShotSource& source) {
    std::vector<FoundStrike> found;
    for (const SolvedStrike& each : shot.solved) {
        found.push_back({each.event, each.values});
    }
    return text_with_found(source.sources().at(0).text, source.root(), found);
}

bool has_open_moments(const Shot& shot) {
    return std::ranges::any_of(shot.moments,
                               [](const ShotMoment& moment) { return !moment.time.has_value(); });
}

std::vector<Problem> resolve_moments(Shot& shot, std::shared_ptr<const ShotSource>& source,
                                     const sim::Timeline& timeline,
                                     sim::billiards::TableMemo* tables) {
    if (!has_open_moments(shot)) {
        keep_up(shot.cameras, timeline);
        return {};
    }
    ProblemList problems(source->sources());
    const ConfigFolders folders = config_folders_of(source->sources().at(0).name);
    const KnownMotion motion{&timeline, &shot.world};
    Reader reader(source->sources(), folders, problems, &motion);
    std::vector<FoundStrike> none;  // the tree has what was found
    std::optional<Shot> known =
        read_shot(source->root(), true, shot.name, reader, {tables, nullptr}, {}, none);
    std::vector<Problem> found = new_problems(problems, *source);
    if (known) {
        shot.cameras = std::move(known->cameras);
        keep_up(shot.cameras, timeline);
        shot.annotations = std::move(known->annotations);
        shot.moments = std::move(known->moments);
        shot.resolved_text = emit_yaml(source->root(), reader.replaced());
        source = std::make_shared<const ShotSource>(source->with_replaced(reader.replaced()));
    }
    return found;
}

namespace {

/// What cannot be shown, because it needs a moment that never comes: "cameras[2]".
std::set<std::string> elements_without_time(const std::vector<ShotMoment>& moments) {
    std::set<std::string> elements;
    for (const ShotMoment& moment : moments) {
        if (!moment.time) {
            elements.insert(element_of(moment.key_path));
        }
    }
    return elements;
}

/// Errors become warnings, and their elements are `faulty`, too. Of what is faulty already they are
/// removed: without its moment it may seem to have other faults.
void make_warnings(std::vector<Problem>& problems, std::set<std::string>& faulty) {
    std::erase_if(problems, [&](const Problem& problem) {
        return problem.severity == Severity::error && faulty.contains(element_of(problem.key_path));
    });
    for (Problem& problem : problems) {
        if (problem.severity == Severity::error) {
            problem.severity = Severity::warning;
            faulty.insert(element_of(problem.key_path));
        }
    }
}

}  // namespace

std::vector<Problem> resolve_known_moments(Shot& shot, std::shared_ptr<const ShotSource>& source,
                                           const sim::Timeline& timeline) {
    std::vector<Problem> found = resolve_moments(shot, source, timeline);
    if (!has_open_moments(shot)) {
        return found;
    }
    ProblemList problems(source->sources());
    const ConfigFolders folders = config_folders_of(source->sources().at(0).name);
    const KnownMotion motion{&timeline, &shot.world, true};
    Reader reader(source->sources(), folders, problems, &motion);
    const ShotFile file = read_sections(source->root(), reader);
    std::vector<FoundStrike> none;  // the tree has the strikes that were found
    Shot known = build_from(source->root(), file, shot.name, reader, {}, none);
    std::set<std::string> faulty = elements_without_time(reader.moments());
    found = new_problems(problems, *source);
    make_warnings(found, faulty);
    shot.cameras = std::move(known.cameras);
    shot.annotations = std::move(known.annotations);
    shot.moments = reader.moments();
    source = std::make_shared<const ShotSource>(source->with_root(
        std::make_shared<const Node>(without_cameras(faulty, source->root(), shot))));
    return found;
}

namespace {

/// The problem of a folder that was given as a shot, with a file in it that may be meant.
std::string folder_problem(const std::string& path) {
    std::vector<std::string> shots;
    std::error_code code;
    for (fs::directory_iterator entry(path, code), end; !code && entry != end;
         entry.increment(code)) {
        if (entry->path().extension() == ".yaml") {
            shots.push_back(entry->path().string());
        }
    }
    const auto first = std::ranges::min_element(shots);
    return "this is a folder, not a shot file" +
           (first == shots.end() ? "" : "; it contains " + quote(*first));
}

}  // namespace

LoadResult load_shot(const std::string& path, const LoadOptions& options) {
    std::string text;
    ConfigFolders folders;
    folders.texts = options.texts;
    if (!read_config_text(path, YamlLimits{}.bytes, folders, text)) {
        Problem problem;
        problem.place.file = path;
        std::error_code ignored;
        problem.message =
            fs::is_directory(path, ignored) ? folder_problem(path) : "the file " + text;
        return {std::nullopt, {problem}, nullptr, {}};
    }
    return load_shot_text(text, path, options);
}

}  // namespace carom::pipeline
