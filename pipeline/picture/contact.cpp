#include "pipeline/picture/contact.h"

namespace carom::pipeline {
namespace {

constexpr double kJustBefore = 1e-6;  // s

}  // namespace

std::optional<Contact> first_contact(const sim::Timeline& timeline, const std::string& object,
                                     const std::string& other) {
    const sim::Track* track = timeline.find(object);
    if (track == nullptr) {
        return std::nullopt;
    }
    for (const sim::Event& event : timeline.events) {
        const bool is_first = event.a == object && event.b == other;
        const bool is_second = event.b == object && event.a == other;
        if (event.kind == sim::EventKind::impact && (is_first || is_second)) {
            return Contact{event.time, track->sample(event.time).position,
                           is_first ? event.normal : -event.normal,
                           track->sample(event.time - kJustBefore).velocity};
        }
    }
    return std::nullopt;
}

}  // namespace carom::pipeline
