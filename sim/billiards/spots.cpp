#include "sim/billiards/spots.h"

#include <algorithm>

namespace carom::sim::billiards {

std::vector<Spot> pool_spots(const TableMeasures& table) {
    const double quarter = 0.25 * table.length;
    return {{"foot", {quarter, 0}}, {"head", {-quarter, 0}}, {"centre", {0, 0}}};
}

std::vector<Spot> snooker_spots(const TableMeasures& table) {
    const double scale = table.length / 3.569;
    const double baulk = -0.5 * table.length + 0.737 * scale;
    const double d_radius = 0.292 * scale;
    return {{"yellow", {baulk, -d_radius}},
            {"green", {baulk, d_radius}},
            {"brown", {baulk, 0}},
            {"blue", {0, 0}},
            {"pink", {0.25 * table.length, 0}},
            {"black", {0.5 * table.length - 0.324 * scale, 0}}};
}

std::vector<Spot> carom_spots(const TableMeasures& table) {
    std::vector<Spot> spots = pool_spots(table);
    const double quarter = 0.25 * table.length;
    const double aside = 0.1825 * table.length / 2.84;
    spots.push_back({"head_left", {-quarter, aside}});
    spots.push_back({"head_right", {-quarter, -aside}});
    return spots;
}

std::vector<Spot> spots_of(const TableMeasures& table) {
    switch (table.kind) {
        case TableKind::pool:
            return pool_spots(table);
        case TableKind::snooker:
            return snooker_spots(table);
        case TableKind::carom:
            return carom_spots(table);
        case TableKind::cloth:
            return {};
        case TableKind::custom:
            break;
    }
    std::vector<Spot> spots = pool_spots(table);
    for (Spot& spot : snooker_spots(table)) {
        spots.push_back(std::move(spot));
    }
    return spots;
}

std::optional<Vec2> find_spot(const std::vector<Spot>& spots, std::string_view name) {
    const auto found = std::find_if(spots.begin(), spots.end(),
                                    [&](const Spot& spot) { return spot.name == name; });
    return found == spots.end() ? std::nullopt : std::optional(found->place);
}

}  // namespace carom::sim::billiards
