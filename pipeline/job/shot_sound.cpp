#include "pipeline/job/shot_sound.h"

#include <utility>

#include "core/error.h"
#include "core/progress.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/sound/film_scene.h"
#include "sound/mix/film_sound.h"

namespace carom::pipeline {

namespace {

class ComputedSound : public SoundSource {
  public:
    ComputedSound(sound::SoundScene scene, std::stop_token stop)
        : stop_(std::move(stop)), sound_(std::move(scene), {}, WorkContext{{}, stop_}) {}

    std::size_t read(std::span<double> left, std::span<double> right) override {
        if (stop_.stop_requested()) {
            throw Stopped();
        }
        return sound_.read(left, right);
    }

  private:
    std::stop_token stop_;
    sound::FilmSound sound_;
};

}  // namespace

SoundMaker computed_sound(std::function<sound::SoundScene()> scene, std::stop_token stop) {
    return [scene = std::move(scene), stop = std::move(stop)] {
        return std::make_unique<ComputedSound>(scene(), stop);
    };
}

SoundMaker shot_sound(const Shot& shot, const sim::Timeline& timeline, std::stop_token stop) {
    if (shot.sound.is_silent) {
        return {};
    }
    return computed_sound(
        [&shot, &timeline] {
            return film_scene(shot, timeline, 0, frame_count(shot.cameras, shot.timing));
        },
        std::move(stop));
}

SoundMaker job_sound(const FilmJobOptions& options, const Shot& shot, const sim::Timeline& timeline,
                     std::stop_token stop) {
    if (options.sound) {
        return options.sound;
    }
    return shot_sound(shot, timeline, std::move(stop));
}

}  // namespace carom::pipeline
