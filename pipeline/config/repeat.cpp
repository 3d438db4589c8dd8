#include "pipeline/config/repeat.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/limits.h"
#include "core/text.h"
#include "pipeline/config/merge.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/repeat_places.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr const char* kSection = "objects";
constexpr const char* kKey = "repeat";

/// The value at a key, removed from the map; nothing if there is none.
std::optional<Entry> take(Node& map, std::string_view key) {
    const auto found = std::ranges::find(map.entries, key, &Entry::key);
    if (found == map.entries.end()) {
        return std::nullopt;
    }
    Entry entry = std::move(*found);
    map.entries.erase(found);
    return entry;
}

void mark_as_repeated(Node& node) {
    node.is_repeated = true;
    std::ranges::for_each(node.items, mark_as_repeated);
    for (Entry& entry : node.entries) {
        mark_as_repeated(entry.value);
    }
}

/// The number of nodes.
std::size_t size_of(const Node& node) {
    std::size_t size = 1;
    for (const Node& item : node.items) {
        size += size_of(item);
    }
    for (const Entry& entry : node.entries) {
        size += size_of(entry.value);
    }
    return size;
}

Node scalar(std::string text, const Place& place) {
    Node node;
    node.kind = Node::Kind::scalar;
    node.place = place;
    node.text = std::move(text);
    return node;
}

Node list(const std::vector<std::string>& texts, const Place& place) {
    Node node;
    node.kind = Node::Kind::sequence;
    node.place = place;
    for (const std::string& text : texts) {
        node.items.push_back(scalar(text, place));
    }
    return node;
}

std::string metres(double value) {
    constexpr int kDecimals = 9;
    return decimal_text(value, kDecimals);
}

std::string degrees(double angle) {
    constexpr int kDecimals = 7;
    return decimal_text(angle * 180 / std::numbers::pi, kDecimals) + " deg";
}

Node position_node(const Vec3& position, const Place& place) {
    return list({metres(position.x), metres(position.y), metres(position.z)}, place);
}

/// A rotation as {axis, angle}.
Node rotation_node(const Quat& rotation, const Place& place) {
    const double sine = rotation.v.length();
    const Vec3 axis = sine > 0 ? rotation.v / sine : Vec3(0, 0, 1);
    Node node;
    node.kind = Node::Kind::map;
    node.place = place;
    node.entries.push_back({"axis", place, position_node(axis, place)});
    node.entries.push_back(
        {"angle", place, scalar(degrees(2 * arctangent2(sine, rotation.r)), place)});
    return node;
}

/// An object that stands for many, as it was read.
struct Original {
    ObjectSection object;
    RepeatSection repeat;
    Place path_place;  // of the values that follow from the path
};

class Repeats {
  public:
    Repeats(Node& objects, const SourceSet& sources, const ConfigFolders& folders,
            ProblemList& problems, bool is_partial)
        : objects_(objects),
          sources_(sources),
          folders_(folders),
          problems_(problems),
          is_partial_(is_partial) {}

    bool apply() {
        own_ = std::exchange(objects_.entries, {});
        for (const Entry& entry : own_) {
            if (entry.value.find(kKey) == nullptr) {
                names_.insert(entry.key);
            }
        }
        for (Entry& entry : own_) {
            if (merged_.count(entry.key) != 0) {
                continue;
            }
            if (entry.value.find(kKey) == nullptr) {
                objects_.entries.push_back({entry.key, entry.key_place, std::move(entry.value)});
            } else if (const auto original = read(entry)) {
                repeat(entry, *original);
            } else {
                is_whole_ = false;
            }
        }
        return is_whole_;
    }

  private:
    /// The original without its problems, which are reported; nothing if it has some.
    std::optional<Original> read(const Entry& entry) {
        ProblemList found(sources_);
        std::optional<Original> original = read(entry, found);
        if (found.has_error()) {
            static_cast<void>(read(entry, problems_));
            return std::nullopt;
        }
        return original;
    }

    std::optional<Original> read(const Entry& entry, ProblemList& problems) const {
        Reader reader(sources_, folders_, problems);
        reader.set_partial(is_partial_);
        const Reader::Scope section(reader, kSection, objects_.place);
        const Reader::Scope scope(reader, entry.key, entry.key_place);
        reader.set_label("object '" + entry.key + "'");
        if (!check_name(reader, entry.key, entry.key_place, "object")) {
            return std::nullopt;
        }
        Original original;
        const Entry& repeat = *entry.value.find(kKey);
        // This reads `repeat` as well, and forgets it.
        object_spec().read(reader, entry.value, original.object);
        if (repeat.value.is_map()) {
            ProblemList known(sources_);
            Reader again(sources_, folders_, known);
            repeat_spec().read(again, repeat.value, original.repeat);
            const Entry* along = repeat.value.find("along");
            original.path_place = along != nullptr ? along->key_place : repeat.key_place;
        }
        check_turned(reader, entry, original);
        check_motion(reader, entry);
        return original;
    }

