#include "pipeline/job/shot_sound.h"

#include <utility>

#include "core/error.h"
#include "core/progress.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/sound/film_scene.h"
#include "pipeline/sound/loudness_note.h"
#include "sound/mix/film_sound.h"

namespace carom::pipeline {

namespace {

class ComputedSound : public SoundSource {
  public:
    ComputedSound(const sound::SoundScene& scene, const SoundContext& context, std::stop_token stop)
        : context_(context),
          stop_(std::move(stop)),
          sound_(scene, {.added = context.music}, WorkContext{{}, stop_}) {
        scene_.full_scale = scene.full_scale;
        scene_.loudness = scene.loudness;
        scene_.frames = scene.frames;
        warn(missed_loudness_note(scene_, sound_.gain()));
    }

    std::size_t read(std::span<double> left, std::span<double> right) override {
        if (stop_.stop_requested()) {
            throw Stopped();
        }
        const std::size_t count = sound_.read(left, right);
        if (!is_told_ && sound_.position() == sound_.frames()) {
            is_told_ = true;
            warn(fixed_gain_note(scene_, static_cast<bool>(context_.music), sound_.levels()));
            warn(quiet_film_note(sound_.levels().loudness, sound_.gentle_loudness({{}, stop_})));
        }
        return count;
    }

  private:
    void warn(const std::string& note) const {
        if (!note.empty() && context_.on_warning) {
            context_.on_warning(note);
        }
    }

    SoundContext context_;
    sound::SoundScene scene_;  // what it asks for, without its shots
    std::stop_token stop_;
    sound::FilmSound sound_;
    bool is_told_ = false;  // what is known at the end
};

}  // namespace

SoundMaker computed_sound(std::function<sound::SoundScene()> scene, std::stop_token stop) {
    return [scene = std::move(scene), stop = std::move(stop)](const SoundContext& context) {
        return std::make_unique<ComputedSound>(scene(), context, stop);
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
