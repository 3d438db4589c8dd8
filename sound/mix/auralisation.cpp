#include "sound/mix/auralisation.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "sound/level/decibels.h"
#include "sound/rolling/clip_block.h"

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

/// Whether a clip plays its sounds mirrored in time.
bool is_mirrored(const Clip& clip) {
    return clip.settings.mirrors_reverse && clip.scene_time(clip.to) < clip.scene_time(clip.from);
}

}  // namespace

Auralisation::Auralisation(const SoundScene& scene) : scene_(scene) {
    for (const SoundShot& shot : scene.shots) {
        sounds_.emplace_back(shot);
    }
}

std::optional<AuralisedImpact> Auralisation::at(const Onset& onset) const {
    const SoundShot& shot = scene_.shots[onset.shot];
    const sim::Event& event = shot.timeline->events[onset.event];
    const Clip& clip = shot.clips[onset.clip];
    const ClipSettings& settings = clip.settings;
    const double weight = clip.weight(onset.film_time);
    std::optional<ImpactSound> sound = sounds_[onset.shot].sound_of(event);
    if (!sound || !(weight > 0)) {
        return std::nullopt;
    }
    AuralisedImpact heard;
    heard.listener = clip.listener(onset.film_time);
    heard.settings = settings;
    heard.is_mirrored = is_mirrored(clip);
    AudibleImpact& row = heard.row;
    row.speed = clip.speed(onset.film_time);
    row.time_factor = playing_speed(row.speed, settings);
    fit_to_samples(row.time_factor, *sound);
    heard.direct = direct_sound_at(heard.listener.position, *sound);
    const double source = find_peak(direct_sound_at(average_place(*sound), *sound)).pressure;
    if (source < kReferencePressure) {
        return std::nullopt;
    }
    const Peak peak = find_peak(heard.direct);
    row.film_time = onset.film_time;
    row.scene_time = event.time;
    row.shot = onset.shot;
    row.event = onset.event;
    row.kind = event.kind;
    row.group = sound->group;
    row.a = event.a;
    row.b = event.b;
    row.camera = clip.camera;
    row.distance = heard.direct.distance;
    row.delay = settings.has_delay ? row.distance / kSpeedOfSound : 0;
    row.impulse = sound->impulse;
    row.contact_time = sound->contact_time;
    row.peak = peak.pressure;
    const double slowed = peak.time / row.time_factor;
    row.peak_time = row.film_time + row.delay + (heard.is_mirrored ? -slowed : slowed);
    row.gain = settings.gain + settings.mix[static_cast<std::size_t>(row.group)] +
               decibels_of(compressor_gain(source, settings.ratio, kQuietImpact)) +
               decibels_of(weight);
    heard.sound = std::move(*sound);
    return heard;
}

double Auralisation::longest_mirrored_ring(std::size_t shot) const {
    double slowest = 0;
    for (const Clip& clip : scene_.shots[shot].clips) {
        if (is_mirrored(clip)) {
            const double factor = playing_speed(0, clip.settings);
            slowest = slowest > 0 ? std::min(slowest, factor) : factor;
        }
    }
    constexpr double kFalls = 8.3;  // ln 4000
    return slowest > 0 ? kFalls * sounds_[shot].longest_decay() / slowest : 0;
}

std::vector<AudibleImpact> audible_impacts(const SoundScene& scene, const WorkContext& context) {
    const Auralisation auralisation(scene);
    const double length = time_of_sample(scene.frames);
    std::vector<AudibleImpact> rows;
    for (const Onset& onset : onsets_of(scene)) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        if (onset.film_time >= length) {
            break;
        }
        if (const std::optional<AuralisedImpact> heard = auralisation.at(onset)) {
            rows.push_back(heard->row);
        }
        if (context.progress) {
            context.progress(onset.film_time / length);
        }
    }
    if (context.progress) {
        context.progress(1);
    }
    return rows;
}

}  // namespace carom::sound
