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

std::vector<sim::Asset> hash_assets(const std::vector<std::string>& files, const Node& root,
                                    Reader& reader) {
    std::vector<sim::Asset> assets;
    for (const std::string& path : files) {
        try {
            assets.push_back({path, hash_file(path)});
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

/// Reads the merged tree; empty after an error. `has_all_objects`: false if some could not be
/// repeated, which was reported, so that references to them must not be checked.
std::optional<Shot> read_shot(const Gathered& gathered, bool has_all_objects,
                              const std::string& name, Reader& reader,
                              sim::billiards::TableMemo* tables) {
    const Node& root = *gathered.root;
    ShotFile file;
    reader.set_root_place(root.place);
    reader.set_partial(!gathered.is_complete);
    shot_spec().read(reader, root, file);
    if (!gathered.is_complete || !has_all_objects) {
        return std::nullopt;
    }
    Shot shot;
    try {
        shot = build_shot(file, root, name, reader, tables);
    } catch (const Error& failure) {  // geometry that the checks of single keys accept
        reader.error(root.place, failure.what());
    }
    if (!reader.has_error()) {
        shot.assets = hash_assets(reader.files(), root, reader);
        shot.resolved_text = emit_yaml(root, reader.absolute_paths());
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
                               {options.overrides, options.quality, options.camera_file}, problems);
    std::map<const Node*, std::string> files;
    if (gathered.root) {
        const bool has_all_objects =
            repeat_objects(*gathered.root, sources, folders, problems, !gathered.is_complete);
        apply_conditions(*gathered.root, sources, folders, problems, !gathered.is_complete);
        Reader reader(sources, folders, problems);
        result.shot = read_shot(gathered, has_all_objects, fs::path(origin).stem().string(), reader,
                                options.tables);
        files = reader.absolute_paths();
    }
    if (problems.has_error()) {
        result.shot.reset();
    }
    result.problems = problems.take();
    result.files = files_of(sources);
    if (result.shot) {
        result.source = std::make_shared<ShotSource>(std::move(sources), std::move(*gathered.root),
                                                     std::move(files));
    }
    return result;
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
