#include "pipeline/job/film_sink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/job/exported_frame.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/job/frame_signal.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/job/shot_sound.h"
#include "pipeline/job/viewed_frame.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/light_meter.h"
#include "pipeline/video/pending_file.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/sound_length.h"
#include "pipeline/video/video_writer.h"
#include "pipeline/video/view_transform.h"
#include "sound/file/wav_file.h"

namespace carom::pipeline {
namespace {

/// The frame that the poster shows: the frame at that video time, or the next one that the film
/// has, or its last frame.
std::optional<std::int64_t> poster_frame(const Shot& shot, const FilmPlan& plan) {
    if (!shot.output.poster) {
        return std::nullopt;
    }
    const auto wanted =
        static_cast<std::int64_t>(std::floor(*shot.output.poster * shot.timing.fps.to_double()));
    const auto found = std::lower_bound(plan.frames.begin(), plan.frames.end(), wanted);
    return found == plan.frames.end() ? plan.frames.back() : *found;
}

SoundedFilm sounded_film(const Shot& shot) {
    return {frame_count(shot.cameras, shot.timing), shot.timing.fps};
}

class VideoSink : public FilmSink {
  public:
    VideoSink(const FilmSource& source, const FilmPlan& plan, const std::string& path, int threads,
              SoundMaker sound)
        : source_(source),
          shot_(source.shot()),
          frames_(plan.frames),
          path_(path),
          sound_(std::move(sound)),
          signal_(source, threads),
          poster_(poster_frame(shot_, plan)) {
        open();
    }

    /// HDR10 stores the film's light levels in the header of the file.
    [[nodiscard]] bool wants_preview() const override { return shot_.output.hdr10.has_value(); }

    void preview(std::int64_t frame, const render::Film& picture, bool same_as_before) override {
        meter_.add(signal_.of(frame, picture, same_as_before));
        light_is_stated_ = false;
    }

    void add(std::int64_t frame, const render::Film& picture, bool same_as_before) override {
        if (!light_is_stated_) {
            writer_.reset();  // it was opened before the light levels were known
            open();
        }
        writer_->write(signal_.of(frame, picture, same_as_before));
        if (frame != poster_) {
            return;
        }
        std::vector<std::uint8_t> poster = signal_.poster(frame, picture);
        if (writer_->has_poster()) {
            writer_->set_poster(poster);
        } else {
            poster_picture_ = std::move(poster);
        }
    }

    void finish() override {
        writer_->finish();
        if (poster_picture_) {
            const std::filesystem::path path(path_);
            const std::string name = path.stem().string() + "-poster.jpg";
            write_display_picture(*poster_picture_, shot_.render.width, shot_.render.height,
                                  (path.parent_path() / name).string());
        }
    }

  private:
    void open() {
        VideoFormat format{shot_.render.width, shot_.render.height, shot_.timing.fps};
        if (!light_is_stated_) {
            format.light = meter_.levels();
            light_is_stated_ = true;
        }
        writer_ = std::make_unique<VideoWriter>(
            path_, format, shot_.output, video_metadata(shot_),
            sound_of_frames(sound_, shot_.output, sounded_film(shot_), frames_));
    }

    const FilmSource& source_;
    const Shot& shot_;
    const std::vector<std::int64_t>& frames_;
    std::string path_;
    SoundMaker sound_;
    FrameSignal signal_;
    std::optional<std::int64_t> poster_;
    std::optional<std::vector<std::uint8_t>> poster_picture_;  // for a file beside the video
    LightMeter meter_;
    bool light_is_stated_ = true;  // the writer knows the light levels, or does not need them
    std::unique_ptr<VideoWriter> writer_;
};

void write_wav(SoundSource& sound, std::int64_t samples, const std::string& path) {
    sound::WavFile file(path, samples);
    std::array<double, kSoundBlock> left{};
    std::array<double, kSoundBlock> right{};
    while (samples > 0) {
        const auto wanted = std::min(static_cast<std::size_t>(samples), kSoundBlock);
        std::size_t got = sound.read(std::span(left).first(wanted), std::span(right).first(wanted));
        if (got == 0) {  // it ended before the film
            got = wanted;
            left.fill(0);
            right.fill(0);
        }
        file.write(std::span(left).first(got), std::span(right).first(got));
        samples -= static_cast<std::int64_t>(got);
    }
    file.finish();
}

class SequenceSink : public FilmSink {
  public:
    SequenceSink(const FilmSource& source, const FilmPlan& plan, std::string pattern, int threads,
                 const SoundMaker& sound)
        : source_(source),
          pattern_(std::move(pattern)),
          sound_(sound_of_film(sound, source.shot().output, sounded_film(source.shot()))),
          view_(source.shot().output),
          graphics_(source.shot(), source.timeline(), threads) {
        graphics_.prepare();
        // Created and removed immediately, only to check whether the folder is writable.
        const PendingFile probe(path_in_sequence(pattern_, plan.frames.front()));
    }

    void add(std::int64_t frame, const render::Film& picture, bool /*same_as_before*/) override {
        const render::Film exported = exported_frame(picture, source_, frame);
        const std::vector<PlannedFrame> layers = source_.layers(frame);
        write_picture(
            exported, view_, viewed_frame(layers), path_in_sequence(pattern_, frame),
            exported_frame_metadata(source_.shot(), source_.timeline(), frame, exported),
            [&](std::span<std::uint8_t> rgb, int width, int height) {
                graphics_.draw(layers, rgb, width, height);
            },
            exr_standard_attributes(source_.shot(), layers.front()));
    }

    void finish() override {
        if (sound_ != nullptr) {
            const SoundedFilm film = sounded_film(source_.shot());
            write_wav(*sound_, first_sample(film.frames, film.fps),
                      sound_path_of_sequence(pattern_));
        }
    }

  private:
    const FilmSource& source_;
    std::string pattern_;
    std::unique_ptr<SoundSource> sound_;  // null: none
    DisplayView view_;
    FrameGraphics graphics_;
};

}  // namespace

std::unique_ptr<FilmSink> make_film_sink(const FilmSource& source, const FilmPlan& plan,
                                         const std::string& path, int threads,
                                         const SoundMaker& sound) {
    if (is_image_sequence(path)) {
        return std::make_unique<SequenceSink>(source, plan, path, threads, sound);
    }
    return std::make_unique<VideoSink>(source, plan, path, threads, sound);
}

std::unique_ptr<FilmSink> sink_of(const FilmJobOptions& options, const FilmSource& source,
                                  const FilmPlan& plan, ThreadSafeObserver& observer,
                                  const std::stop_token& stop) {
    if (options.sink) {
        return options.sink(source, plan);
    }
    if (options.output.empty()) {
        return nullptr;
    }
    const SoundMaker sound =
        with_warnings(job_sound(options, source.shot(), source.timeline(), stop),
                      [&observer](const std::string& note) { observer.warning(note); });
    const std::string note = silence_note(sound, source.shot().output, options.output, plan.frames);
    if (!note.empty()) {
        observer.warning(note);
    }
    return make_film_sink(source, plan, options.output, options.threads, sound);
}

}  // namespace carom::pipeline
