#include "pipeline/solve/legs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "core/splitmix.h"
#include "sim/force_event.h"

namespace carom::pipeline::solve {
namespace {

using sim::Event;
using sim::EventKind;

/// Shorter pieces (m), as of impacts that come together, are no legs.
constexpr double kShortest = 2e-3;

std::uint64_t mixed(std::uint64_t cause, std::string_view word) {
    for (const char c : word) {
        cause = carom::split_mix(cause + static_cast<unsigned char>(c) + kSplitMixStep);
    }
    return cause;
}

bool ends_leg(const Event& event) {
    switch (event.kind) {
        case EventKind::impact:
            return event.surface() != sim::Surface::cloth;
        case EventKind::strike:
        case EventKind::resting:
        case EventKind::potted:
        case EventKind::off_table:
            return true;
        default:
            return false;
    }
}

}  // namespace

double Leg::miss(const Vec2& point) const {
    const Vec2 d = point - from;
    return d.dot(direction) > 0 ? direction.x * d.y - direction.y * d.x
                                : std::numeric_limits<double>::quiet_NaN();
}

const Leg* leg_with(const std::vector<Leg>& legs, std::uint64_t cause) {
    const auto found = std::ranges::find(legs, cause, &Leg::cause);
    return found != legs.end() ? &*found : nullptr;
}

Radii radii_of(const sim::WorldDescription& world) {
    Radii radii;
    for (const sim::Body& body : world.bodies) {
        if (const auto* sphere = std::get_if<sim::Sphere>(&body.shape)) {
            radii.emplace(body.name, sphere->radius);
        }
    }
    return radii;
}

Vec2 centre_in(const Event& event, const std::string& name, double radius) {
    const Vec2 place(event.place.x, event.place.y);
    if (event.kind != EventKind::impact) {
        return place;
    }
    const Vec2 normal(event.normal.x, event.normal.y);
    return place + normal * (event.a == name ? radius : -radius);
}

std::string side_of(const Vec3& normal) {
    constexpr double kStraight = 0.999;
    const double level = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    const double x = normal.x / level;
    const double y = normal.y / level;
    return y < -kStraight   ? "back"
           : y > kStraight  ? "front"
           : x < -kStraight ? "right"
           : x > kStraight  ? "left"
                            : "";
}

std::uint64_t& LegReader::cause_of(const std::string& ball) {
    return causes_.try_emplace(ball, mixed(0, ball)).first->second;
}

void LegReader::note_cause(const Event& event) {
    if (event.kind == EventKind::strike) {
        cause_of(event.a) = mixed(cause_of(event.a), "strike");
    } else if (event.kind == EventKind::impact && event.surface() == sim::Surface::none) {
        // The same whichever is named first.
        const std::uint64_t both = cause_of(event.a) + cause_of(event.b);
        cause_of(event.a) = mixed(both, event.a);
        cause_of(event.b) = mixed(both, event.b);
    } else if (event.kind == EventKind::impact && event.surface() != sim::Surface::cloth) {
        cause_of(event.a) = mixed(cause_of(event.a), event.b + side_of(event.normal));
    }
}

void LegReader::close(std::vector<Leg>& legs) const {
    if (!open_) {
        return;
    }
    const Vec2 d = last_ - open_->from;
    const double length = std::sqrt(d.dot(d));
    if (length > kShortest) {
        legs.push_back({open_->cause, open_->from, d / length, length});
    }
}

void LegReader::see(const Event& event) {
    const bool takes_part = event.a == ball_ || event.b == ball_;
    const bool is_repeated = takes_part && event.surface() == sim::Surface::cushion &&
                             last_cushion_ >= 0 && event.time - last_cushion_ < sim::kOneContact;
    if (!is_repeated) {
        note_cause(event);
    }
    if (!takes_part || event.kind == EventKind::placed) {
        return;
    }
    last_ = centre_in(event, ball_, radius_);
    if (event.surface() == sim::Surface::cushion) {
        last_cushion_ = event.time;
    }
    if (!ends_leg(event)) {
        return;
    }
    close(ended_);
    open_.reset();
    if (event.kind == EventKind::impact || event.kind == EventKind::strike) {
        open_ = Leg{cause_of(ball_), last_, Vec2(1, 0), 0};
    }
}

std::vector<Leg> LegReader::legs() const {
    std::vector<Leg> legs = ended_;
    close(legs);
    return legs;
}

std::vector<Leg> legs_of(const std::string& ball, std::span<const Event> events,
                         const Radii& radii) {
    const auto known = radii.find(ball);
    LegReader reader(ball, known != radii.end() ? known->second : 0);
    for (const Event& event : events) {
        reader.see(event);
    }
    return reader.legs();
}

}  // namespace carom::pipeline::solve
