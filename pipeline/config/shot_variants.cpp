#include "pipeline/config/shot_variants.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "pipeline/config/build/build_shot.h"
#include "pipeline/config/changed_keys.h"
#include "pipeline/config/conditions.h"
#include "pipeline/config/gather.h"
#include "pipeline/config/layers.h"
#include "pipeline/config/merge.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/repeat.h"
#include "pipeline/config/sections/sections.h"
#include "sim/billiards/table_memo.h"

namespace carom::pipeline {

using namespace config;

namespace {

/// The section to which a key belongs.
std::string_view section_of(std::string_view key) {
    return key.substr(0, key.find_first_of(".["));
}

void keep_sections(Node& root, const std::function<bool(std::string_view)>& is_kept) {
    std::erase_if(root.entries, [&](const Entry& entry) { return !is_kept(entry.key); });
}

/// What the events of a shot are read from: with `physics`, which says how the stick is
/// (apply_conditions).
bool concerns_events(std::string_view section) {
    return section == "carom" || section == "events" || section == "physics" ||
           section == "conditions" || section == "ball_set" || section == "table";
}

bool is_read_for_events(std::string_view section) {
    return section == "carom" || section == "events" || section == "ball_set" || section == "table";
}

bool concerns_motion(std::string_view section) {
    return section == "carom" || section == "conditions" || is_physics_section(section);
}

ShotFile read_sections(const Node& root, Reader& reader) {
    ShotFile file;
    reader.set_root_place(root.place);
    shot_spec().read(reader, root, file);
    return file;
}

}  // namespace

struct ShotVariants::Data {
    std::string origin;  // of the texts of values
    SourceSet sources;
    ConfigFolders folders;
    Node root;         // merged, before objects are repeated and conditions applied
    Node events_root;  // what events are read from
    std::string folder;
    BuiltWorld own;  // the shot's
    mutable sim::billiards::TableMemo tables;

    /// The tree with the values, whose texts `texts` gets.
    [[nodiscard]] Node with_values(Node tree, std::span<const VariedValue> values, SourceSet& texts,
                                   ProblemList& problems) const {
        for (const VariedValue& value : values) {
            const int source = texts.add({origin, folder, value.key + "=" + value.text});
            merge_override(tree, texts, source, problems);
        }
        return tree;
    }

    [[nodiscard]] std::optional<BuiltWorld> build(std::span<const VariedValue> values,
                                                  std::vector<Problem>& found) const {
        SourceSet texts = sources;
        ProblemList problems(texts);
        Node tree = with_values(root, values, texts, problems);
        const bool has_all_objects = repeat_objects(tree, texts, folders, problems, false);
        apply_conditions(tree, texts, folders, problems, false);
        Reader reader(texts, folders, problems);
        const ShotFile file = read_sections(tree, reader);
        std::optional<BuiltWorld> built;
        if (has_all_objects) {
            try {
                built = build_world(file, tree, reader, &tables);
            } catch (const Error& failure) {  // as load_shot
                reader.error(tree.place, failure.what());
            }
        }
        if (problems.has_error()) {
            built.reset();
        }
        found = problems.take();
        return built;
    }
};

ShotVariants::ShotVariants(const std::string& path, const LoadOptions& options,
                           std::string origin) {
    auto data = std::make_unique<Data>();
    data->origin = std::move(origin);
    data->folders = config_folders_of(path);
    data->folders.root = options.root;
    data->folders.texts = options.texts;
    std::string text;
    if (!read_config_text(path, YamlLimits{}.bytes, data->folders, text)) {
        throw Error("the file '" + path + "' " + text);
    }
    ProblemList problems(data->sources);
    const int source = data->sources.add(text_of_shot(std::move(text), path));
    data->folder = data->sources.at(source).folder;
    Gathered gathered =
        gather(data->sources, source, data->folders,
               {.overrides = options.overrides, .quality = options.quality}, problems);
    std::optional<BuiltWorld> own;
    if (gathered.root && !problems.has_error()) {
        data->root = std::move(*gathered.root);
        keep_sections(data->root, concerns_motion);
        data->events_root = data->root;
        keep_sections(data->events_root, concerns_events);
        std::vector<Problem> ignored;
        own = data->build({}, ignored);
    }
    if (!own) {
        throw Error("'" + path + "' has errors");
    }
    data->own = std::move(*own);
    data_ = std::move(data);
}

ShotVariants::~ShotVariants() = default;

std::optional<std::string> ShotVariants::text_of(const std::string& key) const {
    SourceSet texts = data_->sources;
    ProblemList ignored(texts);
    Node tree = data_->root;
    apply_conditions(tree, texts, data_->folders, ignored, false);
    const Node* value = value_at(tree, key);
    return value != nullptr && value->is_scalar() ? std::optional(value->text) : std::nullopt;
}

const sim::WorldDescription& ShotVariants::own_world() const {
    return data_->own.world;
}

ShotVariants::World ShotVariants::world(std::span<const VariedValue> values) const {
    World result;
    if (std::optional<BuiltWorld> built = data_->build(values, result.problems)) {
        result.world = std::move(built->world);
    }
    return result;
}

ShotVariants::Events ShotVariants::events(std::span<const VariedValue> values) const {
    SourceSet texts = data_->sources;
    ProblemList problems(texts);
    Node tree = data_->with_values(data_->events_root, values, texts, problems);
    apply_conditions(tree, texts, data_->folders, problems, false);
    keep_sections(tree, is_read_for_events);
    Reader reader(texts, data_->folders, problems);
    const ShotFile file = read_sections(tree, reader);
    Events result;
    result.events = build_events(file, tree, reader, data_->own);
    if (problems.has_error()) {
        result.events.reset();
    }
    result.problems = problems.take();
    return result;
}

bool is_in_events(const std::string& key) {
    return section_of(key) == "events";
}

bool can_change_motion(const std::string& key) {
    const std::string_view section = section_of(key);
    const std::vector<KeyInfo>& known = shot_spec().info().keys;
    return concerns_motion(section) ||
           std::ranges::find(known, section, &KeyInfo::name) == known.end();
}

}  // namespace carom::pipeline
