#include "pipeline/config/key_completion.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "pipeline/config/gather.h"
#include "pipeline/config/pocket_names.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/sections/sections.h"
#include "sim/billiards/spots.h"

namespace carom::pipeline::config {

namespace {

// "cameras[0].fov" and "cameras.0.fov" are the same path.
constexpr const char* kSeparators = ".[]";

/// A type, and the part of the shot that has this type, or nullptr.
struct Spot {
    const TypeInfo* type = nullptr;
    const Node* node = nullptr;
};

/// Whether a name needs no quotes in any shell; other names are not offered.
bool is_plain(const std::string& name) {
    return !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               c == '_' || c == '-';
    });
}

const Node* value_of(const Node* node, std::string_view key) {
    const Entry* entry = node != nullptr ? node->find(key) : nullptr;
    return entry != nullptr ? &entry->value : nullptr;
}

std::string name_of_element(const Node& list, std::size_t index) {
    const Node* name = value_of(&list.items[index], "name");
    return name != nullptr && is_plain(name->text) ? name->text : fmt::format("{}", index);
}

/// A key, name or element below a type.
struct Step {
    std::string name;
    std::string description;
    Spot spot;
};

void add_steps(const Spot& spot, std::vector<Step>& steps) {
    const TypeInfo& type = *spot.type;
    if (type.kind == TypeInfo::Kind::map) {
        for (const KeyInfo& key : type.map->keys) {
            steps.push_back(
                {key.name, key.description, {&key.type, value_of(spot.node, key.name)}});
        }
    } else if (type.kind == TypeInfo::Kind::named && spot.node != nullptr) {
        for (const Entry& entry : spot.node->entries) {
            steps.push_back({entry.key, type.noun, {&type.elements.at(0), &entry.value}});
        }
    } else if (type.kind == TypeInfo::Kind::list && spot.node != nullptr) {
        for (std::size_t i = 0; i < spot.node->items.size(); ++i) {
            steps.push_back({name_of_element(*spot.node, i),
                             type.noun,
                             {&type.elements.at(0), &spot.node->items[i]}});
        }
    } else if (type.kind == TypeInfo::Kind::any_of) {
        for (const TypeInfo& element : type.elements) {
            add_steps({&element, spot.node}, steps);
        }
    }
}

/// Whether a path can continue with keys below this type.
bool has_keys(const TypeInfo& type) {
    switch (type.kind) {
        case TypeInfo::Kind::map:
        case TypeInfo::Kind::named:
            return true;
        case TypeInfo::Kind::list:
        case TypeInfo::Kind::any_of:
            return std::ranges::any_of(type.elements, has_keys);
        default:
            return false;
    }
}

/// Whether a value can follow "=" on a command line: a word, a number or a list of these.
bool has_value(const TypeInfo& type) {
    switch (type.kind) {
        case TypeInfo::Kind::map:
        case TypeInfo::Kind::named:
        case TypeInfo::Kind::settings:
            return false;
        case TypeInfo::Kind::list:
        case TypeInfo::Kind::any_of:
            return std::ranges::any_of(type.elements, has_value);
        default:
            return true;
    }
}

void add_names(const Node& shot, const char* section, std::vector<std::string>& names) {
    if (const Node* map = value_of(&shot, section)) {
        std::ranges::transform(map->entries, std::back_inserter(names), &Entry::key);
    }
}

/// A table of the shot's kind; one with all spots if that is not known.
sim::billiards::TableMeasures table_of(const Node& shot) {
    using sim::billiards::TableKind;
    const Node* table = value_of(&shot, "table");
    const Node* kind = table != nullptr ? value_of(table, "kind") : nullptr;
    const TableKind known = kind == nullptr || kind->text == "custom" ? TableKind::custom
                            : kind->text == "snooker"                 ? TableKind::snooker
                            : kind->text == "carom"                   ? TableKind::carom
                                                                      : TableKind::pool;
    const bool is_pool = known == TableKind::pool || known == TableKind::custom;
    auto measures =
        *standard_table(is_pool ? TableKind::pool : known, known == TableKind::snooker ? "12 ft"
                                                           : known == TableKind::carom ? "10 ft"
                                                                                       : "9 ft");
    measures.kind = known;
    return measures;
}

