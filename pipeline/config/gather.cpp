#include "pipeline/config/gather.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "core/limits.h"
#include "core/text.h"
#include "pipeline/config/layers.h"
#include "pipeline/config/merge.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxIncludeDepth = 16;
constexpr std::size_t kMaxIncludes = 256;

/// A file that is being read: the shot, or a file that the previous one includes.
struct OpenFile {
    std::string path;  // absolute, or the origin's name for a text in memory
    std::string name;  // as problems print it
};

class Gatherer {
  public:
    Gatherer(SourceSet& sources, const ConfigFolders& folders, ProblemList& problems)
        : sources_(sources), folders_(folders), problems_(problems) {}

    /// The tree of a text, merged over its includes. With `use_quality` the shot's own preset is
    /// merged between the two.
    std::optional<Node> read(int source, std::vector<OpenFile>& open_files, bool use_quality);

    /// The preset with that name, which is given at `place`.
    std::optional<Node> read_preset(const std::string& name, const Place& place,
                                    std::vector<OpenFile>& open_files);

    /// The camera file `path`, which is given by the option at `place`.
    std::optional<Node> read_camera_file(const std::string& path, const Place& place);

    /// The file `path` with its includes, which is read for the value at `place`.
    std::optional<Node> read_config_file(const std::string& path, const Place& place);

    [[nodiscard]] bool is_complete() const { return is_complete_; }

  private:
    std::optional<Node> read_included(const Node& name, std::vector<OpenFile>& open_files);
    std::optional<Node> read_file(const std::string& path, std::string shown_name,
                                  const Place& named_at, std::vector<OpenFile>& open_files);
    Node merge_includes(const Node& own, std::vector<OpenFile>& open_files);
    void merge_set(Node& own, Node& base, std::vector<OpenFile>& open_files);
    std::optional<Node> read_set(const Node& name, std::vector<OpenFile>& open_files);
    void merge_rigs(Node& own, std::vector<OpenFile>& open_files);
    std::optional<Node> read_rig(const Node& name, std::vector<OpenFile>& open_files);
    bool check_version(const Node& root);

    SourceSet& sources_;
    const ConfigFolders& folders_;
    ProblemList& problems_;
    std::size_t include_count_ = 0;
    bool is_complete_ = true;
};

Node take_entry(Node& map, std::string_view key) {
    Node value;
    const auto found = std::find_if(map.entries.begin(), map.entries.end(),
                                    [&](const Entry& entry) { return entry.key == key; });
    if (found != map.entries.end()) {
        value = std::move(found->value);
        map.entries.erase(found);
    }
    return value;
}

/// False, after a problem, for a file of another version of the format.
bool Gatherer::check_version(const Node& root) {
    const Entry* version = root.find("carom");
    if (version == nullptr || (version->value.is_scalar() && version->value.text == "1")) {
        return true;
    }
    problems_.error(
        version->value.place,
        "this program reads version 1 of the format ('carom: 1'), not " +
            (version->value.is_scalar() ? quote(version->value.text) : std::string("this value")));
    return false;
}

/// Removes the first characters of `text` until one of `ends` and returns them.
std::string_view take_until(std::string_view& text, const char* ends) {
    const std::string_view taken = text.substr(0, text.find_first_of(ends));
    text.remove_prefix(taken.size());
    return taken;
}

/// Whether the text begins with `type NAME {`, as scenes of the older text format do and no map of
/// YAML does.
bool is_older_scene(std::string_view text) {
    constexpr const char* kSpace = " \t\r\n";
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    const auto skip_space = [&] {
        text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
    };
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    skip_space();
    const std::string_view type = take_until(text, " \t\r\n{}");
    skip_space();
    const std::string_view name = take_until(text, " \t\r\n{}");
    skip_space();
    const bool is_word =
        type.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string_view::npos;
    return is_word && !type.empty() && !name.empty() && name.back() != ':' && text.starts_with('{');
}

