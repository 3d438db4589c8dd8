#include "sim/aim/find_aims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/text.h"
#include "sim/aim/ghost_ball.h"
#include "sim/aim/secant.h"
#include "sim/aim/strike_trials.h"

namespace carom::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kNear = 1e-4;              // m, too near for a direction
constexpr double kMostThrow = 6 * kDegree;  // of touching balls (docs/measured.md)
constexpr double kLongestWay = 30;          // s, of balls after a strike

double length_of(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

Vec2 level(const Vec3& v) {
    return {v.x, v.y};
}

std::string in_quotes(const std::string& name) {
    return "'" + name + "'";
}

/// ": why", or nothing.
std::string because(const std::string& reason) {
    return reason.empty() ? reason : ": " + reason;
}

/// Why no direction was found at all.
std::string reason_of(const Solved& solved) {
    return solved.instead.empty() ? "it passes beside or above it" : solved.instead;
}

/// Seeks the direction of one strike.
class Search {
  public:
    Search(StrikeTrials& trials, const Setting& setting,
           const std::optional<billiards::TableMeasures>& table)
        : trials_(trials), setting_(setting), ball_(trials.ball()), table_(table) {}

    /// Empty after a problem.
    [[nodiscard]] std::optional<double> find(const Aim& aim) {
        const billiards::LyingBall* struck = setting_.find(ball_);
        if (struck == nullptr) {
            return fail(in_quotes(ball_) + " is not on the table when it is struck");
        }
        from_ = struck->place;
        return std::visit([this](const auto& each) { return find_for(each); }, aim);
    }

    [[nodiscard]] const std::string& problem() const { return problem_; }

  private:
    /// How the struck ball meets the other one.
    struct Meeting {
        double centres = 0;  // angle from its way to the line of centres, rad
        double leaves = 0;   // angle from its way to that of the other one, rad
    };
    /// The way of a ball into a pocket.
    struct Way {
        const PocketMouth* pocket = nullptr;
        PocketWindow window;
        double cut = 0;      // rad, as the ghost ball's line has it
        std::string closed;  // why it is none; empty if it is open

        /// By how much the strike may err, in steps that are coarser than rounding.
        [[nodiscard]] double margin() const { return std::round(window.width * cosine(cut) * 1e9); }
    };

    std::optional<double> find_for(const ThroughAim& aim);
    std::optional<double> find_for(const CutAim& aim);
    std::optional<double> find_for(const HitAim& aim);
    std::optional<double> find_for(const PotAim& aim);

    std::nullopt_t fail(std::string sentence) {
        problem_ = std::move(sentence);
        return std::nullopt;
    }

    /// Whether the object and the struck ball touch before the strike.
    [[nodiscard]] bool touches(const billiards::LyingBall& object) const {
        return length_of(object.place - from_) <
               touching_distance(trials_.radius(), object.radius) + kNear;
    }
    /// Where the struck ball touches the object that it sends in that direction.
    [[nodiscard]] Vec2 ghost_of(const billiards::LyingBall& object, double direction) const {
        return object.place -
               unit_at(direction) * touching_distance(trials_.radius(), object.radius);
    }
    /// The nearest direction to it in which the object can be sent: one at a cushion can only be
    /// sent along it or into it, because the struck ball has to be on the table.
    [[nodiscard]] double possible(const billiards::LyingBall& object, double direction) const {
        const Vec2 half = Vec2(table_->length, table_->width) * 0.5 - Vec2(trials_.radius());
        const Vec2 ghost = ghost_of(object, direction);
        return angle_of(object.place - Vec2(std::clamp(ghost.x, -half.x, half.x),
                                            std::clamp(ghost.y, -half.y, half.y)));
    }

    /// Fails if the ball is not on the table.
    [[nodiscard]] const billiards::LyingBall* object_named(const std::string& name) {
        const billiards::LyingBall* object = setting_.find(name);
        if (object == nullptr) {
            fail(in_quotes(name) + " is not on the table when " + in_quotes(ball_) + " is struck");
        } else if (length_of(object->place - from_) < kNear) {
            fail(in_quotes(name) + " is straight above or below " + in_quotes(ball_));
            object = nullptr;
        }
        return object;
    }

    /// The line through `point` at right angles to the way there.
    [[nodiscard]] Line line_through(const Vec2& point) const {
        const double distance = length_of(point - from_);
        const Vec2 along = (point - from_) / distance;
        return {point, {-along.y, along.x}, std::max(distance, 4 * trials_.radius())};
    }

    /// A strike that did not make the contact that `wanted` (m, to the left of the line's point)
    /// stands for.
    [[nodiscard]] Miss missed(const Played& played, double direction, const Line& line,
                              double wanted) const;
    [[nodiscard]] Meeting meeting(double direction, const Played& played);
    [[nodiscard]] std::optional<double> find_contact(
        const std::string& target, double start, double accepted, const std::string& what,
        const std::function<Miss(const Meeting&)>& miss_of,
        const std::function<std::string(double)>& text_of);
    [[nodiscard]] Way way_into(const PocketMouth& pocket, const billiards::LyingBall& object) const;
    [[nodiscard]] std::optional<double> pot(const Way& way, const billiards::LyingBall& object);
    [[nodiscard]] Solved send(const billiards::LyingBall& object, double target,
                              std::optional<double> start);
    [[nodiscard]] std::string why_not_potted(double direction, const std::string& ball,
                                             const PocketMouth& pocket);

    StrikeTrials& trials_;
    const Setting& setting_;
    std::string ball_;
    const std::optional<billiards::TableMeasures>& table_;
    Vec2 from_{0, 0};
    std::string problem_;
};

std::optional<double> Search::find_for(const ThroughAim& aim) {
    constexpr double kTolerance = 1e-6;  // m
    const double distance = length_of(aim.point - from_);
    if (distance < kNear) {
        return fail(in_quotes(ball_) + " lies on that point when it is struck");
    }
    const Line line = line_through(aim.point);
    const Solved solved =
        solve_direction(angle_of(aim.point - from_), kTolerance, [&](double direction) {
            const Played played = trials_.play(direction, {}, line, false);
            Miss miss;
            miss.value = played.crossing;
            miss.slope = distance;
            miss.instead = played.instead;
            return miss;
        });
    if (!solved.direction || std::abs(solved.miss) > kNear) {
        return fail(in_quotes(ball_) + " cannot pass through that point" + because(solved.instead));
    }
    return solved.direction;
}

Miss Search::missed(const Played& played, double direction, const Line& line, double wanted) const {
    Miss miss;
    miss.instead = played.instead;
    if (played.crossing) {
        miss.too_far = *played.crossing > wanted ? 1 : -1;
        miss.nearer = direction + (wanted - *played.crossing) / length_of(line.point - from_);
    }
    return miss;
}

Search::Meeting Search::meeting(double direction, const Played& played) {
    const Event& contact = *played.contact;
    const double way = angle_of(trials_.velocity_before(direction, contact.time));
    const Vec3 normal = contact.a == ball_ ? -contact.normal : contact.normal;
    return {wrapped(angle_of(level(normal)) - way), wrapped(angle_of(played.velocity) - way)};
}

/// Aims until `miss_of` is at most `accepted`; `text_of` names what a miss comes to. `start`: sine
/// of the angle between the way and the line of centres, positive if it passes to the left of the
/// target's centre.
std::optional<double> Search::find_contact(const std::string& target, double start, double accepted,
                                           const std::string& what,
                                           const std::function<Miss(const Meeting&)>& miss_of,
                                           const std::function<std::string(double)>& text_of) {
    const billiards::LyingBall* object = object_named(target);
    if (object == nullptr) {
        return std::nullopt;
    }
    const double touch = touching_distance(trials_.radius(), object->radius);
    const double distance = length_of(object->place - from_);
    const Line line = line_through(object->place);
    // Balls that touch have no way between them, so their line of centres is as it is.
    const double towards =
        passing_direction(from_, object->place, start * std::min(touch, distance * (1 - 1e-9)))
            .value_or(0);
    const Solved solved = solve_direction(towards, accepted / 5, [&](double direction) {
        const Played played = trials_.play(direction, target, line, false);
        if (!played.contact) {
            return missed(played, direction, line, start * touch);
        }
        Miss miss = miss_of(meeting(direction, played));
        miss.slope *= distance / touch;
        return miss;
    });
    if (!solved.direction) {
        return fail(what + because(reason_of(solved)));
    }
    if (std::abs(solved.miss) > accepted) {
        return fail(what + "; the nearest is " + text_of(solved.miss));
    }
    return solved.direction;
}

std::optional<double> Search::find_for(const CutAim& aim) {
    const double sign = aim.side == Side::left ? 1 : -1;
    return find_contact(
        aim.ball, -sign * sine(aim.angle), 1e-3 * kDegree,
        in_quotes(ball_) + " cannot cut " + in_quotes(aim.ball) + " by " +
            decimal_text(aim.angle / kDegree, 3) + " deg",
        [&](const Meeting& met) {
            Miss miss;
            miss.value = sign * aim.angle - met.leaves;
            miss.slope = 1 / std::max(cosine(met.centres), 0.1);
            return miss;
        },
        [&](double miss) { return decimal_text((aim.angle - sign * miss) / kDegree, 3) + " deg"; });
}

std::optional<double> Search::find_for(const HitAim& aim) {
    const double wanted = (aim.side == Side::left ? 1 : -1) * (1 - aim.fullness);
    return find_contact(
        aim.ball, wanted, 1e-4,
        in_quotes(ball_) + " cannot hit " + in_quotes(aim.ball) + " with a fullness of " +
            decimal_text(aim.fullness, 4),
        [&](const Meeting& met) {
            Miss miss;
            miss.value = -sine(met.centres) - wanted;
            return miss;
        },
        [&](double miss) { return decimal_text(1 - std::abs(wanted + miss), 4); });
}

Search::Way Search::way_into(const PocketMouth& pocket, const billiards::LyingBall& object) const {
    Way way{&pocket, window_of(pocket, object.place), 0, {}};
    way.window.middle = possible(object, way.window.middle);
    const Vec2 ghost = ghost_of(object, way.window.middle);
    const double line = angle_of(object.place - from_);
    way.cut =
        std::abs(wrapped((touches(object) ? line : angle_of(ghost - from_)) - way.window.middle));
    const std::vector<std::string_view> both{ball_, object.name};
    const auto in_way = [&](const Vec2& from, const Vec2& to, double radius) {
        return first_in_way(setting_.balls, from, to, radius, both);
    };
    if (touches(object) && way.cut > 0.5 * way.window.width + kMostThrow) {
        way.closed = "it touches " + in_quotes(ball_) +
                     " and leaves along the line of their centres, " +
                     decimal_text(way.cut / kDegree, 1) + " deg beside";
    } else if (way.cut >= kRightAngle) {
        way.closed = "the cut would be " + decimal_text(way.cut / kDegree, 1) + " deg";
    } else if (way.window.width <= 0) {
        way.closed = "its jaws are in the way";
    } else if (const auto* first = in_way(from_, ghost, trials_.radius())) {
        way.closed = in_quotes(first->name) + " is in the way of " + in_quotes(ball_);
    } else if (const auto* next = in_way(object.place, pocket.middle, object.radius)) {
        way.closed = in_quotes(next->name) + " is in the way";
    }
    return way;
}

std::optional<double> Search::find_for(const PotAim& aim) {
    const billiards::LyingBall* object = object_named(aim.ball);
    if (object == nullptr) {
        return std::nullopt;
    }
    const std::vector<PocketMouth> pockets =
        table_ ? pocket_mouths(*table_, object->radius) : std::vector<PocketMouth>();
    if (pockets.empty()) {
        return fail("the table has no pockets");
    }
    std::vector<Way> open;
    std::vector<std::string> closed;
    for (const PocketMouth& pocket : pockets) {
        const Way way = way_into(pocket, *object);
        if (pocket.name == aim.pocket) {
            if (way.cut >= kRightAngle && !touches(*object)) {
                return fail(in_quotes(aim.ball) + " cannot be potted in " + pocket.name + ": " +
                            way.closed + ", and has to be less than 90 deg");
            }
            return pot(way, *object);
        }
        if (way.closed.empty()) {
            open.push_back(way);
        }
        closed.push_back(pocket.name + ": " + way.closed);
    }
    if (open.empty()) {
        return fail("no pocket is open for " + in_quotes(aim.ball) + " (" + join(closed, "; ") +
                    ")");
    }
    // The wider, the more the strike may err. Ways that differ by rounding are in the table's
    // order.
    std::stable_sort(open.begin(), open.end(),
                     [](const Way& a, const Way& b) { return a.margin() > b.margin(); });
    std::string first_problem;
    for (const Way& way : open) {
        if (const auto direction = pot(way, *object)) {
            return direction;
        }
        first_problem = first_problem.empty() ? problem_ : first_problem;
    }
    return fail(first_problem);
}

/// Aims at the middle of the window, and beside it where the ball does not fall then.
std::optional<double> Search::pot(const Way& way, const billiards::LyingBall& object) {
    std::optional<double> start;
    std::string reason;
    for (const double part : {0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75}) {
        const double beside = 0.5 * part * std::max(way.window.width, 0.0);
        const Solved solved = send(object, possible(object, way.window.middle + beside), start);
        if (!solved.direction) {
            reason = reason.empty() ? reason_of(solved) : reason;
            break;
        }
        const std::string other = why_not_potted(*solved.direction, object.name, *way.pocket);
        if (other.empty()) {
            return solved.direction;
        }
        reason = reason.empty() ? other : reason;
        start = solved.direction;
        if (beside == 0 && part != 0) {
            break;
        }
    }
    return fail(in_quotes(object.name) + " is not potted in " + way.pocket->name +
                because(way.closed.empty() ? reason : way.closed));
}

/// Sends the ball in the direction `target`, to the end of its free way.
Solved Search::send(const billiards::LyingBall& object, double target,
                    std::optional<double> start) {
    const double touch = touching_distance(trials_.radius(), object.radius);
    const Vec2 ghost = touches(object) ? object.place : ghost_of(object, target);
    const Line line = line_through(object.place);
    const double wanted = (ghost - object.place).dot(line.across);
    const double distance = length_of(object.place - from_);
    return solve_direction(start.value_or(angle_of(ghost - from_)), 2e-5, [&](double direction) {
        const Played played = trials_.play(direction, object.name, line, true);
        if (!played.contact) {
            return missed(played, direction, line, wanted);
        }
        Miss miss;
        if (!played.end) {
            miss.instead = played.instead;
            return miss;
        }
        const Vec2 begin = trials_.centre_of(object.name, *played.contact);
        const Vec2 end = trials_.centre_of(object.name, *played.end);
        miss.value = wrapped(target - angle_of(end - begin));
        if (touches(object)) {  // then only friction turns it, to the side of the aim
            miss.value = -*miss.value;
            miss.slope = 0.1;
            return miss;
        }
        const double cut = wrapped(angle_of(begin - from_) - target);
        miss.slope = distance / (touch * std::max(cosine(cut), 0.1));
        return miss;
    });
}

/// What happens instead of the pot; empty if the ball falls into that pocket.
std::string Search::why_not_potted(double direction, const std::string& ball,
                                   const PocketMouth& pocket) {
    const std::optional<Event> end = trials_.end_of(direction, ball);
    if (!end) {
        return "the shot ends before that";
    }
    if (end->kind == EventKind::resting) {
        return fmt::format("it comes to rest {:.2f} m from it",
                           length_of(level(end->place) - pocket.middle));
    }
    return end->kind == EventKind::off_table ? "it leaves the table"
           : end->b != pocket.name           ? "it falls into " + end->b
                                             : std::string();
}

constexpr std::array kFields{"pot", "cut", "hit", "through"};  // of the kinds of aims

}  // namespace

