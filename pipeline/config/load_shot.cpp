#include "pipeline/config/load_shot.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.h"
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

/// The absolute path of the file with the shot's text, which need not exist.
std::string absolute_path(const std::string& origin) {
    std::error_code code;
    const fs::path path = fs::weakly_canonical(origin, code);
    return code ? std::string() : path.string();
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

std::string absolute_folder(const std::string& origin) {
    std::error_code code;
    const fs::path absolute = fs::absolute(origin, code);
    return code ? "." : absolute.lexically_normal().parent_path().string();
}

/// Reads the merged tree; empty after an error. `is_whole`: false if a file is missing or an object
/// could not be repeated, which was reported, so that references must not be checked.
std::optional<Shot> read_shot(const Node& root, bool is_whole, const std::string& name,
                              Reader& reader, sim::billiards::TableMemo* tables) {
    ShotFile file;
    reader.set_root_place(root.place);
    shot_spec().read(reader, root, file);
    if (!is_whole) {
        return std::nullopt;
    }
    Shot shot;
    try {
        shot = build_shot(file, root, name, reader, tables);
    } catch (const Error& failure) {  // geometry that the checks of single keys accept
        reader.error(root.place, failure.what());
    }
    if (!reader.has_error()) {
        shot.assets = hash_assets(reader.named_files(), root, reader);
        shot.moments = reader.moments();
        shot.resolved_text = emit_yaml(root, reader.replaced());
    }
    return reader.has_error() ? std::nullopt : std::optional(std::move(shot));
}

}  // namespace

LoadResult load_shot_text(const std::string& text, const std::string& origin,
                          const LoadOptions& options) {
    SourceSet sources;
    ProblemList problems(sources);
    LoadResult result;
    ConfigFolders folders = standard_config_folders();
    folders.root = options.root;
    folders.texts = options.texts;
    folders.most_asset_bytes = options.most_asset_bytes;
    folders.missing = &result.missing;
    const int source =
        sources.add({origin, absolute_folder(origin), text, {}, absolute_path(origin)});
    Gathered gathered = gather(sources, source, folders,
                               {.own = options.own,
                                .overrides = options.overrides,
                                .quality = options.quality,
                                .camera_file = options.camera_file},
                               problems);
    std::shared_ptr<const Node> root;
    ShotSource::Replaced replaced;
    if (gathered.root) {
        const bool has_all_objects =
            repeat_objects(*gathered.root, sources, folders, problems, !gathered.is_complete);
        apply_conditions(*gathered.root, sources, folders, problems, !gathered.is_complete);
        Reader reader(sources, folders, problems);
        reader.set_partial(!gathered.is_complete);
        root = std::make_shared<const Node>(std::move(*gathered.root));
        result.shot = read_shot(*root, gathered.is_complete && has_all_objects,
                                fs::path(origin).stem().string(), reader, options.tables);
        replaced = reader.replaced();
        result.named_files = reader.named_files();
    }
    if (problems.has_error()) {
        result.shot.reset();
    }
    result.problems = problems.take();
    result.files = files_of(sources);
    if (result.shot) {
        result.source =
            std::make_shared<ShotSource>(std::make_shared<const SourceSet>(std::move(sources)),
                                         std::move(root), std::move(replaced), result.problems);
    }
    return result;
}

namespace {

bool is_same(const Problem& a, const Problem& b) {
    return a.message == b.message && a.place.file == b.place.file && a.place.line == b.place.line &&
           a.place.column == b.place.column;
}

}  // namespace

bool has_open_moments(const Shot& shot) {
    return std::ranges::any_of(shot.moments,
                               [](const ShotMoment& moment) { return !moment.time.has_value(); });
}

std::vector<Problem> resolve_moments(Shot& shot, std::shared_ptr<const ShotSource>& source,
                                     const sim::Timeline& timeline,
                                     sim::billiards::TableMemo* tables) {
    if (!has_open_moments(shot)) {
        return {};
    }
    ProblemList problems(source->sources());
    const ConfigFolders folders = standard_config_folders();
    const KnownMotion motion{&timeline, &shot.world};
    Reader reader(source->sources(), folders, problems, &motion);
    std::optional<Shot> known = read_shot(source->root(), true, shot.name, reader, tables);
    std::vector<Problem> found = problems.take();
    std::erase_if(found, [&](const Problem& problem) {
        return std::ranges::any_of(source->problems(),
                                   [&](const Problem& before) { return is_same(problem, before); });
    });
    if (known) {
        shot.cameras = std::move(known->cameras);
        shot.annotations = std::move(known->annotations);
        shot.moments = std::move(known->moments);
        shot.resolved_text = std::move(known->resolved_text);
        source = std::make_shared<const ShotSource>(source->with_replaced(reader.replaced()));
    }
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
