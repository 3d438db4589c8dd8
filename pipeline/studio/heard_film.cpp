#include "pipeline/studio/heard_film.h"

#include <cstddef>
#include <map>
#include <variant>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/sequence/sequence_scene.h"
#include "pipeline/sound/film_scene.h"

namespace carom::studio {

namespace {

constexpr const char* kSilent = "the shot says 'sound: none', so its film is silent";
constexpr const char* kSilentShots = "all shots say 'sound: none', so the film is silent";
constexpr const char* kNoCamera = "no camera films the shot, so nothing is heard";
constexpr const char* kNotSimulated =
    "a shot of the film takes long to simulate, so the page has no sound of it";

}  // namespace

HeardFilm heard_film(const pipeline::Shot& shot, const sim::Timeline& timeline) {
    if (shot.sound.is_silent) {
        return {kSilent, {}};
    }
    const std::int64_t frames = pipeline::frame_count(shot.cameras, shot.timing);
    if (frames == 0) {
        return {kNoCamera, {}};
    }
    return {"", pipeline::film_scene(shot, timeline, 0, frames)};
}

HeardFilm heard_film(const SequenceAnswer& film) {
    std::map<std::size_t, const sim::Timeline*> timelines;
    bool is_silent = true;
    const auto& parts = film.sequence->parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto* part = std::get_if<pipeline::ShotPart>(&parts[i].content);
        if (part == nullptr) {
            continue;
        }
        if (!film.timelines[i]) {
            return {kNotSimulated, {}};
        }
        timelines[i] = film.timelines[i].get();
        is_silent = is_silent && part->shot.sound.is_silent;
    }
    if (is_silent) {
        return {kSilentShots, {}};
    }
    return {"", pipeline::sequence_scene(*film.sequence, timelines, 0, film.sequence->frames())};
}

}  // namespace carom::studio