std::optional<Node> Gatherer::read(int source, std::vector<OpenFile>& open_files,
                                   bool use_quality) {
    if (is_older_scene(sources_.at(source).text)) {
        const std::string& name = sources_.at(source).name;
        problems_.error({source, 1, 1, 1},
                        "this is not YAML but looks like a scene of the older text format; convert "
                        "it with 'carom import " +
                            name + "'");
        return std::nullopt;
    }
    std::optional<Node> own = parse_yaml(sources_, source, problems_);
    if (!own) {
        return std::nullopt;
    }
    const bool is_root = open_files.size() == 1;
    if (!own->is_map()) {
        problems_.error(own->place,
                        own->is_null() ? "the file is empty" : "the file must be a map of keys");
        return std::nullopt;
    }
    if (!check_version(*own)) {
        return std::nullopt;
    }
    Node base = merge_includes(*own, open_files);
    merge_set(*own, base, open_files);
    take_entry(*own, "include");
    merge_rigs(*own, open_files);
    take_entry(base, "carom");  // required in the shot itself
    Node inherited = take_entry(base, "quality");
    Node quality = take_entry(*own, "quality");
    if (quality.is_null()) {
        quality = std::move(inherited);
    }
    if (!quality.is_null() && !quality.is_scalar()) {
        problems_.error(quality.place, "'quality' must be the name of a preset");
    } else if (is_root && use_quality && quality.is_scalar()) {
        if (std::optional<Node> preset = read_preset(quality.text, quality.place, open_files)) {
            merge_layer(base, std::move(*preset));
        }
    } else if (!is_root && quality.is_scalar()) {
        own->entries.push_back({"quality", quality.place, std::move(quality)});
    }
    merge_layer(base, std::move(*own));
    return base;
}

Node Gatherer::merge_includes(const Node& own, std::vector<OpenFile>& open_files) {
    Node base;
    base.kind = Node::Kind::map;
    base.place = own.place;
    const Entry* include = own.find("include");
    if (include == nullptr) {
        return base;
    }
    const Node& value = include->value;
    const std::vector<Node> names = value.is_sequence() ? value.items : std::vector<Node>{value};
    for (const Node& name : names) {
        if (!name.is_scalar()) {
            is_complete_ = false;
            problems_.error(name.place, "'include' must be a file name or a list of file names");
            continue;
        }
        std::optional<Node> included = read_included(name, open_files);
        if (included) {
            merge_layer(base, std::move(*included));
        } else {
            is_complete_ = false;
        }
    }
    return base;
}

/// Merges the file that a set names over `base`. Of the key remains what is not the file.
void Gatherer::merge_set(Node& own, Node& base, std::vector<OpenFile>& open_files) {
    Entry* set = own.find("set");
    if (set == nullptr || set->value.is_null()) {
        return;
    }
    Node name;
    if (set->value.is_map()) {
        name = take_entry(set->value, "file");
    } else {
        std::swap(name, set->value);
        set->value.kind = Node::Kind::map;
        set->value.place = name.place;
    }
    if (name.is_null()) {
        return;
    }
    if (std::optional<Node> found = read_set(name, open_files)) {
        take_entry(*found, "carom");
        merge_layer(base, std::move(*found));
    } else {
        is_complete_ = false;
    }
}

/// The file of a set by its name: a path, or a name in the folder `sets` of the configs.
std::optional<Node> Gatherer::read_set(const Node& name, std::vector<OpenFile>& open_files) {
    if (!name.is_scalar()) {
        problems_.error(name.place, "a set must be a name, the name of a file, or a map");
        return std::nullopt;
    }
    if (name.text.ends_with(".yaml")) {
        return read_included(name, open_files);
    }
    const std::string& folder = sources_.at(name.place.source).folder;
    const bool is_name = !name.text.empty() && name.text.find('/') == std::string::npos;
    const FoundFile found =
        is_name ? find_config_file("sets/" + name.text + ".yaml", folder, folders_) : FoundFile{};
    if (found.path.empty()) {
        const std::vector<std::string> known = preset_names("sets", folders_);
        problems_.error(name.place,
                        "there is no set " + quote(name.text) +
                            (known.empty() ? std::string()
                                           : " (the sets are " + enumerate(known, "and") + ")") +
                            "; the name of a file ends in .yaml");
        return std::nullopt;
    }
    return read_file(found.path, found.path, name.place, open_files);
}

/// Merges each camera that includes a file over the camera of that file.
void Gatherer::merge_rigs(Node& own, std::vector<OpenFile>& open_files) {
    Entry* cameras = own.find("cameras");
    if (cameras == nullptr) {
        return;
    }
    for (Node& camera : cameras->value.items) {
        const Node name = take_entry(camera, "include");
        if (name.place.source < 0) {
            continue;  // the camera includes no file
        }
        if (std::optional<Node> rig = read_rig(name, open_files)) {
            merge(*rig, std::move(camera));
            camera = std::move(*rig);
        } else {
            is_complete_ = false;
        }
    }
}

