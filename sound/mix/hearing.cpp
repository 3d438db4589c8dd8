#include "sound/mix/hearing.h"

#include <algorithm>
#include <utility>

#include "core/elementary.h"
#include "sound/level/decibels.h"
#include "sound/rolling/passage_block.h"
#include "sound/source/sphere_sound.h"

namespace carom::sound {
namespace {

// A contact is at least this many samples of the film long, so that its spectrum ends before half
// of the sample rate.
constexpr double kShortestContact = 3;

constexpr double kHighestMode = 0.45 * kSampleRate;  // Hz, in the film

/// For the film's samples: what they cannot show is left out.
void fit_to_samples(double time_factor, ImpactSound& sound) {
    sound.contact_time = std::max(sound.contact_time, kShortestContact * time_factor / kSampleRate);
    std::erase_if(sound.modes, [time_factor](const Mode& mode) {
        return mode.frequency * time_factor > kHighestMode;
    });
}

}  // namespace

bool is_mirrored(const Passage& passage) {
    return passage.settings.mirrors_reverse &&
           passage.scene_time(passage.to) < passage.scene_time(passage.from);
}

Hearing::Hearing(const SoundScene& scene) : scene_(scene) {
    for (const SoundShot& shot : scene.shots) {
        sounds_.emplace_back(shot);
    }
}

std::optional<Heard> Hearing::at(const Crossing& crossing) const {
    const SoundShot& shot = scene_.shots[crossing.shot];
    const sim::Event& event = shot.timeline->events[crossing.event];
    const Passage& passage = shot.passages[crossing.passage];
    const PassageSettings& settings = passage.settings;
    const double weight = passage.weight(crossing.film_time);
    std::optional<ImpactSound> sound = sounds_[crossing.shot].sound_of(event);
    if (!sound || !(weight > 0)) {
        return std::nullopt;
    }
    Heard heard;
    heard.listener = passage.listener(crossing.film_time);
    heard.settings = settings;
    heard.is_mirrored = is_mirrored(passage);
    HeardImpact& row = heard.row;
    row.speed = passage.speed(crossing.film_time);
    row.time_factor = playing_speed(row.speed, settings);
    fit_to_samples(row.time_factor, *sound);
    heard.arrival = arrival_at(heard.listener.position, *sound);
    const double source = find_peak(arrival_at(average_place(*sound), *sound)).pressure;
    if (source < kReferencePressure) {
        return std::nullopt;
    }
    const Peak peak = find_peak(heard.arrival);
    row.film_time = crossing.film_time;
    row.scene_time = event.time;
    row.shot = crossing.shot;
    row.event = crossing.event;
    row.kind = event.kind;
    row.group = sound->group;
    row.a = event.a;
    row.b = event.b;
    row.camera = passage.camera;
    row.distance = heard.arrival.distance;
    row.delay = settings.has_delay ? row.distance / kSpeedOfSound : 0;
    row.impulse = sound->impulse;
    row.contact_time = sound->contact_time;
    row.peak = peak.pressure;
    const double slowed = peak.time / row.time_factor;
    row.peak_time = row.film_time + row.delay + (heard.is_mirrored ? -slowed : slowed);
    row.gain = settings.gain + settings.mix[static_cast<std::size_t>(row.group)] +
               decibels_of(dynamics_factor(source, settings.ratio, kQuietImpact)) +
               decibels_of(weight);
    heard.sound = std::move(*sound);
    return heard;
}

double Hearing::longest_mirrored_ring(std::size_t shot) const {
    double slowest = 0;
    for (const Passage& passage : scene_.shots[shot].passages) {
        if (is_mirrored(passage)) {
            const double factor = playing_speed(0, passage.settings);
            slowest = slowest > 0 ? std::min(slowest, factor) : factor;
        }
    }
    constexpr double kFalls = 8.3;  // ln 4000
    return slowest > 0 ? kFalls * sounds_[shot].longest_decay() / slowest : 0;
}

}  // namespace carom::sound
