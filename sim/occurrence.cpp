#include "sim/occurrence.h"

#include <utility>

#include <fmt/core.h>

namespace carom::sim {
namespace {

bool is_occurrence(const Trigger& trigger, const Event& event) {
    switch (trigger.kind) {
        case Trigger::Kind::contact:
            return event.kind == EventKind::impact &&
                   ((event.a == trigger.a && event.b == trigger.b) ||
                    (event.a == trigger.b && event.b == trigger.a));
        case Trigger::Kind::potted:
            return event.kind == EventKind::potted && event.a == trigger.a;
        case Trigger::Kind::strike:
            return event.kind == EventKind::strike && event.a == trigger.a;
        case Trigger::Kind::resting:
        case Trigger::Kind::crossing:
        case Trigger::Kind::apex:
            return false;
    }
    return false;
}

/// What happens in an occurrence, in the past tense and after "never".
std::pair<std::string, std::string> verbs(const Trigger& trigger) {
    const std::string a = "'" + trigger.a + "'";
    switch (trigger.kind) {
        case Trigger::Kind::contact: {
            const std::string both = " touched '" + trigger.b + "'";
            return {a + both, a + " never" + both};
        }
        case Trigger::Kind::potted:
            return {a + " was potted", a + " was never potted"};
        case Trigger::Kind::strike:
            return {a + " was struck", a + " was never struck"};
        case Trigger::Kind::crossing:
            return {a + " crossed the line", a + " never crossed the line"};
        case Trigger::Kind::apex:
            return {a + " rose by 1 mm or more", a + " never rose by 1 mm or more"};
        case Trigger::Kind::resting:
            return {a + " came to rest", a + " never came to rest"};
    }
    return {};
}

}  // namespace

bool is_logged(Trigger::Kind kind) {
    return kind == Trigger::Kind::contact || kind == Trigger::Kind::potted ||
           kind == Trigger::Kind::strike;
}

bool OccurrenceCounter::counts(const Event& event) {
    if (!is_occurrence(*trigger_, event)) {
        return false;
    }
    if (trigger_->kind != Trigger::Kind::contact) {
        return true;
    }
    const bool is_new = last_contact_ < 0 || event.time - last_contact_ > kOneContact;
    last_contact_ = event.time;
    return is_new;
}

std::string times_text(int count) {
    return count == 1 ? "once" : count == 2 ? "twice" : fmt::format("{} times", count);
}

std::string why_never(const Trigger& trigger, int count) {
    const auto [did, never] = verbs(trigger);
    return count == 0 ? never : did + " only " + times_text(count);
}

}  // namespace carom::sim
