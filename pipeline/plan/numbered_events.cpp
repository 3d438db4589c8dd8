#include "pipeline/plan/numbered_events.h"

#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "pipeline/plan/event_text.h"
#include "pipeline/plan/quantity_text.h"
#include "pipeline/plan/shot_lookup.h"
#include "pipeline/report/shot_report.h"

namespace carom::pipeline {

namespace {

using sim::Event;
using sim::EventKind;

constexpr double kSameMoment = 2e-3;   // s: all impacts within a breaking rack are one event
constexpr double kRowPause = 0.5;      // s, between the impacts in a row of objects
constexpr double kSlow = 0.25;         // m/s: impacts of this speed ...
constexpr double kSlowPause = 0.05;    // s: ... that follow each other so closely are one event
constexpr double kLandingSpeed = 0.5;  // m/s: slower impacts on the cloth are omitted

bool is_ball(const sim::Body* body) {
    return body != nullptr && std::holds_alternative<sim::Sphere>(body->shape);
}

/// One event, or several that share one number.
struct Group {
    ReportedEvent first;
    EventText text;
    double weight = 0;  // the groups of least weight are left out
    double end = 0;     // of the last event, s
    int count = 1;
    bool is_row = false;  // a row of objects without balls
    std::set<std::string> who;
    std::string last;  // the object that was hit last
};

class Grouping {
  public:
    Grouping(const Shot& shot, const sim::Timeline& timeline) : shot_(shot), timeline_(timeline) {}

    /// The number of impacts that are too slow for a number. Call it after groups().
    [[nodiscard]] int slow_count() const { return slow_; }

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
                return add_alone(row, strike_text(row, strike_of(shot_, timeline_, row.event)));
            case EventKind::force:
            case EventKind::torque:
            case EventKind::impulse:
            case EventKind::velocity:
            case EventKind::potted:
            case EventKind::off_table:
            case EventKind::placed:
            case EventKind::removed:
                return add_alone(row, single_object_text(row.event));
            default:
                return;
        }
    }

    void add_alone(const ReportedEvent& row, EventText text) {
        Group group;
        group.first = row;
        group.text = std::move(text);
        group.weight = 1e9;
        group.end = row.event.time;
        groups_.push_back(std::move(group));
    }

    void add_impact(const ReportedEvent& row) {
        const Event& event = row.event;
        const sim::Body* a = find_body(shot_, event.a);
        const sim::Body* b = find_body(shot_, event.b);
        const bool is_ground =
            sim::is_level(event.surface()) || event.surface() == sim::Surface::rail;
        if (event.surface() == sim::Surface::pocket || (is_ground && !is_landing(event, a))) {
            return;
        }
        const bool among_balls = is_ball(a) && (b == nullptr || is_ball(b));
        if (!among_balls && !touched_.insert(std::minmax(event.a, event.b)).second) {
            return;  // objects that lean on each other have thousands of impacts
        }
        const double speed = impact_speed(row);
        const bool is_row = a != nullptr && b != nullptr && !is_ball(a) && !is_ball(b);
        if (Group* group = group_of(event, is_row, speed)) {
            ++group->count;
            group->end = event.time;
            group->weight = std::max(group->weight, event.normal_impulse);
            group->who.insert({event.a, event.b});
            group->last = group->last == event.a ? event.b : event.a;
            return;
        }
        if (among_balls && speed < kMinNumberedSpeed) {
            ++slow_;
            return;
        }
        Group group;
        group.first = row;
        group.weight = event.normal_impulse;
        group.end = event.time;
        group.is_row = is_row;
        group.who = {event.a, event.b};
        group.text = impact_text(row);
        group.last = hit_object(row);
        groups_.push_back(std::move(group));
    }

    /// The speed of the faster object before the impact, m/s; very high if unknown.
    static double impact_speed(const ReportedEvent& row) {
        if (!row.a && !row.b) {
            return 1e9;
        }
        return std::max(row.a ? row.a->before : 0, row.b ? row.b->before : 0);
    }

    static bool is_landing(const Event& event, const sim::Body* body) {
        return is_ball(body) && event.normal_impulse > kLandingSpeed * body->mass;
    }

    /// The group that an impact belongs to, or nullptr if it starts a new one.
    Group* group_of(const Event& event, bool is_row, double speed) {
        const double longest_pause = speed < kSlow ? kSlowPause : kSameMoment;
        for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
            const double pause = event.time - group->end;
            if (pause > kRowPause) {
                break;
            }
            const bool is_impact = group->first.event.kind == EventKind::impact;
            const bool has_common_object =
                group->who.contains(event.a) ||
                (group->who.contains(event.b) && find_body(shot_, event.b));
            if (is_impact && is_row && group->is_row) {
                return &*group;
            }
            if (is_impact && !is_row && !group->is_row && has_common_object &&
                pause < longest_pause) {
                return &*group;
            }
            if (group->first.event.kind == EventKind::strike &&
                event.surface() == sim::Surface::cloth && event.a == group->first.event.a &&
                pause < kSameMoment) {
                return &*group;  // a steep stick presses the ball onto the slate
            }
        }
        return nullptr;
    }

    void finish(Group& group) const {
        if (group.is_row && group.count > 1) {
            group.text.full = fmt::format("{} … {}: {} touches until {}", group.first.event.b,
                                          group.last, group.count, time_text(group.end));
            if (group.first.a && group.first.b && group.first.a->before > group.first.b->before) {
                group.text.full.replace(0, group.first.event.b.size(), group.first.event.a);
            }
            group.text.label = fmt::format("{} touches", group.count);
        } else if (group.first.event.kind == EventKind::impact && group.count > 1) {
            group.text.full =
                fmt::format("{}, and {} more in {}", group.text.brief, group.count - 1,
                            milliseconds_text(group.end - group.first.event.time));
        }
    }

    const Shot& shot_;
    const sim::Timeline& timeline_;
    int slow_ = 0;
    std::vector<Group> groups_;
    std::set<std::pair<std::string, std::string>> touched_;
};

}  // namespace

NumberedEvents number_events(const Shot& shot, const sim::Timeline& timeline, std::size_t most) {
    Grouping grouping(shot, timeline);
    std::vector<Group> groups = grouping.groups();
    NumberedEvents result;
    result.slow = grouping.slow_count();
    while (groups.size() > most) {
        const auto lightest =
            std::min_element(groups.begin(), groups.end(),
                             [](const Group& a, const Group& b) { return a.weight < b.weight; });
        groups.erase(lightest);
        ++result.left_out;
    }
    for (const Group& group : groups) {
        result.events.push_back({static_cast<int>(result.events.size()) + 1, group.first.event.time,
                                 group.first.event.place, group.text.full, group.text.label});
    }
    return result;
}

}  // namespace carom::pipeline
