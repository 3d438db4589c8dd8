#include "pipeline/config/open_strikes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {
namespace {

Node scalar(const std::string& text, const Place& place) {
    Node node;
    node.kind = Node::Kind::scalar;
    node.place = place;
    node.text = text;
    return node;
}

void set_value(Node& map, const char* key, Node value) {
    if (Entry* known = map.find(key)) {
        value.place = known->value.place;
        known->value = std::move(value);
        return;
    }
    const Place place = value.place;
    map.entries.push_back({key, place, std::move(value)});
}

/// The strike of that event; null if it is none.
Node* strike_at(Node& root, std::size_t event) {
    Entry* events = root.find("events");
    if (events == nullptr || event >= events->value.items.size()) {
        return nullptr;
    }
    Node& node = events->value.items[event];
    Entry* strike = node.is_map() ? node.find("strike") : nullptr;
    return strike != nullptr && strike->value.is_map() ? &strike->value : nullptr;
}

bool has_any(const Node& map, std::span<const std::string_view> keys) {
    return std::ranges::any_of(keys,
                               [&](std::string_view key) { return map.find(key) != nullptr; });
}

constexpr std::array<std::string_view, 2> kDirectionKeys{"direction", "toward"};
constexpr std::array<std::string_view, 2> kSpeedKeys{"speed", "ball_speed"};

bool lacks_direction(const Node& strike) {
    return !has_any(strike, kDirectionKeys) && !has_any(strike, aim_keys());
}

bool is_open(const Node& strike) {
    return lacks_direction(strike) || !has_any(strike, kSpeedKeys);
}

/// The number that `solve` gives, or that of the first strike that lacks something.
std::optional<std::size_t> event_of(Node& root, const Node& solve) {
    if (const Entry* number = solve.find("strike")) {
        const std::string& text = number->value.text;
        std::size_t event = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), event);
        return error == std::errc() && end == text.data() + text.size() ? std::optional(event)
                                                                        : std::nullopt;
    }
    const Entry* events = root.find("events");
    const std::size_t count = events != nullptr ? events->value.items.size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Node* strike = strike_at(root, i);
        if (strike != nullptr && is_open(*strike)) {
            return i;
        }
    }
    return std::nullopt;
}

bool wants_flight(const Node& solve) {
    const Entry* wants = solve.find("want");
    return wants != nullptr && std::ranges::any_of(wants->value.items, [](const Node& want) {
               return want.is_map() && want.find("clears") != nullptr;
           });
}

}  // namespace

std::vector<OpenStrike> open_strikes(Node& root) {
    std::vector<OpenStrike> open;
    Entry* solve = root.is_map() ? root.find("solve") : nullptr;
    if (solve == nullptr) {
        return open;
    }
    const std::vector<Node> all =
        solve->value.is_sequence() ? solve->value.items : std::vector<Node>{solve->value};
    for (const Node& each : all) {
        const std::optional<std::size_t> event = event_of(root, each);
        Node* strike = event ? strike_at(root, *event) : nullptr;
        if (strike == nullptr) {
            open.push_back({event.value_or(~std::size_t{0})});
            continue;
        }
        const bool lacks_elevation = strike->find("elevation") == nullptr;
        const OpenStrike found{*event,
                               lacks_direction(*strike),
                               !has_any(*strike, kSpeedKeys),
                               strike->find("tip") == nullptr,
                               lacks_elevation && wants_flight(each),
                               lacks_elevation && !wants_flight(each) && lacks_direction(*strike)};
        if (found.finds_direction) {
            set_value(*strike, "direction", scalar("0 deg", each.place));
        }
        if (found.finds_speed) {
            set_value(*strike, "speed", scalar("2 m/s", each.place));
        }
        open.push_back(found);
    }
    return open;
}

