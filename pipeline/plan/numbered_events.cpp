#include "pipeline/plan/numbered_events.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "pipeline/report/shot_report.h"

namespace carom::pipeline {

namespace {

using sim::Event;
using sim::EventKind;

constexpr double kDegrees = 57.295779513082321;
constexpr double kSameMoment = 2e-3;   // s: a rack's burst is one event
constexpr double kRowPause = 0.5;      // s, between the touches of a row of objects
constexpr double kLandingSpeed = 0.5;  // m/s, of what hits the cloth hard enough to be told

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string trimmed(double value, int decimals) {
    std::string text = fixed(value, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return text == "-0" ? "0" : text;
}

std::string angle_text(double angle) {
    return trimmed(std::round(angle * kDegrees), 0) + "°";
}

bool is_ball(const sim::Body* body) {
    return body != nullptr && std::holds_alternative<sim::Sphere>(body->shape);
}

/// One event or several that are told as one.
struct Group {
    ReportedEvent first;
    std::string text;
    std::string label;
    double weight = 0;  // what is lightest is left out
    double end = 0;     // of the last one, s
    int count = 1;
    bool is_row = false;  // of objects, none of them a ball
    std::set<std::string> who;
    std::string last;  // the one that was touched last
};

class Grouping {
  public:
    Grouping(const Shot& shot, const sim::Timeline& timeline) : shot_(shot), timeline_(timeline) {}

    std::vector<Group> groups() {
        for (const ReportedEvent& row : report_of(timeline_).events) {
            add(row);
        }
        for (Group& group : groups_) {
            finish(group);
        }
        return std::move(groups_);
    }

  private:
    void add(const ReportedEvent& row) {
        switch (row.event.kind) {
            case EventKind::impact:
                return add_impact(row);
            case EventKind::strike:
                return add_alone(row, strike_text(row), strike_label(row));
            case EventKind::force:
            case EventKind::torque:
            case EventKind::impulse:
            case EventKind::velocity:
                return add_alone(row, std::string(to_string(row.event.kind)) + " on " + row.event.a,
                                 "");
            case EventKind::potted: {
                std::string pocket = row.event.b;
                std::replace(pocket.begin(), pocket.end(), '_', ' ');
                return add_alone(row, row.event.a + " potted, " + pocket, "");
            }
            case EventKind::off_table:
                return add_alone(row, row.event.a + " leaves the table", "");
            default:
                return;
        }
    }

    void add_alone(const ReportedEvent& row, std::string text, std::string label) {
        Group group;
        group.first = row;
        group.text = std::move(text);
        group.label = std::move(label);
        group.weight = 1e9;
        group.end = row.event.time;
        groups_.push_back(std::move(group));
    }

    void add_impact(const ReportedEvent& row) {
        const Event& event = row.event;
        const sim::Body* a = find_body(shot_, event.a);
        const sim::Body* b = find_body(shot_, event.b);
        const bool is_ground = event.b == "cloth" || event.b == "floor" || event.b == "rail";
        if (event.b == "pocket" || (is_ground && !is_landing(event, a))) {
            return;
        }
        const bool among_balls = is_ball(a) && (b == nullptr || is_ball(b));
        if (!among_balls && !touched_.insert(std::minmax(event.a, event.b)).second) {
            return;  // objects that lean on each other touch a thousand times
        }
        const bool is_row = a != nullptr && b != nullptr && !is_ball(a) && !is_ball(b);
        if (Group* group = group_of(event, is_row)) {
            ++group->count;
            group->end = event.time;
            group->weight = std::max(group->weight, event.normal_impulse);
            group->who.insert({event.a, event.b});
            group->last = group->last == event.a ? event.b : event.a;
            return;
        }
        Group group;
        group.first = row;
        group.weight = event.normal_impulse;
        group.end = event.time;
        group.is_row = is_row;
        group.who = {event.a, event.b};
        group.last = event.b;
        describe_impact(row, group);
        groups_.push_back(std::move(group));
    }

    static bool is_landing(const Event& event, const sim::Body* body) {
        return is_ball(body) && event.normal_impulse > kLandingSpeed * body->mass;
    }

    /// The group that an impact belongs to, if it is none of its own.
    Group* group_of(const Event& event, bool is_row) {
        for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
            const double pause = event.time - group->end;
            if (pause > kRowPause) {
                break;
            }
            const bool is_impact = group->first.event.kind == EventKind::impact;
            const bool shares = group->who.contains(event.a) ||
                                (group->who.contains(event.b) && find_body(shot_, event.b));
            if (is_impact && is_row && group->is_row) {
                return &*group;
            }
            if (is_impact && !is_row && !group->is_row && shares && pause < kSameMoment) {
                return &*group;
            }
            if (group->first.event.kind == EventKind::strike && event.b == "cloth" &&
                event.a == group->first.event.a && pause < kSameMoment) {
                return &*group;  // a steep stick presses the ball onto the slate
            }
        }
        return nullptr;
    }

    static void describe_impact(const ReportedEvent& row, Group& group) {
        const Event& event = row.event;
        const bool b_moves_in = row.b && (!row.a || row.b->before > row.a->before);
        const std::string& mover = b_moves_in ? event.b : event.a;
        const std::string& other = b_moves_in ? event.a : event.b;
        const auto& mover_speed = b_moves_in ? row.b : row.a;
        const auto& other_speed = b_moves_in ? row.a : row.b;
        group.last = other;
        if (!mover_speed) {
            group.text = mover + " → " + other;
            return;
        }
        if (event.b == "cloth" || event.b == "floor") {
            group.text = mover + " lands on the " + event.b;
            return;
        }
        if (!other_speed) {
            group.text = mover + " → " + other + ", " + speed_text(mover_speed->before) + " to " +
                         speed_text(mover_speed->after);
            return;
        }
        group.text = mover + " → " + other + " at " + speed_text(mover_speed->before);
        group.label = speed_text(mover_speed->before);
        if (row.cut) {
            group.text += ", cut " + angle_text(*row.cut);
            group.label += ", cut " + angle_text(*row.cut);
        }
        group.text += ", " + other + " leaves at " + speed_text(other_speed->after);
    }

    void finish(Group& group) const {
        if (group.is_row && group.count > 1) {
            group.text = group.first.event.b + " … " + group.last + ": " +
                         std::to_string(group.count) + " touches until " + time_text(group.end);
            if (group.first.a && group.first.b && group.first.a->before > group.first.b->before) {
                group.text.replace(0, group.first.event.b.size(), group.first.event.a);
            }
            group.label = std::to_string(group.count) + " touches";
        } else if (group.first.event.kind == EventKind::impact && group.count > 1) {
            group.text += ", and " + std::to_string(group.count - 1) + " more in " +
                          trimmed(std::max(0.1, 1e3 * (group.end - group.first.event.time)), 1) +
                          " ms";
        }
    }

    /// What the ball has when stick and cloth have let go of it.
    static std::string speed_after(const ReportedEvent& row) {
        return speed_text(row.a ? row.a->after : row.event.vector.length());
    }

    std::string strike_text(const ReportedEvent& row) const {
        std::string text = row.event.a + " struck, leaves at " + speed_after(row);
        const sim::Strike* strike = strike_of(shot_, timeline_, row.event);
        if (strike == nullptr) {
            return text;
        }
        if (strike->elevation > 0.5 / kDegrees) {
            text += ", stick " + angle_text(strike->elevation) + " steep";
        }
        const auto tip = [&](double offset, const char* more, const char* less) {
            if (std::abs(offset) >= 0.005) {
                text +=
                    ", tip " + trimmed(std::abs(offset), 2) + " R " + (offset > 0 ? more : less);
            }
        };
        tip(strike->tip.x, "right", "left");
        tip(strike->tip.y, "high", "low");
        return text;
    }

    std::string strike_label(const ReportedEvent& row) const {
        const sim::Strike* strike = strike_of(shot_, timeline_, row.event);
        return strike != nullptr && strike->speed ? "stick " + speed_text(*strike->speed)
                                                  : speed_after(row);
    }

    const Shot& shot_;
    const sim::Timeline& timeline_;
    std::vector<Group> groups_;
    std::set<std::pair<std::string, std::string>> touched_;
};

}  // namespace

std::string speed_text(double speed) {
    return trimmed(speed, speed >= 0.995 ? 1 : 2) + " m/s";
}

std::string time_text(double seconds) {
    return trimmed(seconds, 3) + " s";
}

const sim::Body* find_body(const Shot& shot, const std::string& name) {
    for (const sim::Body& body : shot.world.bodies) {
        if (body.name == name) {
            return &body;
        }
    }
    return nullptr;
}

const sim::Strike* strike_of(const Shot& shot, const sim::Timeline& timeline, const Event& event) {
    // Those at a time of their own are known by it; the others come in the order of the shot.
    std::vector<const sim::Strike*> triggered;
    for (const sim::ForceEvent& given : shot.world.events) {
        const auto* strike = std::get_if<sim::Strike>(&given.action);
        if (strike == nullptr || given.object != event.a) {
            continue;
        }
        if (!given.trigger && std::abs(given.time + given.after - event.time) < 1e-9) {
            return strike;
        }
        if (given.trigger) {
            triggered.push_back(strike);
        }
    }
    std::size_t earlier = 0;
    for (const Event& other : timeline.events) {
        const bool is_earlier =
            other.kind == EventKind::strike && other.a == event.a && other.time < event.time;
        const bool is_timed =
            is_earlier && std::any_of(shot.world.events.begin(), shot.world.events.end(),
                                      [&](const sim::ForceEvent& given) {
                                          return !given.trigger && given.object == event.a &&
                                                 std::abs(given.time - other.time) < 1e-9;
                                      });
        earlier += is_earlier && !is_timed ? 1 : 0;
    }
    return earlier < triggered.size() ? triggered[earlier] : nullptr;
}

NumberedEvents number_events(const Shot& shot, const sim::Timeline& timeline, std::size_t most) {
    std::vector<Group> groups = Grouping(shot, timeline).groups();
    NumberedEvents result;
    while (groups.size() > most) {
        const auto lightest =
            std::min_element(groups.begin(), groups.end(),
                             [](const Group& a, const Group& b) { return a.weight < b.weight; });
        groups.erase(lightest);
        ++result.left_out;
    }
    for (const Group& group : groups) {
        result.events.push_back({static_cast<int>(result.events.size()) + 1, group.first.event.time,
                                 group.first.event.place, group.text, group.label});
    }
    return result;
}

}  // namespace carom::pipeline