/// The camera of a file that contains only this camera.
std::optional<Node> Gatherer::read_rig(const Node& name, std::vector<OpenFile>& open_files) {
    if (!name.is_scalar()) {
        problems_.error(name.place, "'include' of a camera must be a file name");
        return std::nullopt;
    }
    std::optional<Node> included = read_included(name, open_files);
    if (!included) {
        return std::nullopt;
    }
    Node cameras = take_entry(*included, "cameras");
    if (cameras.items.size() != 1 || !cameras.items.front().is_map()) {
        problems_.error(name.place,
                        "file " + quote(name.text) +
                            " must have exactly one camera, because a camera includes it");
        return std::nullopt;
    }
    for (const Entry& entry : included->entries) {
        if (entry.key != "carom") {
            problems_.error(entry.key_place,
                            "a file that a camera includes may contain only 'cameras', not " +
                                quote(entry.key));
        }
    }
    return std::move(cameras.items.front());
}

std::optional<Node> Gatherer::read_included(const Node& name, std::vector<OpenFile>& open_files) {
    const std::string& folder = sources_.at(name.place.source).folder;
    const FoundFile found = find_config_file(name.text, folder, folders_);
    if (found.path.empty()) {
        problems_.error(name.place, "included " + found.problem);
        return std::nullopt;
    }
    // The name is shown relative to the shown name of the including file.
    const fs::path beside = fs::path(open_files.back().name).parent_path() / name.text;
    std::error_code code;
    const bool is_beside = fs::equivalent(beside, found.path, code) && !code;
    return read_file(found.path, is_beside ? beside.lexically_normal().string() : found.path,
                     name.place, open_files);
}

std::optional<Node> Gatherer::read_file(const std::string& path, std::string shown_name,
                                        const Place& named_at, std::vector<OpenFile>& open_files) {
    const auto same = [&](const OpenFile& open) { return open.path == path; };
    if (std::any_of(open_files.begin(), open_files.end(), same)) {
        std::string chain;
        for (const OpenFile& open : open_files) {
            chain += open.name + " -> ";
        }
        problems_.error(named_at, "files include each other in a cycle: " + chain + shown_name);
        return std::nullopt;
    }
    if (open_files.size() > kMaxIncludeDepth || ++include_count_ > input_limit(kMaxIncludes)) {
        problems_.error(
            named_at,
            open_files.size() > kMaxIncludeDepth
                ? fmt::format("includes are nested more than {} levels deep", kMaxIncludeDepth)
                : beyond_limit(input_limit(kMaxIncludes), "files are included"));
        return std::nullopt;
    }
    std::string text;
    if (!read_config_text(path, YamlLimits{}.bytes, folders_, text)) {
        problems_.error(named_at, "file " + quote(shown_name) + " " + text);
        return std::nullopt;
    }
    const std::string folder = fs::path(path).parent_path().string();
    const int source = sources_.add({shown_name, folder, std::move(text), named_at, path});
    open_files.push_back({path, std::move(shown_name)});
    std::optional<Node> tree = read(source, open_files, false);
    open_files.pop_back();
    return tree;
}

std::optional<Node> Gatherer::read_preset(const std::string& name, const Place& place,
                                          std::vector<OpenFile>& open_files) {
    const std::vector<std::string> known = preset_names("quality", folders_);
    const std::string& folder = sources_.at(place.source).folder;
    const bool is_name = !name.empty() && name.find('/') == std::string::npos;
    const FoundFile found =
        is_name ? find_config_file("quality/" + name + ".yaml", folder, folders_) : FoundFile{};
    if (found.path.empty()) {
        problems_.error(place,
                        "there is no quality preset " + quote(name) +
                            (known.empty() ? std::string()
                                           : " (the presets are " + enumerate(known, "and") + ")"));
        return std::nullopt;
    }
    std::optional<Node> preset = read_file(found.path, found.path, place, open_files);
    if (preset) {
        take_entry(*preset, "carom");
    }
    return preset;
}

