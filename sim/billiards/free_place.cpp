#include "sim/billiards/free_place.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom::sim::billiards {
namespace {

/// Keeps a place that touches the limit from being inside it by rounding, m.
constexpr double kRounding = 1e-9;

/// The spots of snooker from the highest value to the lowest.
std::vector<Spot> highest_first(const TableMeasures& table) {
    std::vector<Spot> spots = snooker_spots(table);
    std::reverse(spots.begin(), spots.end());
    return spots;
}

/// The spots of carom on which a ball is put back.
std::vector<Spot> long_axis_spots(const TableMeasures& table) {
    return pool_spots(table);  // foot, head, centre
}

bool has_spot(const std::vector<Spot>& spots, std::string_view name) {
    return find_spot(spots, name).has_value();
}

}  // namespace

void FreePlaces::take(std::string_view name) {
    std::erase_if(balls_, [&](const LyingBall& ball) { return ball.name == name; });
}

const LyingBall* FreePlaces::occupant(const Vec2& place, double radius) const {
    const auto found = std::find_if(balls_.begin(), balls_.end(), [&](const LyingBall& ball) {
        const Vec2 way = ball.place - place;
        const double reach = ball.radius + radius + kApart;
        return way.dot(way) < reach * reach;
    });
    return found == balls_.end() ? nullptr : &*found;
}

std::optional<FreePlace> FreePlaces::first_free(const std::vector<Spot>& spots,
                                                double radius) const {
    for (const Spot& spot : spots) {
        if (is_free(spot.place, radius)) {
            return FreePlace{spot.place, spot.name};
        }
    }
    return std::nullopt;
}

std::optional<Vec2> FreePlaces::along_table(const Vec2& from, double direction,
                                            double radius) const {
    const double limit = 0.5 * table_.length - radius - kApart;
    Vec2 place = from;
    while (std::abs(place.x) <= limit || !table_.has_cushions) {
        const LyingBall* ball = occupant(place, radius);
        if (ball == nullptr) {
            return place;
        }
        // The end of the part of the line that this ball blocks.
        const double reach = ball->radius + radius + kApart + kRounding;
        const double aside = ball->place.y - place.y;
        const double along = std::sqrt(std::max(reach * reach - aside * aside, 0.0));
        const double next = ball->place.x + direction * along;
        place.x = (next - place.x) * direction > kRounding ? next : place.x + direction * kRounding;
    }
    return std::nullopt;
}

std::optional<FreePlace> next_place(const FreePlaces& places, const TableMeasures& table,
                                    const Vec2& at, std::string_view spot, double radius) {
    std::optional<FreePlace> other;
    if (has_spot(snooker_spots(table), spot)) {
        other = places.first_free(highest_first(table), radius);
    } else if (table.kind == TableKind::carom && !spot.empty()) {
        other = places.first_free(long_axis_spots(table), radius);
    }
    if (other) {
        return other;
    }
    for (const double direction : {1.0, -1.0}) {
        if (const auto place = places.along_table(at, direction, radius)) {
            return FreePlace{*place, {}};
        }
    }
    return std::nullopt;
}

}  // namespace carom::sim::billiards
