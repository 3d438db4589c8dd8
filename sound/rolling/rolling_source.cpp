#include "sound/rolling/rolling_source.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/assert.h"
#include "core/hash.h"
#include "core/splitmix.h"
#include "sound/source/impact_sound.h"

namespace carom::sound {
namespace {

constexpr double kFade = 0.005;      // s of the scene
constexpr double kMinOffset = 1000;  // m; the largest offset is twice this

enum class Effect { begins, ends, none };

Effect effect_of(sim::EventKind kind) {
    switch (kind) {
        case sim::EventKind::sliding:
        case sim::EventKind::rolling:
            return Effect::begins;
        case sim::EventKind::spinning:
        case sim::EventKind::resting:
        case sim::EventKind::airborne:
        case sim::EventKind::potted:
        case sim::EventKind::off_table:
        case sim::EventKind::placed:
        case sim::EventKind::removed:
            return Effect::ends;
        case sim::EventKind::impact:
        case sim::EventKind::force:
        case sim::EventKind::torque:
        case sim::EventKind::impulse:
        case sim::EventKind::velocity:
        case sim::EventKind::strike:
            break;
    }
    return Effect::none;
}

/// Whether a ball has moved over the cloth from the beginning to `event`, its first.
bool starts_on_cloth(const sim::Track& track, double start, const sim::Event& event) {
    constexpr double kStill = 1e-4;  // m
    if (event.kind == sim::EventKind::airborne || event.kind == sim::EventKind::potted ||
        event.kind == sim::EventKind::off_table || event.kind == sim::EventKind::placed ||
        event.time < start) {
        return false;
    }
    const sim::Bounds bounds = track.position_bounds(start, event.time);
    const Vec3 extent = bounds.high - bounds.low;
    return extent.z < kStill && std::max(extent.x, extent.y) > kStill;
}

/// A ball while the log is read.
struct LoggedBall {
    const sim::Track* track = nullptr;
    std::vector<Interval>* intervals = nullptr;
    bool is_known = false;        // whether the log has had its state
    std::optional<double> since;  // when the present interval began

    void end(double time) {
        if (since && time > *since) {
            intervals->push_back({*since, time});
        }
        since.reset();
    }
};

RollingSource source_of(const SoundBody& body, const std::string& other, const Texture& texture,
                        const sim::Timeline& timeline) {
    return {.track = timeline.find(body.name),
            .position = body.position,
            .texture = texture,
            .seed = Hasher().add(body.name).add(other).finish().low};
}

/// The contacts of all things by their names, in order of time.
std::unordered_map<std::string_view, std::vector<ContactTime>> contacts_of(const SoundShot& shot) {
    const ImpactSounds sounds(shot);
    std::unordered_map<std::string_view, std::vector<ContactTime>> contacts;
    for (const sim::Event& event : shot.timeline->events) {
        if (const std::optional<ImpactSound> sound = sounds.sound_of(event)) {
            for (const std::string* name : {&event.a, &event.b}) {
                contacts[*name].push_back({event.time, sound->contact_time});
            }
        }
    }
    return contacts;
}

/// The intervals of a pair's scrapes, joined where they are parts of one contact.
std::vector<Interval> intervals_of(std::span<const Scrape> scrapes) {
    constexpr double kSame = 1e-9;  // s
    std::vector<Interval> intervals;
    for (const Scrape& scrape : scrapes) {
        if (!intervals.empty() && scrape.from - intervals.back().to < kSame) {
            intervals.back().to = scrape.to;
        } else {
            intervals.push_back({scrape.from, scrape.to});
        }
    }
    return intervals;
}

/// Adds a scrape to those of a pair, which are in order of their beginnings. Where two contacts of
/// one pair overlap, the later one continues alone.
void add_scrape(std::vector<Scrape>& scrapes, const Scrape& scrape) {
    while (!scrapes.empty() && scrape.from < scrapes.back().to) {
        scrapes.back().to = scrape.from;
        if (scrapes.back().to > scrapes.back().from) {
            break;
        }
        scrapes.pop_back();
    }
    scrapes.push_back(scrape);
}

/// One for each pair with lasting contacts that are heard somewhere, in order of their first.
std::vector<RollingSource> scraping_sources(const SoundShot& shot) {
    std::map<std::string_view, const SoundBody*> bodies;
    for (const SoundBody& body : shot.bodies) {
        bodies.emplace(body.name, &body);
    }
    using Scrapes = std::vector<Scrape>;
    std::vector<RollingSource> sources;
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> indices;
    for (const sim::LastingContact& contact : shot.timeline->lasting_contacts) {
        const auto body = bodies.find(contact.a);
        if (body == bodies.end() || !(contact.from < contact.to)) {
            continue;
        }
        const bool is_ball = std::holds_alternative<BallShape>(body->second->shape);
        if (is_ball && is_level(contact.surface())) {
            continue;
        }
        const auto [index, is_new] = indices.try_emplace({contact.a, contact.b}, sources.size());
        if (is_new) {
            const sim::Surface surface = contact.surface();
            const bool is_cloth =
                surface == sim::Surface::cloth || surface == sim::Surface::cushion;
            sources.push_back(
                source_of(*body->second, contact.b, is_cloth ? kCloth : kSolid, *shot.timeline));
            sources.back().motion = Scrapes();
        }
        add_scrape(std::get<Scrapes>(sources[index->second].motion),
                   {contact.from, contact.to, contact.normal_force, contact.slip});
    }
    std::erase_if(sources, [](const RollingSource& source) {
        return std::ranges::all_of(std::get<Scrapes>(source.motion), [](const Scrape& scrape) {
            return scraping_pressure(scrape.slip, scrape.force) == 0;
        });
    });
    for (RollingSource& source : sources) {
        source.intervals = intervals_of(std::get<Scrapes>(source.motion));
    }
    return sources;
}

/// The factor with which an interval fades in and out.
double fade_gain(const Interval& interval, double time) {
    const double fade = std::min(kFade, (interval.to - interval.from) / 4);
    return std::clamp(std::min(time - interval.from, interval.to - time) / fade, 0.0, 1.0);
}

}  // namespace

std::vector<std::vector<Interval>> rolling_intervals(const sim::Timeline& timeline,
                                                     std::span<const SoundBody> bodies) {
    std::vector<std::vector<Interval>> intervals(bodies.size());
    std::unordered_map<std::string_view, LoggedBall> balls;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const sim::Track* track = timeline.find(bodies[i].name);
        if (std::holds_alternative<BallShape>(bodies[i].shape) && track != nullptr) {
            balls.emplace(bodies[i].name, LoggedBall{track, &intervals[i], false, std::nullopt});
        }
    }
    for (const sim::Event& event : timeline.events) {
        const Effect effect = effect_of(event.kind);
        const auto found = balls.find(event.a);
        if (effect == Effect::none || found == balls.end()) {
            continue;
        }
        LoggedBall& ball = found->second;
        if (!ball.is_known && starts_on_cloth(*ball.track, timeline.start_time, event)) {
            ball.since = timeline.start_time;
        }
        ball.is_known = true;
        if (effect == Effect::ends) {
            ball.end(event.time);
        } else if (!ball.since) {
            ball.since = event.time;
        }
    }
    for (auto& [name, ball] : balls) {
        ball.end(timeline.end_time);
    }
    return intervals;
}

