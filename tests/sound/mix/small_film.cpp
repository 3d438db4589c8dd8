#include "small_film.h"

#include <algorithm>
#include <cmath>

#include "sound/source/defaults.h"

namespace carom::sound {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.1701;

}  // namespace

SmallFilm::SmallFilm() {
    sim::Key cue;
    cue.position = {-kRadius, 0, 0};
    sim::Key one;
    one.position = {kRadius, 0, 0};
    timeline.tracks.emplace_back("cue", std::vector{cue});
    timeline.tracks.emplace_back("one", std::vector{one});
    timeline.end_time = 1000;
    SoundShot added;
    added.timeline = &timeline;
    added.bodies = {{"cue", BallShape{kRadius}, kMass, default_material("ball"), {}},
                    {"one", BallShape{kRadius}, kMass, default_material("ball"), {}}};
    added.resonators = default_resonators(kMass);
    added.room.kind = RoomSettings::Kind::none;
    scene.shots.push_back(std::move(added));
    scene.frames = kSampleRate;
    scene.full_scale = 1;
}

void SmallFilm::collide(double time, double speed) {
    sim::Event event;
    event.time = time;
    event.a = "cue";
    event.b = "one";
    event.normal = {-1, 0, 0};
    event.normal_impulse = kMass / 2 * 1.95 * speed;
    timeline.events.push_back(event);
}

void SmallFilm::touch(double time, const std::string& surface, double impulse) {
    sim::Event event;
    event.time = time;
    event.a = "cue";
    event.b = surface;
    event.normal = {0, 0, 1};
    event.place = {-kRadius, 0, -kRadius};
    event.normal_impulse = impulse;
    timeline.events.push_back(event);
}

Clip& SmallFilm::show(double from, double to, double scene_from, double speed, const Vec3& place) {
    Clip clip;
    clip.from = from;
    clip.to = to;
    clip.camera = "camera";
    clip.scene_time = [=](double t) { return scene_from + speed * (t - from); };
    clip.speed = [=](double) { return speed; };
    clip.listener = [=](double) {
        Listener listener;
        listener.position = place;
        return listener;
    };
    clip.weight = [](double) { return 1.0; };
    clip.settings.stereo = Stereo::mono;
    clip.settings.ratio = 1;
    shot().clips.push_back(std::move(clip));
    return shot().clips.back();
}

Samples samples_of(const SoundScene& scene, FilmSoundOptions options, std::size_t block) {
    if (scene.full_scale && !scene.loudness && !options.gain) {
        options.gain = FilmGain{.full_scale = *scene.full_scale, .added = *scene.full_scale};
    }
    FilmSound sound(scene, options);
    Samples samples;
    std::vector<double> left(block);
    std::vector<double> right(block);
    while (const std::size_t count = sound.read(left, right)) {
        samples.left.insert(samples.left.end(), left.begin(),
                            left.begin() + static_cast<std::ptrdiff_t>(count));
        samples.right.insert(samples.right.end(), right.begin(),
                             right.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return samples;
}

double highest(const std::vector<double>& samples, std::size_t from, std::size_t to) {
    double result = 0;
    for (std::size_t i = from; i < std::min(to, samples.size()); ++i) {
        result = std::max(result, std::abs(samples[i]));
    }
    return result;
}

}  // namespace carom::sound
