#include "pipeline/sequence/sequence_scene.h"

#include <variant>
#include <vector>

#include "pipeline/sound/film_scene.h"
#include "pipeline/video/sound_length.h"

namespace carom::pipeline {

sound::SoundScene sequence_scene(const Sequence& sequence,
                                 const std::map<std::size_t, const sim::Timeline*>& timelines,
                                 std::int64_t first, std::int64_t frames) {
    const auto time = [&](std::int64_t frame) {
        return (Rational(frame) / sequence.fps).to_double();
    };
    sound::SoundScene scene;
    scene.frames = first_sample(frames, sequence.fps);
    const std::vector<std::int64_t> starts = sequence.starts();
    for (const auto& [i, timeline] : timelines) {
        const SequencePart& part = sequence.parts[i];
        const auto& shot = std::get<ShotPart>(part.content);
        ShownPart shown;
        shown.from = time(shot.first);
        shown.to = time(shot.first + part.frames);
        shown.start = time(starts[i] - first);
        shown.fade_in = time(part.fade);
        shown.fade_out = i + 1 < sequence.parts.size() ? time(sequence.parts[i + 1].fade) : 0;
        shown.film_end = time(frames);
        scene.shots.push_back(sound_shot(shot.shot, *timeline, shown));
        if (!scene.full_scale && !scene.loudness) {
            scene.full_scale = shot.shot.sound.full_scale;
            scene.loudness = shot.shot.sound.loudness;
        }
    }
    return scene;
}

}  // namespace carom::pipeline