/// Adds the spots of the shot's table, and its pockets.
void add_places(const Node& shot, bool with_spots, bool with_pockets,
                std::vector<std::string>& values) {
    const sim::billiards::TableMeasures table = table_of(shot);
    for (const auto& spot : sim::billiards::spots_of(table)) {
        if (with_spots) {
            values.push_back(spot.name);
        }
    }
    for (std::string& pocket : pocket_names(table)) {
        if (with_pockets) {
            values.push_back(std::move(pocket));
        }
    }
}

/// Adds the possible values if they are a closed set or names of the shot.
void add_values(const TypeInfo& type, const Node& shot, std::vector<std::string>& values) {
    if (type.kind == TypeInfo::Kind::boolean) {
        values.insert(values.end(), {"true", "false"});
    } else if (type.kind == TypeInfo::Kind::choice || type.kind == TypeInfo::Kind::text) {
        values.insert(values.end(), type.choices.begin(), type.choices.end());
        const std::size_t dot = type.more_choices.find('.');
        if (dot != std::string::npos) {
            const Node* map = value_of(&shot, type.more_choices.substr(0, dot));
            const Node* more = value_of(map, type.more_choices.substr(dot + 1));
            for (const Entry& entry : more != nullptr ? more->entries : std::vector<Entry>()) {
                values.push_back(entry.key);
            }
        }
    } else if (type.kind == TypeInfo::Kind::name && type.noun == "a material") {
        add_names(shot, "materials", values);
    } else if (type.kind == TypeInfo::Kind::name) {
        const bool is_place = type.noun.ends_with(" of the table");
        add_places(shot, type.noun.find("spot") != std::string::npos,
                   type.noun.find("pocket") != std::string::npos, values);
        if (!is_place) {
            add_names(shot, "balls", values);
        }
        if (type.noun != "a ball" && !is_place) {
            add_names(shot, "objects", values);
        }
    } else if (type.kind == TypeInfo::Kind::any_of) {
        for (const TypeInfo& element : type.elements) {
            add_values(element, shot, values);
        }
    }
}

/// Everything below the given spots.
std::vector<Step> steps_below(const std::vector<Spot>& spots) {
    std::vector<Step> steps;
    for (const Spot& spot : spots) {
        add_steps(spot, steps);
    }
    return steps;
}

/// Adds the element types of named maps and of lists.
void add_elements(const TypeInfo& type, std::vector<Spot>& spots) {
    if (type.kind == TypeInfo::Kind::named || type.kind == TypeInfo::Kind::list) {
        spots.push_back({&type.elements.at(0), nullptr});
    } else if (type.kind == TypeInfo::Kind::any_of) {
        for (const TypeInfo& element : type.elements) {
            add_elements(element, spots);
        }
    }
}

/// Goes one step down the path. A name that the shot does not have is assumed to be a new one, and
/// an index also selects an element that has a name.
std::vector<Spot> step_down(const std::vector<Spot>& spots, std::string_view name) {
    std::vector<Spot> below;
    for (const Step& step : steps_below(spots)) {
        if (step.name == name) {
            below.push_back(step.spot);
        }
    }
    for (const Spot& spot : below.empty() ? spots : std::vector<Spot>()) {
        add_elements(*spot.type, below);
    }
    return below;
}

void add_candidate(std::vector<KeyCandidate>& candidates, KeyCandidate candidate) {
    const auto is_same = [&](const KeyCandidate& c) { return c.text == candidate.text; };
    if (std::ranges::none_of(candidates, is_same)) {
        candidates.push_back(std::move(candidate));
    }
}

