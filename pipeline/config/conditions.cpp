#include "pipeline/config/conditions.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "core/text.h"
#include "pipeline/config/gather.h"
#include "pipeline/config/key_conditions.h"
#include "pipeline/config/merge.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr const char* kSection = "conditions";

Node empty_map(const Place& place) {
    Node map;
    map.kind = Node::Kind::map;
    map.place = place;
    return map;
}

/// The value of that key if it is a map; nullptr otherwise.
Node* map_at(Node* parent, std::string_view key) {
    Entry* entry = parent != nullptr ? parent->find(key) : nullptr;
    return entry != nullptr && entry->value.is_map() ? &entry->value : nullptr;
}

Node& add_map(Node& parent, const std::string& key, const Place& place) {
    if (Node* known = map_at(&parent, key)) {
        return *known;
    }
    parent.entries.push_back({key, place, empty_map(place)});
    return parent.entries.back().value;
}

/// The text of a scalar at `root`.section.key, or nothing.
std::string word_at(Node& root, std::string_view section, std::string_view key) {
    const Node* map = map_at(&root, section);
    const Entry* entry = map != nullptr ? map->find(key) : nullptr;
    return entry != nullptr && entry->value.is_scalar() ? entry->value.text : std::string();
}

/// The kind of ball, as build/balls.cpp chooses it.
std::string kind_of_balls(Node& root) {
    for (const std::string& kind :
         {word_at(root, "ball_set", "kind"), word_at(root, "table", "kind")}) {
        if (kind == "snooker" || kind == "carom" || kind == "pool") {
            return kind;
        }
    }
    return "pool";
}

class Conditions {
  public:
    Conditions(Node& root, SourceSet& sources, const ConfigFolders& folders, ProblemList& problems,
               bool is_partial)
        : root_(root),
          sources_(sources),
          folders_(folders),
          problems_(problems),
          is_partial_(is_partial) {}

    void apply() {
        take_section();
        Node* physics = map_at(&root_, "physics");
        if (physics == nullptr) {
            return;
        }
        Node numbers = empty_map(physics->place);
        Node used = empty_map(place_);
        for (const ConditionKey& key : condition_keys()) {
            const Entry* word = physics->find(key.name);
            if (word == nullptr || !word->value.is_scalar()) {
                continue;  // a wrong type is reported when the section is read
            }
            if (const Node* found = find(key, word->value)) {
                if (is_valid_) {
                    merge(numbers, *found);
                }
                add_map(add_map(used, key.name, found->place), word->value.text, found->place);
            }
        }
        merge(numbers, std::move(*physics));
        *physics = std::move(numbers);
        put_words_first(*physics);
        if (!used.entries.empty()) {
            const auto after = std::find_if(root_.entries.begin(), root_.entries.end(),
                                            [](const Entry& e) { return e.key == "physics"; });
            root_.entries.insert(after + 1, {kSection, place_, std::move(used)});
        }
    }

  private:
    /// Moves `conditions` out of the shot and checks it.
    void take_section() {
        const auto found = std::find_if(root_.entries.begin(), root_.entries.end(),
                                        [](const Entry& entry) { return entry.key == kSection; });
        if (found == root_.entries.end()) {
            place_ = root_.place;
        } else if (!found->value.is_null()) {  // which is reported when the shot is read
            place_ = found->key_place;
            own_ = std::move(found->value);
            root_.entries.erase(found);
            check(own_);
        }
    }

    void check(const Node& conditions) {
        ProblemList found(sources_);
        read(conditions, found);
        if (found.has_error()) {
            is_valid_ = false;  // otherwise the same problems would be found in `physics`
            read(conditions, problems_);
        }
    }

    void read(const Node& conditions, ProblemList& problems) const {
        Reader reader(sources_, folders_, problems);
        const Reader::Scope scope(reader, kSection, place_);
        NotStored ignored;
        conditions_spec().read(reader, conditions, ignored);
    }

    /// The numbers of a word of `physics`; nullptr after a problem.
    const Node* find(const ConditionKey& key, const Node& word) {
        if (const Node* found = map_at(map_at(&own_, key.name), word.text)) {
            return found;
        }
        read_standard(word.place);
        if (const Node* found = map_at(map_at(&standard_, key.name), word.text)) {
            return found;
        }
        if (!is_partial_) {
            report_unknown(key, word);
        }
        return nullptr;
    }

    /// Reads the conditions of configs/balls once.
    void read_standard(const Place& named_at) {
        if (std::exchange(has_read_standard_, true)) {
            return;
        }
        const std::string name = "balls/" + kind_of_balls(root_) + ".yaml";
        std::optional<Node> file = read_config(sources_, name, named_at, folders_, problems_);
        if (Node* conditions = file ? map_at(&*file, kSection) : nullptr) {
            standard_ = std::move(*conditions);
            check(standard_);
        }
    }

