#include "pipeline/config/open_strikes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

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
        const OpenStrike found{*event, lacks_direction(*strike), !has_any(*strike, kSpeedKeys),
                               strike->find("tip") == nullptr,
                               strike->find("elevation") == nullptr && wants_flight(each)};
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
        Node* strike = strike_at(root, each.strike.event);
        if (strike == nullptr) {
            continue;
        }
        if (each.strike.finds_direction) {
            set_value(*strike, "direction", scalar(each.direction, strike->place));
        }
        if (each.strike.finds_speed) {
            set_value(*strike, "speed", scalar(each.speed, strike->place));
        }
        if (each.strike.finds_tip) {
            Node tip;
            tip.kind = Node::Kind::sequence;
            tip.place = strike->place;
            tip.items = {scalar(each.tip_right, strike->place), scalar(each.tip_up, strike->place)};
            set_value(*strike, "tip", std::move(tip));
        }
        if (each.strike.finds_elevation) {
            set_value(*strike, "elevation", scalar(each.elevation, strike->place));
        }
    }
    std::erase_if(root.entries, [](const Entry& entry) { return entry.key == "solve"; });
}

}  // namespace carom::pipeline::config