    /// Reports `axes`, which cannot be turned.
    static void check_turned(Reader& reader, const Entry& entry, const Original& original) {
        const Entry* axes = entry.value.find("axes");
        const bool is_turned =
            !original.repeat.path.steps && original.repeat.is_turned.value_or(true);
        if (axes != nullptr && is_turned) {
            reader.error(axes->key_place,
                         "the 'axes' of " + reader.label() +
                             " cannot be turned along its 'repeat'; give 'rotate' and 'scale' "
                             "instead, or 'turn: none'");
        }
    }

    /// Reports positions of keys, to which all objects would move.
    static void check_motion(Reader& reader, const Entry& entry) {
        const Entry* motion = entry.value.find("motion");
        const Entry* keys = motion != nullptr ? motion->value.find("keys") : nullptr;
        if (keys == nullptr) {
            return;
        }
        for (const Node& key : keys->value.items) {
            if (const Entry* position = key.find("position")) {
                reader.error(position->key_place,
                             "all objects that " + quote(entry.key) +
                                 " repeats would move to the same 'position'; keys may only turn "
                                 "them");
            }
        }
    }

    void repeat(const Entry& entry, const Original& original) {
        Node prototype = entry.value;
        take(prototype, kKey);
        mark_as_repeated(prototype);
        const std::vector<RepeatPlace> places = repeat_places(original.repeat);
        if (!is_within_limits(entry, places.size(), size_of(prototype))) {
            is_whole_ = false;
            return;
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            Entry object{fmt::format("{}_{}", entry.key, i + 1), entry.key_place, prototype};
            put(object.value, original, places[i]);
            add(std::move(object));
        }
    }

    /// Reports repeated objects that, written one by one, would be too many for a file.
    bool is_within_limits(const Entry& entry, std::size_t objects, std::size_t values) {
        const YamlLimits limits;
        const auto most_objects = static_cast<std::size_t>(limits.entries_per_map);
        const auto most_values = static_cast<std::size_t>(limits.nodes);
        object_count_ += objects;
        value_count_ += objects * values;
        std::string message;
        if (object_count_ > most_objects) {
            message = beyond_limit(most_objects, "objects are repeated");
        } else if (value_count_ > most_values) {
            message = "the repeated objects have " + beyond_limit(most_values, "values");
        } else {
            return true;
        }
        problems_.error(entry.value.find(kKey)->key_place, message,
                        std::string(kSection) + "." + entry.key + "." + kKey);
        return false;
    }

    /// Replaces `at` and `rotate`.
    static void put(Node& object, const Original& original, const RepeatPlace& place) {
        const Place& at = original.path_place;
        set(object, "at", position_node(original.object.at + place.position, at));
        if (place.heading == 0) {
            return;
        }
        const Entry* rotate = object.find("rotate");
        if (rotate == nullptr) {
            set(object, "rotate", list({"0", "0", degrees(place.heading)}, at));
            return;
        }
        const Quat turn(cosine(place.heading / 2), Vec3(0, 0, sine(place.heading / 2)));
        set(object, "rotate", rotation_node(turn * original.object.rotate, at));
    }

    static void set(Node& map, const char* key, Node value) {
        mark_as_repeated(value);
        if (Entry* entry = map.find(key)) {
            entry->value = std::move(value);
        } else {
            const Place place = value.place;
            map.entries.push_back({key, place, std::move(value)});
        }
    }

    /// Adds a repeated object, merged with the object of the same name if there is one.
    void add(Entry object) {
        std::optional<Entry> own = take_own(object.key);
        if (!own) {
            objects_.entries.push_back(std::move(object));
        } else if (own->value.is_map()) {
            object.value.is_repeated = false;
            object.value.place = own->value.place;
            object.key_place = own->key_place;
            merge(object.value, std::move(own->value));
            objects_.entries.push_back(std::move(object));
        } else if (!own->value.is_null()) {
            objects_.entries.push_back(std::move(*own));  // its type is reported when it is read
        }
    }

    /// The object of the tree with that name, before or after the repeated one.
    std::optional<Entry> take_own(const std::string& name) {
        if (names_.count(name) == 0) {
            return std::nullopt;
        }
        if (std::optional<Entry> earlier = take(objects_, name)) {
            return earlier;
        }
        merged_.insert(name);
        const auto later = std::ranges::find(own_, name, &Entry::key);
        return Entry{name, later->key_place, std::move(later->value)};
    }

    Node& objects_;
    const SourceSet& sources_;
    const ConfigFolders& folders_;
    ProblemList& problems_;
    bool is_partial_ = false;
    bool is_whole_ = true;
    std::size_t object_count_ = 0;  // that were repeated so far
    std::size_t value_count_ = 0;
    std::vector<Entry> own_;        // the objects of the tree
    std::set<std::string> names_;   // of those that are not repeated themselves
    std::set<std::string> merged_;  // of those that were merged before their turn
};

}  // namespace

bool repeat_objects(Node& root, const SourceSet& sources, const ConfigFolders& folders,
                    ProblemList& problems, bool is_partial) {
    Entry* objects = root.find(kSection);
    const auto is_repeated = [](const Entry& entry) { return entry.value.find(kKey) != nullptr; };
    if (objects == nullptr || std::ranges::none_of(objects->value.entries, is_repeated)) {
        return true;
    }
    return Repeats(objects->value, sources, folders, problems, is_partial).apply();
}

}  // namespace carom::pipeline::config
