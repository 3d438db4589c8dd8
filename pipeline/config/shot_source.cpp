#include "pipeline/config/shot_source.h"

#include <charconv>
#include <optional>

namespace carom::pipeline {

using config::Entry;
using config::Node;
using config::Place;

namespace {

std::optional<std::size_t> index_of(const std::string& text) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(index)
                                                                    : std::nullopt;
}

}  // namespace

Problem ShotSource::problem_at(const std::vector<std::string>& path, Severity severity,
                               std::string message) const {
    const Node* node = &root_;
    Place place = root_.place;
    std::string key_path;
    for (const std::string& step : path) {
        if (node->is_sequence()) {
            const std::optional<std::size_t> index = index_of(step);
            if (!index || *index >= node->items.size()) {
                break;
            }
            node = &node->items[*index];
            place = node->place;
            key_path += "[" + step + "]";
            continue;
        }
        const Entry* entry = node->find(step);
        if (entry == nullptr) {
            break;
        }
        place = entry->key_place;
        node = &entry->value;
        key_path += (key_path.empty() ? "" : ".") + step;
    }
    return {severity,           sources_.describe(place), std::move(key_path),
            std::move(message), sources_.line_of(place),  sources_.trail(place)};
}

}  // namespace carom::pipeline
