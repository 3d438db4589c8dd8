#include "pipeline/config/emit_yaml.h"

#include <algorithm>

#include <fmt/core.h>

namespace carom::pipeline::config {

namespace {

using Replaced = std::map<const Node*, std::string>;

/// Whether a plain scalar has the same meaning everywhere, also inside [ ] and { }.
bool is_safe_plain(const std::string& text) {
    const auto is_safe = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '.' || c == '/' || c == '+' || c == '-' || c == '^' || c == ' ';
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), is_safe) && text.front() != ' ' &&
           text.back() != ' ' && text.front() != '^' &&
           !(text.front() == '-' && (text.size() < 2 || text[1] == ' ' || text[1] == '-')) &&
           text != "..." && text != "null" && text != "Null" && text != "NULL";
}

std::string double_quoted(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (byte < 0x20 || byte == 0x7F) {
            quoted += fmt::format("\\x{:02X}", byte);
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

std::string scalar_text(const Node& node) {
    return !node.quoted && is_safe_plain(node.text) ? node.text : double_quoted(node.text);
}

std::string key_text(const std::string& key) {
    const bool is_word = is_safe_plain(key) && key.find(' ') == std::string::npos;
    return is_word ? key : double_quoted(key);
}

/// A value in flow style, on one line.
std::string flow(const Node& node, const Replaced& replaced) {
    const auto found = replaced.find(&node);
    if (found != replaced.end()) {
        return double_quoted(found->second);
    }
    switch (node.kind) {
        case Node::Kind::null:
            return "null";
        case Node::Kind::scalar:
            return scalar_text(node);
        case Node::Kind::sequence: {
            std::string text = "[";
            for (const Node& item : node.items) {
                text += (text.size() > 1 ? ", " : "") + flow(item, replaced);
            }
            return text + "]";
        }
        case Node::Kind::map: {
            std::string text = "{";
            for (const Entry& entry : node.entries) {
                text += (text.size() > 1 ? ", " : "") + key_text(entry.key) + ": " +
                        flow(entry.value, replaced);
            }
            return text + "}";
        }
    }
    return {};
}

}  // namespace

std::string emit_flow(const Node& node, const Replaced& replaced) {
    return flow(node, replaced);
}

std::string emit_key(const std::string& key) {
    return key_text(key);
}

std::string emit_yaml(const Node& root, const Replaced& replaced) {
    if (!root.is_map()) {
        return flow(root, replaced) + "\n";
    }
    std::string text;
    for (const Entry& section : root.entries) {
        text += key_text(section.key) + ":";
        if (section.value.is_map() && !section.value.entries.empty()) {
            text += "\n";
            for (const Entry& entry : section.value.entries) {
                text += "  " + key_text(entry.key) + ": " + flow(entry.value, replaced) + "\n";
            }
        } else if (section.value.is_sequence() && !section.value.items.empty()) {
            text += "\n";
            for (const Node& item : section.value.items) {
                text += "  - " + flow(item, replaced) + "\n";
            }
        } else {
            text += " " + flow(section.value, replaced) + "\n";
        }
    }
    return text;
}

}  // namespace carom::pipeline::config
