#include "pipeline/config/explain.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/assert.h"
#include "pipeline/config/emit_yaml.h"
#include "pipeline/config/key_conditions.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/source_set.h"
#include "pipeline/config/table_node.h"

namespace carom::pipeline {

using namespace config;

namespace {

constexpr std::size_t kCommentColumn = 48;

/// Whether the map has all keys of the node.
bool has_keys_of(const MapInfo& map, const Node& node) {
    return std::ranges::all_of(node.entries, [&](const Entry& entry) {
        return std::ranges::find(map.keys, entry.key, &KeyInfo::name) != map.keys.end();
    });
}

/// The one map among the types that a key accepts that can be meant by the node; nullptr if there
/// is none or more than one, because then only the parser knows.
const MapInfo* map_of(const TypeInfo* type, const Node& node) {
    if (type == nullptr) {
        return nullptr;
    }
    if (type->kind == TypeInfo::Kind::map) {
        return has_keys_of(*type->map, node) ? type->map : nullptr;
    }
    if (type->kind != TypeInfo::Kind::any_of) {
        return nullptr;
    }
    const MapInfo* found = nullptr;
    for (const TypeInfo& element : type->elements) {
        if (const MapInfo* map = map_of(&element, node)) {
            if (found != nullptr && found != map) {
                return nullptr;
            }
            found = map;
        }
    }
    return found;
}

/// The map that a key without a value has: its type, or the only map among its alternatives.
const MapInfo& absent_map(const TypeInfo& type) {
    const MapInfo* map = map_of(&type, {});
    CAROM_ASSERT(map != nullptr);
    return *map;
}

/// The type of the elements of a list or of a map with the user's names; nullptr for other types.
const TypeInfo* element_of(const TypeInfo* type, TypeInfo::Kind kind) {
    if (type == nullptr) {
        return nullptr;
    }
    if (type->kind == kind) {
        return &type->elements.at(0);
    }
    if (type->kind == TypeInfo::Kind::any_of) {
        for (const TypeInfo& alternative : type->elements) {
            if (const TypeInfo* element = element_of(&alternative, kind)) {
                return element;
            }
        }
    }
    return nullptr;
}

class Explainer {
  public:
    Explainer(const ShotSource& source, const Shot& shot) : source_(source) {
        if (shot.world.table) {
            table_ = table_node(*shot.world.table);
        }
        const Entry* section = source.root().find("render");
        const Entry* scaled = section != nullptr ? section->value.find("short_side") : nullptr;
        if (scaled != nullptr) {
            short_side_ = &scaled->value;
            picture_ = fmt::format("{}x{}", shot.render.width, shot.render.height);
        }
    }

    std::string text() && {
        write_map(source_.root(), &shot_spec().info(), "", "");
        return std::move(text_);
    }

  private:
    void write_line(std::string line, const std::string& origin) {
        if (!origin.empty()) {
            line.resize(std::max(line.size() + 2, kCommentColumn), ' ');
            line += "# " + origin;
        }
        text_ += line + "\n";
    }

    /// Whether the node has maps that are written as such.
    [[nodiscard]] bool holds_maps(const Node& node) const {
        return (node.is_map() && !source_.replaced().contains(&node)) ||
               std::any_of(node.items.begin(), node.items.end(),
                           [this](const Node& item) { return holds_maps(item); });
    }

    /// "shot.yaml:14", "--set". For a moment, how it is written as well.
    [[nodiscard]] std::string origin_of(const Node& node) const {
        const SourcePlace place = source_.sources().describe(node.place);
        const std::string origin = place.file.starts_with("--")
                                       ? place.file
                                       : fmt::format("{}:{}", place.file, place.line);
        if (node.is_map() && source_.replaced().contains(&node)) {
            return origin + ", " + emit_flow(node);
        }
        if (const auto note = source_.notes().find(&node); note != source_.notes().end()) {
            return origin + ", " + note->second;
        }
        return &node == short_side_ ? origin + ", makes the picture " + picture_ : origin;
    }

    /// Writes a value after `first`, which ends in "key:" or "-"; further lines begin with
    /// `indent`. `standard` has the measures of the table part that `node` describes, or is
    /// nullptr.
    void write_value(const Node& node, const TypeInfo* type, const std::string& first,
                     const std::string& indent, const Node* standard = nullptr) {
        const bool is_replaced = source_.replaced().contains(&node);
        if (node.is_map() && !node.entries.empty() && !is_replaced) {
            const TypeInfo* element = element_of(type, TypeInfo::Kind::named);
            if (first.ends_with("-")) {
                write_map(node, map_of(type, node), first + " ", indent, element);
            } else {
                text_ += first + "\n";
                write_map(node, map_of(type, node), indent, indent, element, standard);
            }
        } else if (node.is_sequence() && holds_maps(node)) {
            text_ += first + "\n";
            const TypeInfo* element = element_of(type, TypeInfo::Kind::list);
            for (const Node& item : node.items) {
                write_value(item, element, indent + "-", indent + "  ");
            }
        } else {
            write_line(first + " " + emit_flow(node, source_.replaced()), origin_of(node));
        }
    }

