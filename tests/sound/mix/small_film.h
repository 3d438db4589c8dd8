// Small films for tests: two balls that collide at known times, and what is heard of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sound/mix/film_sound.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// A shot with two pool balls, "cue" and "one", which lie at rest and touch at the origin along x,
/// and a film of it in pascals: mono, without a room, without dynamics.
struct SmallFilm {
    SmallFilm();
    SmallFilm(const SmallFilm&) = delete;
    SmallFilm& operator=(const SmallFilm&) = delete;
    SmallFilm(SmallFilm&&) = delete;
    SmallFilm& operator=(SmallFilm&&) = delete;
    ~SmallFilm() = default;

    /// The two balls collide with this closing speed, m/s.
    void collide(double time, double speed = 1);

    /// The cue ball touches a surface.
    void touch(double time, const std::string& surface, double impulse);

    /// Adds a clip of a camera at `place`, which shows `scene_from` + speed (t - from).
    Clip& show(double from, double to, double scene_from, double speed,
               const Vec3& place = {0, -1, 0});

    SoundShot& shot() { return scene.shots.front(); }

    sim::Timeline timeline;
    SoundScene scene;
};

struct Samples {
    std::vector<double> left, right;
};

/// All samples, read in blocks of this size. With a fixed gain they are not limited.
[[nodiscard]] Samples samples_of(const SoundScene& scene, FilmSoundOptions options = {},
                                 std::size_t block = 1024);

/// The highest absolute value in [from, to) samples.
[[nodiscard]] double highest(const std::vector<double>& samples, std::size_t from = 0,
                             std::size_t to = SIZE_MAX);

}  // namespace carom::sound
