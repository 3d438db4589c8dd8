#include "pipeline/job/film_sound.h"

#include <algorithm>
#include <utility>

#include "core/assert.h"
#include "pipeline/job/shot_sound.h"
#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/music_source.h"
#include "pipeline/video/sound_length.h"

namespace carom::pipeline {

namespace {

/// A sound that is made when it is first read.
class DeferredSound : public SoundSource {
  public:
    DeferredSound(SoundMaker make, SoundContext context)
        : make_(std::move(make)), context_(std::move(context)) {}

    std::size_t read(std::span<double> left, std::span<double> right) override {
        SoundSource* source = made();
        return source == nullptr ? 0 : source->read(left, right);
    }
    void skip(std::int64_t samples) override {
        if (SoundSource* source = made()) {
            source->skip(samples);
        }
    }

  private:
    SoundSource* made() {
        if (!is_made_) {
            source_ = make_(context_);
            is_made_ = true;
        }
        return source_.get();
    }

    SoundMaker make_;
    SoundContext context_;
    std::unique_ptr<SoundSource> source_;
    bool is_made_ = false;
};

/// A stretch of a sound.
struct Stretch {
    std::int64_t begin = 0;  // samples
    std::int64_t end = 0;
};

/// The samples of frames that follow each other are one stretch.
std::vector<Stretch> stretches_of(const std::vector<std::int64_t>& frames, const Rational& fps) {
    std::vector<Stretch> stretches;
    for (const std::int64_t frame : frames) {
        const Stretch own{first_sample(frame, fps), first_sample(frame + 1, fps)};
        if (!stretches.empty() && stretches.back().end == own.begin) {
            stretches.back().end = own.end;
        } else {
            stretches.push_back(own);
        }
    }
    return stretches;
}

/// Stretches of another sound, one after the other.
class SelectedSound : public SoundSource {
  public:
    SelectedSound(std::unique_ptr<SoundSource> whole, std::vector<Stretch> stretches)
        : whole_(std::move(whole)), stretches_(std::move(stretches)) {}

    std::size_t read(std::span<double> left, std::span<double> right) override {
        while (next_ < stretches_.size() && at_ >= stretches_[next_].end) {
            ++next_;
        }
        if (next_ == stretches_.size()) {
            return 0;
        }
        const Stretch& stretch = stretches_[next_];
        if (at_ < stretch.begin) {
            whole_->skip(stretch.begin - at_);
            at_ = stretch.begin;
        }
        const auto wanted = std::min(left.size(), static_cast<std::size_t>(stretch.end - at_));
        const std::size_t got = whole_->read(left.first(wanted), right.first(wanted));
        at_ += static_cast<std::int64_t>(got);
        return got;
    }

  private:
    std::unique_ptr<SoundSource> whole_;
    std::vector<Stretch> stretches_;
    std::size_t next_ = 0;
    std::int64_t at_ = 0;  // the next sample of the whole sound
};

bool wants_sound(const SoundMaker& make, const OutputSettings& output) {
    return (make || output.music) && output.audio != AudioCodec::none;
}

}  // namespace

SoundMaker with_warnings(SoundMaker make,
                         std::function<void(const std::string& message)> on_warning) {
    if (!make) {
        return {};
    }
    return [make = std::move(make), on_warning = std::move(on_warning)](SoundContext context) {
        context.on_warning = on_warning;
        return make(context);
    };
}

std::unique_ptr<SoundSource> sound_of_film(const SoundMaker& make, const OutputSettings& output,
                                           const SoundedFilm& film) {
    if (!wants_sound(make, output)) {
        return nullptr;
    }
    const std::int64_t samples = first_sample(film.frames, film.fps);
    const auto silence = [samples] {
        sound::SoundScene scene;
        scene.frames = samples;
        return scene;
    };
    SoundContext context;
    if (output.music) {
        context.music = music_of(*output.music, samples);
    }
    return std::make_unique<DeferredSound>(make ? make : computed_sound(silence, {}),
                                           std::move(context));
}

std::unique_ptr<SoundSource> sound_of_frames(const SoundMaker& make, const OutputSettings& output,
                                             const SoundedFilm& film,
                                             const std::vector<std::int64_t>& frames) {
    CAROM_ASSERT(std::ranges::is_sorted(frames));
    std::unique_ptr<SoundSource> whole = sound_of_film(make, output, film);
    if (whole == nullptr || lacks_sound(frames)) {
        return nullptr;
    }
    return std::make_unique<SelectedSound>(std::move(whole), stretches_of(frames, film.fps));
}

double sound_bytes(const SoundMaker& make, const OutputSettings& output, const std::string& path,
                   const SoundedFilm& film, const std::vector<std::int64_t>& frames) {
    constexpr double kPcm = 6.0 * kSoundRate;  // bytes/s: two channels of 24 bits
    // FLAC halves 24-bit noise that fades away, as most of a film's sound does.
    constexpr double kFlac = kPcm / 2;
    if (!wants_sound(make, output)) {
        return 0;
    }
    if (is_image_sequence(path)) {
        return kPcm * static_cast<double>(film.frames) / film.fps.to_double();
    }
    const AudioCodec codec = audio_codec_for(output, path);
    if (lacks_sound(frames) || codec == AudioCodec::none) {
        return 0;
    }
    const double rate = codec == AudioCodec::pcm    ? kPcm
                        : codec == AudioCodec::flac ? kFlac
                                                    : audio_bit_rate_of(output, codec) / 8;
    return rate * static_cast<double>(frames.size()) / film.fps.to_double();
}

bool lacks_sound(const std::vector<std::int64_t>& frames) {
    std::size_t jumps = 0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        jumps += frames[i] == frames[i - 1] + 1 ? 0 : 1;
    }
    return 2 * jumps > frames.size() || (frames.size() == 2 && jumps == 1);
}

std::string silence_note(const SoundMaker& make, const OutputSettings& output,
                         const std::string& path, const std::vector<std::int64_t>& frames) {
    if (!wants_sound(make, output) || path.empty() || is_image_sequence(path) ||
        !lacks_sound(frames)) {
        return {};
    }
    return "the film has no sound, because it leaves out frames between those that it shows";
}

}  // namespace carom::pipeline
