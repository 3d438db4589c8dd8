#include "pipeline/config/merge.h"

#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

struct Segment {
    std::string name;
    Place place;
};

/// "cameras[0].fov" as cameras, 0, fov; empty if a part is missing.
std::vector<Segment> split_path(const SourceSet& sources, int source, std::string_view path) {
    std::vector<Segment> segments;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= path.size(); ++i) {
        const char c = i < path.size() ? path[i] : '.';
        if (c != '.' && c != '[' && c != ']') {
            continue;
        }
        const bool follows_bracket = i > 0 && path[i - 1] == ']';
        if (i > begin) {
            segments.push_back({std::string(path.substr(begin, i - begin)),
                                sources.place_at(source, begin, i - begin)});
        } else if (!follows_bracket) {
            return {};
        }
        begin = i + 1;
    }
    return segments;
}

/// The element whose index or key `name` is `name`, or nullptr.
template <class MaybeConstNode>
MaybeConstNode* find_element(MaybeConstNode& list, const std::string& name) {
    std::size_t index = 0;
    const auto [end, code] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (code == std::errc() && end == name.data() + name.size()) {
        return index < list.items.size() ? &list.items[index] : nullptr;
    }
    for (auto& item : list.items) {
        const Entry* own_name = item.find("name");
        if (own_name != nullptr && own_name->value.text == name) {
            return &item;
        }
    }
    return nullptr;
}

/// Goes one step down; nullptr after a problem.
Node* step_into(Node& node, const Segment& segment, ProblemList& problems) {
    if (node.is_sequence()) {
        Node* element = find_element(node, segment.name);
        if (element == nullptr) {
            problems.error(segment.place,
                           fmt::format("the list has no element {}; it has {}, numbered from 0",
                                       quote(segment.name), node.items.size()));
        }
        return element;
    }
    if (!node.is_map()) {
        // A scalar is replaced by a map: "shutter: 180 deg" by shutter.position=start.
        node = Node{};
        node.kind = Node::Kind::map;
        node.place = segment.place;
    }
    if (Entry* entry = node.find(segment.name)) {
        return &entry->value;
    }
    node.entries.push_back({segment.name, segment.place, Node{}});
    node.entries.back().value.place = segment.place;
    return &node.entries.back().value;
}

/// The path as nested maps around the value.
void put(Node& root, const std::vector<Segment>& path, Node value, ProblemList& problems) {
    Node* parent = &root;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        parent = step_into(*parent, path[i], problems);
        if (parent == nullptr) {
            return;
        }
    }
    const Segment& last = path.back();
    if (parent->is_sequence()) {
        if (Node* element = step_into(*parent, last, problems)) {
            if (element->is_map() && value.is_map()) {
                merge(*element, std::move(value));
            } else {
                *element = std::move(value);
            }
        }
        return;
    }
    Node map;
    map.kind = Node::Kind::map;
    map.place = last.place;
    map.entries.push_back({last.name, last.place, std::move(value)});
    if (parent->is_map()) {
        merge(*parent, std::move(map));
    } else {
        *parent = std::move(map);
    }
}

}  // namespace

void merge(Node& base, Node over) {
    if (!base.is_map() || !over.is_map()) {
        base = std::move(over);
        return;
    }
    for (Entry& entry : over.entries) {
        Entry* known = base.find(entry.key);
        if (known == nullptr) {
            base.entries.push_back(std::move(entry));
        } else if (entry.value.is_null()) {
            base.entries.erase(base.entries.begin() + (known - base.entries.data()));
        } else {
            known->key_place = entry.key_place;
            merge(known->value, std::move(entry.value));
        }
    }
    base.place = over.place;
}

const Node* value_at(const Node& root, const std::string& path) {
    SourceSet sources;
    const Node* node = &root;
    for (const Segment& segment : split_path(sources, sources.add({"", "", path}), path)) {
        if (node != nullptr && node->is_sequence()) {
            node = find_element(*node, segment.name);
            continue;
        }
        const Entry* entry = node != nullptr ? node->find(segment.name) : nullptr;
        node = entry != nullptr ? &entry->value : nullptr;
    }
    return node;
}

void apply_override(Node& root, SourceSet& sources, int source, ProblemList& problems) {
    const std::string text = sources.at(source).text;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        problems.error(sources.place_at(source, 0, text.size()),
                       quote(text) + " is not of the form KEY=VALUE, as in render.samples=64");
        return;
    }
    const std::vector<Segment> path =
        split_path(sources, source, std::string_view(text).substr(0, equals));
    if (path.empty()) {
        problems.error(
            sources.place_at(source, 0, equals),
            quote(text.substr(0, equals)) + " is not a path of keys, as in render.samples");
        return;
    }
    std::optional<Node> value = parse_yaml(sources, source, problems, {}, equals + 1);
    if (value) {
        put(root, path, std::move(*value), problems);
    }
}

}  // namespace carom::pipeline::config