    /// The first line begins with `first`, the others with `indent`.
    void write_map(const Node& node, const MapInfo* info, const std::string& first,
                   const std::string& indent, const TypeInfo* named = nullptr,
                   const Node* standard = nullptr) {
        std::string begin = first;
        for (const Entry& entry : node.entries) {
            const KeyInfo* key = info != nullptr ? key_of(*info, entry.key) : nullptr;
            write_value(entry.value, key != nullptr ? &key->type : named,
                        begin + emit_key(entry.key) + ":", indent + "  ",
                        measures_of(node, entry.key, standard));
            begin = indent;
        }
        if (standard != nullptr) {
            write_measures(*standard, node, indent);
        }
        if (info != nullptr) {
            write_defaults(*info, node, indent);
        }
    }

    /// The standard measures of the table, or of its part `key` if `standard` has those of the
    /// table.
    [[nodiscard]] const Node* measures_of(const Node& parent, const std::string& key,
                                          const Node* standard) const {
        if (&parent == &source_.root() && key == "table") {
            return &table_;
        }
        const Entry* part = standard != nullptr ? standard->find(key) : nullptr;
        return part != nullptr && part->value.is_map() ? &part->value : nullptr;
    }

    /// Writes the measures that follow from the table's kind and size, as comments: they are
    /// rounded here, so that a shot that gave them would differ in the last digits.
    void write_measures(const Node& standard, const Node& given, const std::string& indent) {
        for (const Entry& entry : standard.entries) {
            if (given.find(entry.key) != nullptr) {
                continue;
            }
            const bool is_in_comment = indent.find('#') != std::string::npos;
            const std::string begin = is_in_comment ? indent : indent + "# ";
            if (entry.value.is_map()) {
                text_ += begin + entry.key + ":\n";
                write_measures(entry.value, {}, begin + "  ");
            } else {
                write_line(begin + entry.key + ": " + entry.value.text,
                           "of the table's kind and size");
            }
        }
    }

    /// Writes the defaults of the keys that `node` could give but does not.
    void write_defaults(const MapInfo& info, const Node& node, const std::string& indent) {
        for (const KeyInfo& key : info.keys) {
            if (node.find(key.name) != nullptr) {
                continue;
            }
            if (key.is_always_there) {
                const std::size_t before = text_.size();
                text_ += indent + emit_key(key.name) + ":\n";
                const std::size_t header = text_.size();
                write_defaults(absent_map(key.type), {}, indent + "  ");
                if (text_.size() == header) {
                    text_.resize(before);
                }
            } else if (!key.default_text.empty() && can_be_added(info, key, node)) {
                write_default(indent + emit_key(key.name) + ":", key.default_text, indent + "  ");
            }
        }
    }

    /// Writes a default after `first`; a map has a line for each of its keys, which begins with
    /// `indent`.
    void write_default(const std::string& first, const std::string& value,
                       const std::string& indent) {
        if (!value.starts_with('{')) {
            write_line(first + " " + value, "default");
            return;
        }
        SourceSet sources;
        ProblemList problems(sources);
        const int source = sources.add({"default", "", value});
        text_ += first + "\n";
        for (const Entry& entry : parse_yaml(sources, source, problems).value_or(Node{}).entries) {
            write_line(indent + emit_key(entry.key) + ": " + emit_flow(entry.value), "default");
        }
    }

    static const KeyInfo* key_of(const MapInfo& info, const std::string& name) {
        const auto found = std::find_if(info.keys.begin(), info.keys.end(),
                                        [&](const KeyInfo& key) { return key.name == name; });
        return found == info.keys.end() ? nullptr : &*found;
    }

    const ShotSource& source_;
    Node table_;                        // the measures of the shot's table
    const Node* short_side_ = nullptr;  // the shot's key, if given
    std::string picture_;               // the size that results from it
    std::string text_;
};

}  // namespace

std::string explained_yaml(const ShotSource& source, const Shot& shot) {
    return Explainer(source, shot).text();
}

}  // namespace carom::pipeline
