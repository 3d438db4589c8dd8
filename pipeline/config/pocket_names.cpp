#include "pipeline/config/pocket_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/billiards/layout.h"

namespace carom::pipeline::config {

namespace {

using sim::billiards::TableKind;
using sim::billiards::TableMeasures;

using Names = std::pair<std::string_view, std::string_view>;  // a player's, and the pocket's own
constexpr std::array kPlayersNames{Names{"bottom left", "corner_left_front"},
                                   Names{"bottom side", "side_front"},
                                   Names{"bottom right", "corner_right_front"},
                                   Names{"top right", "corner_right_back"},
                                   Names{"top side", "side_back"},
                                   Names{"top left", "corner_left_back"}};

std::string own_name(std::string_view players) {
    const auto found = std::find_if(kPlayersNames.begin(), kPlayersNames.end(),
                                    [&](const Names& names) { return names.first == players; });
    return found == kPlayersNames.end() ? std::string() : std::string(found->second);
}

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<std::string> pocket_names(const TableMeasures& table) {
    std::vector<std::string> names;
    if (table.has_cushions) {
        constexpr double kAnyRadius = 0.028;  // the names do not depend on it
        for (const auto& pocket : sim::billiards::make_layout(table, kAnyRadius).pockets) {
            names.push_back(pocket.pocket.name);
        }
    }
    return names;
}

std::vector<std::string> players_pocket_names(const TableMeasures& table) {
    const std::vector<std::string> own = pocket_names(table);
    std::vector<std::string> names;
    for (const auto& [players, name] : kPlayersNames) {
        if (table.kind != TableKind::snooker && has(own, name)) {
            names.emplace_back(players);
        }
    }
    return names;
}

std::string pocket_of_name(const TableMeasures& table, std::string_view name) {
    if (has(pocket_names(table), name)) {
        return std::string(name);
    }
    return has(players_pocket_names(table), name) ? own_name(name) : std::string();
}

std::string ambiguous_pocket(const TableMeasures& table, std::string_view name) {
    return table.kind == TableKind::snooker && has(pocket_names(table), own_name(name))
               ? own_name(name)
               : std::string();
}

}  // namespace carom::pipeline::config