/// Adds the keys that may follow `before`, the path to the spots.
void add_key_candidates(const std::vector<Spot>& spots, const std::string& before,
                        std::vector<KeyCandidate>& candidates) {
    for (const Step& step : steps_below(spots)) {
        if (is_plain(step.name) && has_keys(*step.spot.type)) {
            add_candidate(candidates, {before + step.name + ".", step.description});
        }
        if (is_plain(step.name) && has_value(*step.spot.type)) {
            add_candidate(candidates, {before + step.name + "=", step.description});
        }
    }
}

/// Adds the values that may follow `before`, such as "render.denoise=".
void add_value_candidates(const std::vector<Spot>& spots, const Node& shot,
                          const std::string& before, std::vector<KeyCandidate>& candidates) {
    std::vector<std::string> values;
    for (const Spot& spot : spots) {
        add_values(*spot.type, shot, values);
    }
    for (const std::string& value : values) {
        if (is_plain(value)) {
            add_candidate(candidates, {before + value, {}});
        }
    }
}

void add_racked_balls(Node& tree, Reader& reader) {
    const Node* rack = value_of(&tree, "rack");
    if (rack == nullptr || !rack->is_map()) {
        return;
    }
    RackSection section;
    rack_spec().read(reader, *rack, section);
    if (tree.find("balls") == nullptr) {
        tree.entries.push_back({"balls", {}, {}});
    }
    Node& balls = tree.find("balls")->value;
    // Only the names are used, so the radius and the table are arbitrary.
    for (const auto& ball : sim::billiards::rack(section.set, {}, 0.028, {})) {
        if (balls.find(ball.name) == nullptr) {
            balls.entries.push_back({ball.name, {}, {}});
        }
    }
}

}  // namespace

std::vector<KeyCandidate> complete_override(std::string_view start, const Node& shot) {
    TypeInfo top;
    top.kind = TypeInfo::Kind::map;
    top.map = &shot_spec().info();
    std::vector<Spot> spots{{&top, &shot}};
    const std::size_t equals = start.find('=');
    const std::string_view path = start.substr(0, equals);
    std::size_t begin = 0;  // of the name that is being typed
    for (std::size_t end = path.find_first_of(kSeparators); end != std::string_view::npos;
         end = path.find_first_of(kSeparators, begin)) {
        spots = end > begin ? step_down(spots, path.substr(begin, end - begin)) : spots;
        begin = end + 1;
    }
    std::vector<KeyCandidate> candidates;
    if (equals == std::string_view::npos) {
        add_key_candidates(spots, std::string(path.substr(0, begin)), candidates);
    } else {
        const std::string_view last = path.substr(begin);
        add_value_candidates(last.empty() ? spots : step_down(spots, last), shot,
                             std::string(start.substr(0, equals + 1)), candidates);
    }
    std::erase_if(candidates, [&](const KeyCandidate& c) { return !c.text.starts_with(start); });
    return candidates;
}

Node readable_tree(const std::string& text, const std::string& origin) {
    SourceSet sources;
    ProblemList problems(sources);
    const ConfigFolders folders = standard_config_folders();
    std::error_code code;
    const auto folder = std::filesystem::absolute(origin, code).lexically_normal().parent_path();
    const int source = sources.add({origin, folder.string(), text});
    Gathered gathered = gather(sources, source, folders, {}, problems);
    Node tree = gathered.root ? std::move(*gathered.root) : Node{};
    Reader reader(sources, folders, problems);
    add_racked_balls(tree, reader);
    return tree;
}

std::vector<std::string> camera_names(const Node& shot) {
    std::vector<std::string> names;
    if (const Node* cameras = value_of(&shot, "cameras")) {
        for (const Node& camera : cameras->items) {
            const Node* name = value_of(&camera, "name");
            if (name != nullptr && is_plain(name->text)) {
                names.push_back(name->text);
            }
        }
    }
    return names;
}

}  // namespace carom::pipeline::config
