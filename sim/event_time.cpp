#include "sim/event_time.h"

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "sim/occurrence.h"
#include "sim/path_occurrences.h"

namespace carom::sim {
namespace {

/// At most this many times or objects are listed in a sentence.
constexpr std::size_t kMaxListed = 4;

std::string time_text(double time) {
    return decimal_text(time, 3) + " s";
}

/// "a", "a and b", "a, b and c", "a, b, c, d and 3 more".
std::string list_text(const std::vector<std::string>& parts) {
    std::string text;
    const std::size_t shown = std::min(parts.size(), kMaxListed);
    for (std::size_t i = 0; i < shown; ++i) {
        const bool is_last = i + 1 == parts.size();
        text += (i == 0 ? "" : is_last ? " and " : ", ") + parts[i];
    }
    return shown < parts.size() ? text + " and " + std::to_string(parts.size() - shown) + " more"
                                : text;
}

std::vector<double> logged_times(const Trigger& trigger, const Timeline& timeline) {
    std::vector<double> times;
    OccurrenceCounter counter(trigger);
    for (const Event& event : timeline.events) {
        if (counter.counts(event)) {
            times.push_back(event.time);
        }
    }
    return times;
}

/// The objects that `name` touched, each with the first time: "'two' at 0.51 s".
std::vector<std::string> touched(const std::string& name, const Timeline& timeline) {
    std::vector<std::string> known, texts;
    for (const Event& event : timeline.events) {
        if (event.kind != EventKind::impact || (event.a != name && event.b != name)) {
            continue;
        }
        const std::string& other = event.a == name ? event.b : event.a;
        if (std::find(known.begin(), known.end(), other) == known.end()) {
            known.push_back(other);
            texts.push_back("'" + other + "' at " + time_text(event.time));
        }
    }
    return texts;
}

/// The objects to which events of a kind happened: "'cue' at 0.5 s".
std::vector<std::string> happened(EventKind kind, const Timeline& timeline) {
    std::vector<std::string> texts;
    for (const Event& event : timeline.events) {
        if (event.kind == kind) {
            texts.push_back("'" + event.a + "' at " + time_text(event.time));
        }
    }
    return texts;
}

/// What happened instead of an occurrence that never happened; may be empty.
std::string instead(const Trigger& trigger, const Timeline& timeline) {
    const auto listed = [](const std::string& some, const std::string& none,
                           const std::vector<std::string>& texts) {
        return texts.empty() ? none : some + list_text(texts);
    };
    switch (trigger.kind) {
        case Trigger::Kind::contact:
            return listed("it touched ", "it touched nothing", touched(trigger.a, timeline));
        case Trigger::Kind::potted:
            return listed("potted were ", "nothing was potted",
                          happened(EventKind::potted, timeline));
        case Trigger::Kind::strike:
            return listed("struck were ", "nothing was struck",
                          happened(EventKind::strike, timeline));
        case Trigger::Kind::resting:
            return "the simulation ends at " + time_text(timeline.end_time);
        case Trigger::Kind::crossing:
        case Trigger::Kind::apex:
            break;
    }
    return {};
}

std::string subject_of(const Trigger& trigger) {
    return trigger.a.empty() ? "everything" : "'" + trigger.a + "'";
}

std::string reason(const Trigger& trigger, const std::vector<double>& times,
                   const Timeline& timeline) {
    const auto count = static_cast<int>(times.size());
    if (count > 0) {
        std::vector<std::string> texts;
        texts.reserve(times.size());
        for (const double time : times) {
            texts.push_back(time_text(time));
        }
        const std::string what =
            trigger.kind == Trigger::Kind::resting
                ? subject_of(trigger) + " came to rest only " + times_text(count)
                : why_never(trigger, count);
        return what + ", at " + list_text(texts);
    }
    const std::string never = trigger.kind == Trigger::Kind::resting
                                  ? subject_of(trigger) + " never came to rest after a motion"
                                  : why_never(trigger, 0);
    const std::string other = instead(trigger, timeline);
    return other.empty() ? never : never + "; " + other;
}

}  // namespace

std::vector<double> find_occurrences(const Trigger& trigger, const Timeline& timeline,
                                     const WorldDescription& world) {
    if (is_logged(trigger.kind)) {
        return logged_times(trigger, timeline);
    }
    if (trigger.kind == Trigger::Kind::resting && trigger.a.empty()) {
        return rests_of_all(timeline, world);
    }
    const Track* track = timeline.find(trigger.a);
    if (track == nullptr) {
        return {};
    }
    switch (trigger.kind) {
        case Trigger::Kind::resting:
            return rests(*track);
        case Trigger::Kind::crossing:
            return line_crossings(*track, trigger.from, trigger.to);
        case Trigger::Kind::apex:
            return apexes(*track);
        default:
            return {};
    }
}

std::variant<double, std::string> find_event_time(const EventTime& moment, const Timeline& timeline,
                                                  const WorldDescription& world) {
    const std::vector<double> times = find_occurrences(moment.trigger, timeline, world);
    const auto nth = static_cast<std::size_t>(std::max(moment.trigger.nth, 1));
    if (nth > times.size()) {
        return reason(moment.trigger, times, timeline);
    }
    return times[nth - 1] + moment.delay;
}

}  // namespace carom::sim