std::vector<RollingSource> rolling_sources(const SoundShot& shot) {
    const sim::Timeline& timeline = *shot.timeline;
    std::vector<RollingSource> sources;
    std::vector<std::vector<Interval>> rolling = rolling_intervals(timeline, shot.bodies);
    auto contacts = contacts_of(shot);
    for (std::size_t i = 0; i < shot.bodies.size(); ++i) {
        const SoundBody& body = shot.bodies[i];
        if (!rolling[i].empty()) {
            RollingSource& source =
                sources.emplace_back(source_of(body, "cloth", kCloth, timeline));
            source.intervals = std::move(rolling[i]);
            source.motion =
                RollingBall{std::get<BallShape>(body.shape).radius, std::move(contacts[body.name])};
        }
    }
    std::ranges::move(scraping_sources(shot), std::back_inserter(sources));
    return sources;
}

Vec3 RollingSource::place(double scene_time) const {
    return track != nullptr ? track->sample(scene_time).position : position;
}

std::vector<Interval>::const_iterator RollingSource::first_ending_after(double time) const {
    return std::ranges::partition_point(intervals,
                                        [&](const Interval& one) { return one.to <= time; });
}

bool RollingSource::sounds(double from, double to) const {
    const auto next = first_ending_after(std::min(from, to));
    return next != intervals.end() && next->from <= std::max(from, to);
}

BallCurves RollingSource::curves(const Interval& interval) const {
    if (const auto* ball = std::get_if<RollingBall>(&motion)) {
        return ball_curves(*track, ball->radius, interval.from, interval.to, ball->contacts);
    }
    const auto& scrapes = std::get<std::vector<Scrape>>(motion);
    const auto first = std::ranges::partition_point(
        scrapes, [&](const Scrape& scrape) { return scrape.to <= interval.from; });
    const auto last = std::partition_point(
        first, scrapes.end(), [&](const Scrape& scrape) { return scrape.from < interval.to; });
    return {{}, scraping_curve({first, last})};
}

RollingVoice::RollingVoice(const RollingSource& source)
    : source_(&source),
      rolled_(source.seed, source.texture),
      slid_(source.seed + kSplitMixStep, source.texture) {}

void RollingVoice::add(const ClipBlock& block, std::span<double> pressure) {
    CAROM_ASSERT(pressure.size() == block.scene_time.size());
    if (block.first != next_sample_) {
        rolled_.begin();
        slid_.begin();
    }
    next_sample_ = block.first + static_cast<std::int64_t>(pressure.size());
    if (pressure.empty() || !source_->sounds(block.scene_time.front(), block.scene_time.back())) {
        return;
    }
    for (std::size_t n = 0; n < pressure.size(); ++n) {
        const double time = block.scene_time[n];
        const Interval* interval = block.speed[n] > 0 ? interval_at(time, block.dynamics) : nullptr;
        if (interval != nullptr) {
            const double sum = rolled_.at(time, block.speed[n], block.ratio[n]) +
                               slid_.at(time, block.speed[n], block.ratio[n]);
            pressure[n] += block.fade[n] * fade_gain(*interval, time) * sum;
        }
    }
}

/// The interval with this time, or nullptr. Makes its curves.
const Interval* RollingVoice::interval_at(double time, double dynamics) {
    const std::vector<Interval>& intervals = source_->intervals;
    const auto is_in = [time](const Interval& one) { return one.from <= time && time < one.to; };
    if (present_ < intervals.size() && is_in(intervals[present_])) {
        return &intervals[present_];
    }
    const auto next = source_->first_ending_after(time);
    if (next == intervals.end() || !is_in(*next)) {
        return nullptr;
    }
    present_ = static_cast<std::size_t>(next - intervals.begin());
    BallCurves curves = source_->curves(*next);
    apply_dynamics(dynamics, curves);
    const std::uint64_t bits = split_mix(source_->seed + (present_ + 2) * kSplitMixStep);
    const double offset = kMinOffset * (1 + unit_number(bits));
    rolled_.set_curve(std::move(curves.rolled), offset);
    slid_.set_curve(std::move(curves.slid), offset);
    return &*next;
}

}  // namespace carom::sound
