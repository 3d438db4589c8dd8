#include "pipeline/job/film_sink.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/job/exported_frame.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/job/frame_signal.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/light_meter.h"
#include "pipeline/video/pending_file.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/video_writer.h"
#include "pipeline/video/view_transform.h"

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

class VideoSink : public FilmSink {
  public:
    VideoSink(const FilmSource& source, const FilmPlan& plan, const std::string& path, int threads)
        : source_(source),
          shot_(source.shot()),
          path_(path),
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
        writer_ = std::make_unique<VideoWriter>(path_, format, shot_.output,
                                                video_metadata(shot_, source_.tier()));
    }

    const FilmSource& source_;
    const Shot& shot_;
    std::string path_;
    FrameSignal signal_;
    std::optional<std::int64_t> poster_;
    std::optional<std::vector<std::uint8_t>> poster_picture_;  // for a file beside the video
    LightMeter meter_;
    bool light_is_stated_ = true;  // the writer knows the light levels, or does not need them
    std::unique_ptr<VideoWriter> writer_;
};

class SequenceSink : public FilmSink {
  public:
    SequenceSink(const FilmSource& source, const FilmPlan& plan, std::string pattern, int threads)
        : source_(source),
          pattern_(std::move(pattern)),
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
            exported, view_, path_in_sequence(pattern_, frame),
            exported_frame_metadata(source_.shot(), source_.timeline(), frame, exported,
                                    source_.tier()),
            [&](std::span<std::uint8_t> rgb, int width, int height) {
                graphics_.draw(layers, rgb, width, height);
            },
            exr_standard_attributes(source_.shot(), layers.front()));
    }

    void finish() override {}

  private:
    const FilmSource& source_;
    std::string pattern_;
    DisplayView view_;
    FrameGraphics graphics_;
};

}  // namespace

std::unique_ptr<FilmSink> make_film_sink(const FilmSource& source, const FilmPlan& plan,
                                         const std::string& path, int threads) {
    if (is_image_sequence(path)) {
        return std::make_unique<SequenceSink>(source, plan, path, threads);
    }
    return std::make_unique<VideoSink>(source, plan, path, threads);
}

std::unique_ptr<FilmSink> sink_of(const FilmJobOptions& options, const FilmSource& source,
                                  const FilmPlan& plan) {
    if (options.sink) {
        return options.sink(source, plan);
    }
    return options.output.empty() ? nullptr
                                  : make_film_sink(source, plan, options.output, options.threads);
}

}  // namespace carom::pipeline
