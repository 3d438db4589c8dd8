#include "pipeline/config/find_place.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/core.h>

namespace carom::pipeline::config {

namespace {

std::optional<std::size_t> index_of(const std::string& text) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(index)
                                                                    : std::nullopt;
}

bool has(const Node& root, const char* section, const std::string& key) {
    const Entry* entry = root.find(section);
    return entry != nullptr && entry->value.find(key) != nullptr;
}

/// The path of a body. Balls of the rack have no entry of their own.
std::vector<std::string> path_of_body(const std::string& name, const Node& root) {
    if (has(root, "objects", name)) {
        return {"objects", name};
    }
    return has(root, "balls", name) || root.find("rack") == nullptr
               ? std::vector<std::string>{"balls", name}
               : std::vector<std::string>{"rack"};
}

/// The path of an event. The only key of an event's entry is its kind: {"events", "0", "strike"}.
std::vector<std::string> path_of_event(std::size_t index, const Node& root) {
    std::vector<std::string> path{"events", fmt::format("{}", index)};
    const Entry* events = root.find("events");
    if (events != nullptr && index < events->value.items.size()) {
        const Node& item = events->value.items[index];
        if (!item.entries.empty()) {
            path.push_back(item.entries.front().key);
        }
    }
    return path;
}

std::vector<std::string> path_of_subject(const Subject& subject, const Node& root) {
    switch (subject.kind) {
        case Subject::Kind::world:
            return {};  // each of its fields belongs to a section
        case Subject::Kind::contact:
            return {"physics", subject.name};
        case Subject::Kind::table:
            return {"table"};
        case Subject::Kind::body:
            return path_of_body(subject.name, root);
        case Subject::Kind::event:
            return path_of_event(subject.index, root);
        case Subject::Kind::settings:
            return {"render"};
        case Subject::Kind::material:
            return {"materials", subject.name};
        case Subject::Kind::light:
            return {"lights", subject.name};
        case Subject::Kind::object:
            return {"objects", subject.name};
    }
    return {};
}

}  // namespace

FoundPlace find_place(const Node& root, const std::vector<std::string>& path) {
    FoundPlace found{root.place, {}};
    const Node* node = &root;
    for (const std::string& step : path) {
        if (node->is_sequence()) {
            const std::optional<std::size_t> index = index_of(step);
            if (!index || *index >= node->items.size()) {
                break;
            }
            node = &node->items[*index];
            found.place = node->place;
            found.key_path += "[" + step + "]";
            continue;
        }
        const Entry* entry = node->find(step);
        if (entry == nullptr) {
            break;
        }
        node = &entry->value;
        found.place = entry->key_place;
        found.key_path += (found.key_path.empty() ? "" : ".") + step;
    }
    return found;
}

std::vector<std::string> path_of(const Diagnostic& diagnostic, const Node& root) {
    std::vector<std::string> path = path_of_subject(diagnostic.subject, root);
    if (path.empty() && !diagnostic.field.empty() && diagnostic.field != "respot") {
        path.emplace_back(diagnostic.field == "gravity" ? "physics" : "simulation");
    }
    for (std::string_view rest = diagnostic.field; !rest.empty();) {
        const std::size_t dot = std::min(rest.find('.'), rest.size());
        path.emplace_back(rest.substr(0, dot));
        rest.remove_prefix(std::min(dot + 1, rest.size()));
    }
    const bool is_standard_measure = diagnostic.subject.kind == Subject::Kind::table &&
                                     path.size() > 1 && !has(root, "table", path[1]);
    return is_standard_measure ? std::vector<std::string>{"table", "kind"} : path;
}

}  // namespace carom::pipeline::config