    void report_unknown(const ConditionKey& key, const Node& word) {
        const Node* own = map_at(&own_, key.name);
        if (own != nullptr && own->find(word.text) != nullptr) {
            return;  // its value is not a map, which was reported
        }
        std::vector<std::string> known;
        for (Node* conditions : {&standard_, &own_}) {
            const Node* words = map_at(conditions, key.name);
            for (const Entry& entry : words != nullptr ? words->entries : std::vector<Entry>()) {
                if (entry.value.is_map() &&
                    std::find(known.begin(), known.end(), entry.key) == known.end()) {
                    known.push_back(entry.key);
                }
            }
        }
        const Message message =
            "'" + key.name + "' of 'physics' must be " +
            (known.empty() ? "a word of 'conditions'"
                           : (known.size() > 1 ? "one of " : "") + enumerate(known, "and")) +
            ", not " + quote(word.text) + hint(word.text, known);
        problems_.error(word.place, message, "physics." + key.name);
    }

    static void put_words_first(Node& physics) {
        const std::span<const ConditionKey> keys = condition_keys();
        std::stable_partition(
            physics.entries.begin(), physics.entries.end(), [&](const Entry& entry) {
                return std::any_of(keys.begin(), keys.end(),
                                   [&](const ConditionKey& key) { return key.name == entry.key; });
            });
    }

    Node& root_;
    SourceSet& sources_;
    const ConfigFolders& folders_;
    ProblemList& problems_;
    bool is_partial_ = false;
    Place place_;    // of `conditions`
    Node own_;       // those of the shot and of the files that it includes
    Node standard_;  // those of configs/balls, if they are needed
    bool has_read_standard_ = false;
    bool is_valid_ = true;
};

/// The keys of `physics.stick` and the keys of a strike that they replace.
constexpr std::array<std::pair<const char*, const char*>, 3> kStickKeys{
    {{"tip_restitution", "tip_restitution"},
     {"end_mass_ratio", "end_mass_ratio"},
     {"mass", "stick_mass"}}};

/// The table of the keys of a strike.
const MapInfo& strike_info() {
    const std::vector<KeyInfo>& kinds = event_spec().info().keys;
    return *std::find_if(kinds.begin(), kinds.end(), [](const KeyInfo& key) {
                return key.name == "strike";
            })->type.map;
}

void add_stick(Node& strike, const Node& stick) {
    const MapInfo& info = strike_info();
    for (const auto& [from, to] : kStickKeys) {
        const Entry* number = stick.find(from);
        const auto key = std::find_if(info.keys.begin(), info.keys.end(),
                                      [name = to](const KeyInfo& k) { return k.name == name; });
        if (number != nullptr && strike.find(to) == nullptr && can_be_added(info, *key, strike)) {
            strike.entries.push_back({to, number->key_place, number->value});
        }
    }
}

/// Whether the section has no problem; they are reported when it is read as a part of `physics`.
bool is_valid_stick(const Node& stick, const SourceSet& sources, const ConfigFolders& folders) {
    ProblemList unseen(sources);
    Reader reader(sources, folders, unseen);
    sim::Strike ignored;
    stick_spec().read(reader, stick, ignored);
    return !unseen.has_error();
}

void apply_stick(Node& root, const SourceSet& sources, const ConfigFolders& folders) {
    const Node* stick = map_at(map_at(&root, "physics"), "stick");
    Entry* events = root.find("events");
    if (stick == nullptr || events == nullptr || !is_valid_stick(*stick, sources, folders)) {
        return;
    }
    for (Node& event : events->value.items) {
        if (Node* strike = map_at(&event, "strike")) {
            add_stick(*strike, *stick);
        }
    }
}

}  // namespace

std::span<const ConditionKey> condition_keys() {
    static const std::vector<ConditionKey> keys{
        {"cloth", "the cloth", {"new", "worn"}},
        {"cushions", "the cushions", {"lively", "normal", "dead"}},
        {"balls", "the surface of the balls", {"polished", "used", "dirty", "clinging"}},
        {"tip", "the tip of the stick", {"leather", "phenolic"}},
        {"shaft", "the shaft of the stick", {"regular", "low_deflection"}}};
    return keys;
}

void apply_conditions(Node& root, SourceSet& sources, const ConfigFolders& folders,
                      ProblemList& problems, bool is_partial) {
    if (!root.is_map()) {
        return;
    }
    Conditions(root, sources, folders, problems, is_partial).apply();
    apply_stick(root, sources, folders);
}

}  // namespace carom::pipeline::config
