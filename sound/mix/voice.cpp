#include "sound/mix/voice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sound/level/decibels.h"
#include "sound/space/room.h"

namespace carom::sound {
namespace {

constexpr double kEndsAt = 1e-3;  // of the peak: -60 dB, from which it fades out

Ears scaled(Ears ears, double factor) {
    for (Ear* ear : {&ears.left, &ears.right}) {
        ear->b0 *= factor;
        ear->b1 *= factor;
    }
    return ears;
}

BusInput input_of(BusInput::To to, const Ear& ear, bool is_reflected) {
    return {to, is_reflected, ear.a1 != 0, ear.b0, ear.b1, 0};
}

/// Where a listener would hear directly what the real one hears from a wall: its mirror image. A
/// dipole is then seen from the right side.
Vec3 mirrored(const Vec3& listener, const Reflection& reflection, const Vec3& source) {
    Vec3 place = listener;
    const int axis = reflection.axis;
    place[axis] = reflection.image[axis] + source[axis] - listener[axis];
    return place;
}

std::size_t delay_in_samples(double seconds) {
    return static_cast<std::size_t>(std::max(0.0, std::nearbyint(seconds * kSampleRate)));
}

}  // namespace

Voice::Voice(const AuralisedImpact& heard, const RoomSettings& room)
    : rate_(heard.is_mirrored ? -heard.row.time_factor : heard.row.time_factor),
      contact_time_(heard.direct.contact_time),
      shape_(heard.direct.shape) {
    const double factor = factor_of(heard.row.gain);
    least_ = kEndsAt * heard.row.peak * factor;
    const std::size_t spheres = add_spheres(heard.direct.spheres, factor);
    const std::size_t modes = add_modes(heard.direct, factor);
    const double arrival = heard.row.film_time + heard.row.delay;
    const Ears ears =
        ears_of(heard.settings.stereo, heard.settings.width, heard.listener, heard.sound.place);
    play_at_ears(spheres, arrival, ears, false);
    play_at_ears(modes, arrival, scaled(ears, 1 / heard.direct.distance), false);
    if (room.kind != RoomSettings::Kind::none) {
        play_in_room(heard, room, modes, factor);
    }
    if (playing_.empty()) {
        return;
    }
    first_ = std::ranges::min(playing_, {}, &Playing::first).first;
    last_ = std::ranges::max(playing_, {}, &Playing::last).last;
}

std::size_t Voice::add_spheres(const std::vector<SphereWave>& spheres, double factor) {
    Waves waves;
    for (const SphereWave& sphere : spheres) {
        const Partial partial{sphere.partial.pole, factor * sphere.partial.residue};
        waves.push_back(
            {sphere.onset, ModeBank(contact_time_, std::span(&partial, 1), least_, shape_)});
    }
    waves_.push_back(std::move(waves));
    return waves_.size() - 1;
}

/// The modes at 1 m.
std::size_t Voice::add_modes(const DirectSound& sound, double factor) {
    std::vector<Partial> partials = sound.modes;
    for (Partial& partial : partials) {
        partial.residue = (factor * sound.distance) * partial.residue;
    }
    Waves waves;
    if (!partials.empty()) {
        waves.push_back({0, ModeBank(contact_time_, partials, least_ * sound.distance, shape_)});
    }
    waves_.push_back(std::move(waves));
    return waves_.size() - 1;
}

void Voice::play(std::size_t waves, double arrival, std::vector<BusInput> outputs) {
    if (waves_[waves].empty()) {
        return;
    }
    double begin = waves_[waves].front().onset;
    double end = begin;
    for (const Wave& wave : waves_[waves]) {
        begin = std::min(begin, wave.onset);
        end = std::max(end, wave.onset + wave.bank.end());
    }
    const auto [film_begin, film_end] =
        std::minmax({arrival + begin / rate_, arrival + end / rate_});
    playing_.push_back(
        {waves, arrival, static_cast<std::int64_t>(std::floor(film_begin * kSampleRate)),
         static_cast<std::int64_t>(std::ceil(film_end * kSampleRate)) + 2, std::move(outputs)});
}

void Voice::play_at_ears(std::size_t waves, double arrival, const Ears& ears, bool is_reflected) {
    const BusInput left = input_of(BusInput::To::left, ears.left, is_reflected);
    const BusInput right = input_of(BusInput::To::right, ears.right, is_reflected);
    if (ears.left.delay == ears.right.delay) {
        play(waves, arrival + ears.left.delay, {left, right});
    } else {
        play(waves, arrival + ears.left.delay, {left});
        play(waves, arrival + ears.right.delay, {right});
    }
}

void Voice::play_in_room(const AuralisedImpact& heard, const RoomSettings& room, std::size_t modes,
                         double factor) {
    const Vec3& source = heard.sound.place;
    const double instant = heard.row.film_time;
    // Without a delay, all paths are shortened by that of the direct sound.
    const double early = heard.settings.has_delay ? 0 : heard.row.distance / kSpeedOfSound;
    std::vector<BusInput> mode_outputs{{BusInput::To::room, false, false, 1, 0, 0}};
    for (const Reflection& reflection : reflections_of(room, source, heard.listener.position)) {
        const Vec3 listener = mirrored(heard.listener.position, reflection, source);
        const double distance = std::max((listener - source).length(), kNearest);
        const double delay = distance / kSpeedOfSound - early;
        const Ears ears = scaled(
            ears_of(heard.settings.stereo, heard.settings.width, heard.listener, reflection.image),
            reflection.gain);
        play_at_ears(add_spheres(spheres_at(listener, heard.sound, distance), factor),
                     instant + delay, ears, true);
        const Ears far = scaled(ears, 1 / distance);
        mode_outputs.push_back(input_of(BusInput::To::left, far.left, true));
        mode_outputs.back().delay = delay_in_samples(delay + far.left.delay);
        mode_outputs.push_back(input_of(BusInput::To::right, far.right, true));
        mode_outputs.back().delay = delay_in_samples(delay + far.right.delay);
    }
    play(modes, instant, std::move(mode_outputs));
    if (!heard.sound.spheres.empty()) {
        const Vec3 place = average_place(heard.sound);
        play(add_spheres(spheres_at(place, heard.sound, 1), factor), instant,
             {{BusInput::To::room, false, false, 1, 0, 0}});
    }
}

void Voice::add(std::int64_t block, ShotBus& bus) const {
    for (const Playing& playing : playing_) {
        if (playing.last < block || playing.first >= block + static_cast<std::int64_t>(kBlock)) {
            continue;
        }
        std::array<double, kBlock + 1> samples{};
        const double film_time = time_of_sample(block - 1);
        const double scene_time = (film_time - playing.arrival) * rate_;
        for (const Wave& wave : waves_[playing.waves]) {
            wave.bank.add(scene_time - wave.onset, rate_ / kSampleRate, samples);
        }
        for (const BusInput& output : playing.outputs) {
            bus.add(output, samples);
        }
    }
}

}  // namespace carom::sound
