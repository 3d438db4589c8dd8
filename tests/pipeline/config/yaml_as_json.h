// YAML as the value that tools for JSON read.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/config/parse_yaml.h"

namespace carom::testing {

/// Converts YAML to JSON by the core schema of YAML 1.2, like an editor.
inline nlohmann::json to_json(const pipeline::config::Node& node) {
    switch (node.kind) {
        case pipeline::config::Node::Kind::null:
            return nullptr;
        case pipeline::config::Node::Kind::sequence: {
            nlohmann::json list = nlohmann::json::array();
            for (const pipeline::config::Node& item : node.items) {
                list.push_back(to_json(item));
            }
            return list;
        }
        case pipeline::config::Node::Kind::map: {
            nlohmann::json map = nlohmann::json::object();
            for (const pipeline::config::Entry& entry : node.entries) {
                map[entry.key] = to_json(entry.value);
            }
            return map;
        }
        case pipeline::config::Node::Kind::scalar:
            break;
    }
    if (!node.quoted) {
        if (node.text == "true" || node.text == "false") {
            return node.text == "true";
        }
        const char* const begin = node.text.data() + (node.text.starts_with('+') ? 1 : 0);
        const char* const end = node.text.data() + node.text.size();
        std::int64_t whole = 0;
        if (const auto [stop, code] = std::from_chars(begin, end, whole);
            stop == end && code == std::errc()) {
            return whole;
        }
        double number = 0;
        if (const auto [stop, code] = std::from_chars(begin, end, number);
            stop == end && code == std::errc() &&
            node.text.find_first_of("in") == std::string::npos) {
            return number;
        }
    }
    return node.text;
}

}  // namespace carom::testing
