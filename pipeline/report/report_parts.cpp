#include "pipeline/report/report_parts.h"

#include <algorithm>
#include <array>

#include "sim/timeline/event.h"

namespace carom::pipeline {

namespace {

using sim::EventKind;

constexpr std::array kParts{"objects", "energy", "energy_over_time", "moments"};

/// A word for several kinds of events, or for some of a kind.
struct EventGroup {
    const char* word;
    bool (*has)(const ReportedEvent&);
};

template <EventKind... kinds>
bool is_one_of(const ReportedEvent& row) {
    return ((row.event.kind == kinds) || ...);
}

constexpr std::array kGroups{
    EventGroup{"events", [](const ReportedEvent&) { return true; }},
    EventGroup{"impacts", is_one_of<EventKind::impact>},
    EventGroup{"collisions",
               [](const ReportedEvent& row) {
                   return row.event.kind == EventKind::impact && row.a && row.b;
               }},
    EventGroup{
        "cushions",
        [](const ReportedEvent& row) { return row.event.surface() == sim::Surface::cushion; }},
    EventGroup{"strikes", is_one_of<EventKind::strike>},
    EventGroup{"pots", is_one_of<EventKind::potted>},
    EventGroup{"motion", is_one_of<EventKind::sliding, EventKind::rolling, EventKind::spinning,
                                   EventKind::resting, EventKind::airborne>},
    EventGroup{
        "forces",
        is_one_of<EventKind::force, EventKind::torque, EventKind::impulse, EventKind::velocity>},
    EventGroup{"placing", is_one_of<EventKind::placed, EventKind::removed>},
};

bool has_word(const std::vector<std::string>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

/// Whether the words name the event, by a group or by its kind.
bool name_event(const std::vector<std::string>& words, const ReportedEvent& row) {
    return has_word(words, to_string(row.event.kind)) ||
           std::ranges::any_of(kGroups, [&](const EventGroup& group) {
               return has_word(words, group.word) && group.has(row);
           });
}

bool is_part(const std::string& word) {
    return std::ranges::find(kParts, word) != kParts.end();
}

bool shows(const ReportFilter& filter, const char* part) {
    return (filter.only.empty() || has_word(filter.only, part)) && !has_word(filter.without, part);
}

bool is_wanted(const ReportFilter& filter, const ReportedEvent& row) {
    const sim::Event& event = row.event;
    const bool has_impulse = event.kind == EventKind::impact || event.kind == EventKind::strike;
    const bool is_named = filter.only.empty() || name_event(filter.only, row);
    const bool is_about = filter.objects.empty() || has_word(filter.objects, event.a) ||
                          has_word(filter.objects, event.b);
    return is_named && !name_event(filter.without, row) && is_about &&
           std::max(event.time, event.end_time) >= filter.from && event.time <= filter.to &&
           !(has_impulse && event.normal_impulse < filter.min_impulse);
}

}  // namespace

std::vector<std::string> report_words() {
    std::vector<std::string> words;
    words.reserve(std::size(kGroups));
    for (const EventGroup& group : kGroups) {
        words.emplace_back(group.word);
    }
    words.insert(words.end(), kParts.begin(), kParts.end());
    for (int kind = 0; kind <= static_cast<int>(EventKind::removed); ++kind) {
        words.emplace_back(to_string(static_cast<EventKind>(kind)));
    }
    return words;
}

ReportParts apply(const ReportFilter& filter, ShotReport& report) {
    ReportParts parts;
    parts.events = filter.only.empty() || !std::ranges::all_of(filter.only, [](const auto& word) {
                       return is_part(word);
                   });
    parts.events = parts.events && !has_word(filter.without, "events");
    parts.objects = shows(filter, "objects");
    parts.energy = shows(filter, "energy");
    parts.energy_over_time = (parts.energy || shows(filter, "energy_over_time")) &&
                             !has_word(filter.without, "energy") &&
                             !has_word(filter.without, "energy_over_time");
    parts.moments = shows(filter, "moments");
    std::erase_if(report.events, [&](const ReportedEvent& row) { return !is_wanted(filter, row); });
    std::erase_if(report.objects, [&](const ReportedObject& object) {
        return !filter.objects.empty() && !has_word(filter.objects, object.name);
    });
    const auto is_outside = [&](const auto& time) {
        return time < filter.from || time > filter.to;
    };
    std::erase_if(report.energy,
                  [&](const ReportedEnergy& mark) { return is_outside(mark.sample.time); });
    std::erase_if(report.energy_samples,
                  [&](const sim::EnergySample& sample) { return is_outside(sample.time); });
    return parts;
}

}  // namespace carom::pipeline
