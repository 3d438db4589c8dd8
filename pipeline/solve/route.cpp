#include "pipeline/solve/route.h"

#include <algorithm>
#include <optional>
#include <set>

#include "pipeline/solve/legs.h"
#include "sim/occurrence.h"

namespace carom::pipeline::solve {
namespace {

using sim::Event;
using sim::EventKind;

bool is_step(const Event& event) {
    return event.kind == EventKind::potted ||
           (event.kind == EventKind::impact && event.surface() != sim::Surface::cloth &&
            event.surface() != sim::Surface::pocket && event.surface() != sim::Surface::floor);
}

/// Empty for a pocket's jaws: a pot that touches them is the same shot. Of two balls, the first is
/// the one that has moved.
std::string words_for(const Event& event, const std::set<std::string>& moved) {
    if (event.kind == EventKind::potted) {
        return event.a + " in " + event.b;
    }
    if (event.surface() == sim::Surface::cushion) {
        const std::string side = side_of(event.normal);
        return side.empty() ? std::string() : event.a + " - " + side + " cushion";
    }
    const bool is_b_first = moved.contains(event.a) == moved.contains(event.b)
                                ? event.b < event.a
                                : moved.contains(event.b);
    return is_b_first ? event.b + " - " + event.a : event.a + " - " + event.b;
}

/// Marks the events that met the wants; if there are none, the first step.
std::vector<char> decisive(const std::vector<Want>& wants, std::span<const Event> events) {
    std::vector<char> marks(events.size(), 0);
    for (const Want& want : wants) {
        const auto* happening = std::get_if<Happening>(&want);
        if (happening == nullptr || happening->is_avoided()) {
            continue;
        }
        sim::OccurrenceCounter counter(happening->trigger);
        int count = 0;
        for (std::size_t i = 0; i < events.size() && count < happening->at_least; ++i) {
            if (may_count(*happening, events[i]) && counter.counts(events[i])) {
                ++count;
                marks[i] = 1;
            }
        }
        if (happening->before) {
            const auto end = std::ranges::find_if(events, [&](const Event& event) {
                return sim::OccurrenceCounter(*happening->before).counts(event);
            });
            if (end != events.end()) {
                marks[static_cast<std::size_t>(end - events.begin())] = 1;
            }
        }
    }
    if (std::ranges::count(marks, 1) == 0) {
        const auto first = std::ranges::find_if(events, is_step);
        if (first != events.end()) {
            marks[static_cast<std::size_t>(first - events.begin())] = 1;
        }
    }
    return marks;
}

}  // namespace

std::string Route::text() const {
    std::string text;
    for (const std::string& step : steps) {
        text += (text.empty() ? "" : ", ") + step;
    }
    return text.empty() ? "no contact" : text;
}

std::pair<double, double> rank_of(double miss, std::string_view route, double chance) {
    constexpr double kPerStep = 0.05;
    const auto steps = static_cast<double>(std::ranges::count(route, ','));
    return {miss, kPerStep * steps - chance};
}

Route route_of(const std::vector<Want>& wants, const Trial& trial) {
    const std::span<const Event> events = trial.events();
    std::vector<char> marks = decisive(wants, events);
    std::set<std::string> involved;
    for (std::size_t i = events.size(); i-- > 0;) {
        const Event& event = events[i];
        const bool is_cause = is_step(event) && event.kind == EventKind::impact &&
                              (involved.contains(event.a) || involved.contains(event.b));
        if (marks[i] == 0 && !is_cause) {
            continue;
        }
        marks[i] = 1;
        involved.insert(event.a);
        if (event.kind == EventKind::impact && event.surface() == sim::Surface::none) {
            involved.insert(event.b);
        }
    }
    Route route;
    std::set<std::string> moved;
    if (!events.empty()) {
        moved.insert(events.front().a);  // struck
    }
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (marks[i] == 0 || !is_step(events[i])) {
            continue;
        }
        std::string words = words_for(events[i], moved);
        moved.insert({events[i].a, events[i].b});
        if (!words.empty() && (route.steps.empty() || route.steps.back() != words)) {
            route.steps.push_back(std::move(words));
        }
    }
    return route;
}

}  // namespace carom::pipeline::solve