void write_found(Node& root, const std::vector<FoundStrike>& found) {
    for (const FoundStrike& each : found) {
        Node* strike = strike_at(root, each.event);
        for (const auto& [key, value] : each.values) {
            if (key != "tip") {
                set_value(*strike, key.c_str(), scalar(value, strike->place));
                continue;
            }
            // "[0.1, -0.2]"
            const std::size_t comma = value.find(',');
            Node tip;
            tip.kind = Node::Kind::sequence;
            tip.place = strike->place;
            tip.items = {scalar(value.substr(1, comma - 1), strike->place),
                         scalar(value.substr(comma + 2, value.size() - comma - 3), strike->place)};
            set_value(*strike, "tip", std::move(tip));
        }
    }
    std::erase_if(root.entries, [](const Entry& entry) { return entry.key == "solve"; });
}

namespace {

/// The byte of a place; columns count code points.
std::size_t offset_of(const std::string& text, const Place& place) {
    std::size_t offset = 0;
    for (int line = 1; line < place.line; ++line) {
        offset = text.find('\n', offset) + 1;
    }
    for (int column = 1; column < place.column; ++column) {
        do {
            ++offset;
        } while (offset < text.size() &&
                 (static_cast<unsigned char>(text[offset]) & 0xC0U) == 0x80U);
    }
    return offset;
}

/// The brace that closes the one at `begin`, without those in quotes and comments.
std::size_t closing_brace(const std::string& text, std::size_t begin) {
    int depth = 0;
    char quote = '\0';
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != '\0') {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '#' && text[i - 1] == ' ') {
            i = std::min(text.find('\n', i), text.size());
        } else if (c == '{' || c == '[') {
            ++depth;
        } else if ((c == '}' || c == ']') && --depth == 0) {
            return i;
        }
    }
    throw Error("the strike cannot be written: its braces do not end");
}

/// Removes the block of the key `solve`, up to the next line that begins at its margin.
std::string without_solve(const std::string& text) {
    const std::size_t first = text.starts_with("solve:") ? 0 : text.find("\nsolve:");
    if (first == std::string::npos) {
        throw Error(
            "'solve' stands in an included file or in braces; -o writes the shot without "
            "includes");
    }
    const std::size_t begin = first == 0 ? 0 : first + 1;
    std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const auto belongs = [&](char c) { return c == ' ' || c == '-' || c == '\n' || c == '\r'; };
    std::size_t kept = end;  // blank lines after the block stay
    while (end < text.size() && belongs(text[end])) {
        const bool is_blank = text[end] == '\n' || text[end] == '\r';
        end = std::min(text.find('\n', end), text.size() - 1) + 1;
        kept = is_blank ? kept : end;
    }
    const bool is_between_blanks = begin >= 2 && text[begin - 2] == '\n' && kept < end;
    return text.substr(0, begin) + text.substr(is_between_blanks ? end : kept);
}

}  // namespace

std::string text_with_found(const std::string& text, const Node& root,
                            const std::vector<FoundStrike>& found) {
    std::string result = text;
    // From the last one on, so that the places of the others stay.
    std::vector<FoundStrike> sorted = found;
    std::ranges::sort(sorted, std::greater<>(), &FoundStrike::event);
    for (const FoundStrike& each : sorted) {
        const Node& strike = root.find("events")->value.items.at(each.event).find("strike")->value;
        if (strike.place.source != 0) {
            throw Error("a strike stands in an included file; -o writes the shot without includes");
        }
        const std::size_t at = offset_of(result, strike.place);
        const bool is_flow = result.at(at) == '{';
        const std::string margin(static_cast<std::size_t>(strike.place.column - 1), ' ');
        std::string inserted;
        for (const auto& [key, value] : each.values) {
            inserted += is_flow ? fmt::format(", {}: {}", key, value)
                                : fmt::format("{}: {}\n{}", key, value, margin);
        }
        result.insert(is_flow ? closing_brace(result, at) : at, inserted);
    }
    return without_solve(result);
}

}  // namespace carom::pipeline::config
