#include "pipeline/studio/heard_film.h"

#include <cstddef>
#include <map>
#include <utility>
#include <variant>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/job/film_sound.h"
#include "pipeline/job/shot_sound.h"
#include "pipeline/sequence/sequence_scene.h"
#include "pipeline/video/sound_length.h"

namespace carom::studio {

namespace {

constexpr const char* kSilent = "the shot says 'sound: none', so its film is silent";
constexpr const char* kSilentShots = "all shots say 'sound: none', so the film is silent";
constexpr const char* kSilentFile = "the output says 'audio: none', so the film is silent";
constexpr const char* kNoCamera = "no camera films the shot, so nothing is heard";
constexpr const char* kNotSimulated =
    "a shot of the film takes long to simulate, so the page has no sound of it";

/// `sound`: makes what is heard without the music; empty, with the reason why, if it is nothing.
HeardFilm film_of(std::function<pipeline::SoundMaker(const std::stop_token& stop)> sound,
                  const char* reason, const pipeline::OutputSettings& output,
                  const pipeline::SoundedFilm& film) {
    if (output.audio == pipeline::AudioCodec::none) {
        return {.reason = kSilentFile};
    }
    if (!sound && !output.music) {
        return {.reason = reason};
    }
    return {.samples = pipeline::first_sample(film.frames, film.fps),
            .make = [sound = std::move(sound), &output, film](const std::stop_token& stop) {
                return pipeline::sound_of_film(sound ? sound(stop) : pipeline::SoundMaker(), output,
                                               film);
            }};
}

/// The motions by the numbers of their parts, and whether all shots are silent.
struct PartMotions {
    std::map<std::size_t, const sim::Timeline*> timelines;
    bool is_silent = true;
    bool is_complete = true;
};

PartMotions motions_of(const SequenceAnswer& film) {
    PartMotions motions;
    const auto& parts = film.sequence->parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto* part = std::get_if<pipeline::ShotPart>(&parts[i].content);
        if (part == nullptr) {
            continue;
        }
        motions.is_complete = motions.is_complete && film.timelines[i] != nullptr;
        motions.timelines[i] = film.timelines[i].get();
        motions.is_silent = motions.is_silent && part->shot.sound.is_silent;
    }
    return motions;
}

}  // namespace

HeardFilm heard_film(const pipeline::Shot& shot, const sim::Timeline& timeline) {
    const std::int64_t frames = pipeline::frame_count(shot.cameras, shot.timing);
    if (frames == 0) {
        return {.reason = kNoCamera};
    }
    std::function<pipeline::SoundMaker(const std::stop_token&)> sound;
    if (!shot.sound.is_silent) {
        sound = [&shot, &timeline](const std::stop_token& stop) {
            return pipeline::shot_sound(shot, timeline, stop);
        };
    }
    return film_of(std::move(sound), kSilent, shot.output, {frames, shot.timing.fps});
}

HeardFilm heard_film(const SequenceAnswer& film) {
    const pipeline::Sequence& sequence = *film.sequence;
    PartMotions motions = motions_of(film);
    std::function<pipeline::SoundMaker(const std::stop_token&)> sound;
    if (!motions.is_silent) {
        if (!motions.is_complete) {
            return {.reason = kNotSimulated};
        }
        sound = [&sequence, timelines = std::move(motions.timelines)](const std::stop_token& stop) {
            return pipeline::computed_sound(
                [&sequence, timelines] {
                    return pipeline::sequence_scene(sequence, timelines, 0, sequence.frames());
                },
                stop);
        };
    }
    return film_of(std::move(sound), kSilentShots, sequence.output,
                   {sequence.frames(), sequence.fps});
}

}  // namespace carom::studio