/// Removes the keys that a camera file must not have, and reports a problem for each.
void keep_cameras_and_look(Node& tree, ProblemList& problems) {
    static const std::vector<std::string> allowed{"cameras", "render", "output",
                                                  "sound",   "lights", "materials"};
    std::erase_if(tree.entries, [&](const Entry& entry) {
        const bool is_wrong = std::find(allowed.begin(), allowed.end(), entry.key) == allowed.end();
        if (is_wrong) {
            problems.error(entry.key_place, "a camera file may contain only " +
                                                enumerate(allowed, "and") + ", not " +
                                                quote(entry.key));
        }
        return is_wrong;
    });
    if (tree.find("cameras") == nullptr) {
        problems.error(tree.place, "a camera file needs the key 'cameras'");
    }
}

std::optional<Node> Gatherer::read_camera_file(const std::string& path, const Place& place) {
    std::vector<OpenFile> open_files{{"--camera", path}};  // not included by the shot
    std::error_code code;
    const fs::path canonical = fs::canonical(path, code);
    std::optional<Node> tree = read_file(code ? path : canonical.string(), path, place, open_files);
    if (tree) {
        take_entry(*tree, "carom");
        keep_cameras_and_look(*tree, problems_);
    } else {
        is_complete_ = false;
    }
    return tree;
}

std::optional<Node> Gatherer::read_config_file(const std::string& path, const Place& place) {
    std::vector<OpenFile> open_files{{sources_.at(place.source).name, path}};
    return read_file(path, path, place, open_files);
}

}  // namespace

SourceText text_of_shot(std::string text, const std::string& origin) {
    std::error_code code;
    const fs::path absolute = fs::absolute(origin, code);
    const std::string folder = code ? "." : absolute.lexically_normal().parent_path().string();
    const fs::path path = fs::weakly_canonical(origin, code);
    return {origin, folder, std::move(text), {}, code ? std::string() : path.string()};
}

Gathered gather(SourceSet& sources, int root_source, const ConfigFolders& folders,
                const GatherOptions& options, ProblemList& problems) {
    Gatherer gatherer(sources, folders, problems);
    const SourceText& root_text = sources.at(root_source);
    std::error_code code;
    const fs::path canonical = fs::canonical(root_text.name, code);
    std::vector<OpenFile> open_files{{code ? root_text.name : canonical.string(), root_text.name}};
    const std::string root_folder = root_text.folder;
    std::optional<Node> root = gatherer.read(root_source, open_files, options.quality.empty());
    if (!root) {
        return {};
    }
    for (const std::string& value : options.own) {
        const int source = sources.add({"film", root_folder, value});
        merge_override(*root, sources, source, problems);
    }
    if (!options.quality.empty()) {
        const int source = sources.add({"--quality", root_folder, options.quality});
        const Place place = sources.place_at(source, 0, options.quality.size());
        if (std::optional<Node> preset = gatherer.read_preset(options.quality, place, open_files)) {
            merge_layer(*root, std::move(*preset));
        }
    }
    if (!options.camera_file.empty()) {
        const int source = sources.add({"--camera", root_folder, options.camera_file});
        const Place place = sources.place_at(source, 0, options.camera_file.size());
        if (std::optional<Node> cameras = gatherer.read_camera_file(options.camera_file, place)) {
            merge_layer(*root, std::move(*cameras));
        }
    }
    for (const std::string& override_text : options.overrides) {
        // Paths in an override are relative to the shot.
        const int source = sources.add({"--set", root_folder, override_text});
        merge_override(*root, sources, source, problems);
    }
    // The version becomes the first key.
    const auto version = std::find_if(root->entries.begin(), root->entries.end(),
                                      [](const Entry& entry) { return entry.key == "carom"; });
    if (version != root->entries.end()) {
        std::rotate(root->entries.begin(), version, version + 1);
    }
    return {std::move(root), gatherer.is_complete()};
}

std::optional<Node> read_config(SourceSet& sources, const std::string& name, const Place& named_at,
                                const ConfigFolders& folders, ProblemList& problems) {
    for (const std::string& folder : folders.folders) {
        const FoundFile found = find_config_file(name, folder, {{folder}});
        if (!found.path.empty()) {
            return Gatherer(sources, folders, problems).read_config_file(found.path, named_at);
        }
    }
    return std::nullopt;
}

}  // namespace carom::pipeline::config