double FoundDirection::radians() const {
    return from_microdegrees(microdegrees);
}

FoundAims find_aims(WorldDescription world, const std::vector<AimedStrike>& aims) {
    // A shot may end before its ball falls.
    world.duration = std::min(world.duration + kLongestWay, 3600.0);
    for (const AimedStrike& aim : aims) {
        auto& strike = std::get<Strike>(world.events[aim.event].action);
        strike.toward.reset();
        strike.toward_point.reset();
        strike.direction = 0;
    }
    const Trials trials(std::move(world));
    std::vector<ForceEvent> events = trials.world().events;
    std::vector<AimedStrike> open = aims;
    FoundAims found;
    while (!open.empty()) {
        std::vector<std::size_t> strikes;
        strikes.reserve(open.size());
        for (const AimedStrike& aim : open) {
            strikes.push_back(aim.event);
        }
        const NextStrikeSearch coming = next_strike(trials, events, strikes);
        if (coming.is_too_long) {
            found.problems.push_back(
                {Subject::event(open.front().event), kFields[open.front().aim.index()],
                 fmt::format(
                     "the shot takes more than {} million steps before this strike, too many "
                     "to try directions; give its 'direction'",
                     kMostTrialSteps / 1'000'000)});
            return found;
        }
        const std::optional<NextStrike>& next = coming.found;
        if (!next) {
            break;
        }
        const AimedStrike aimed = open[next->which];
        StrikeTrials strike_trials(trials, events, aimed.event, next->setting);
        Search search(strike_trials, next->setting, trials.world().table);
        const std::optional<double> direction = search.find(aimed.aim);
        if (!direction) {
            found.problems.push_back(
                {Subject::event(aimed.event), kFields[aimed.aim.index()], search.problem()});
            return found;
        }
        found.directions.push_back(
            {aimed.event, to_microdegrees(*direction), strike_trials.count()});
        std::get<Strike>(events[aimed.event].action).direction = found.directions.back().radians();
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(next->which));
    }
    for (const AimedStrike& never : open) {
        found.directions.push_back({never.event, 0, 0});
    }
    return found;
}

}  // namespace carom::sim
