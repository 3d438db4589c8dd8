#include "pipeline/sequence/sequence_job.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/error.h"
#include "pipeline/job/film_sink.h"
#include "pipeline/job/film_sound.h"
#include "pipeline/job/frame_signal.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/job/shot_sound.h"
#include "pipeline/sequence/sequence_scene.h"
#include "pipeline/sequence/sequence_writer.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/video_writer.h"

namespace carom::pipeline {

namespace {

/// Passes the frames of one part to the mixer.
class PartSink : public FilmSink {
  public:
    PartSink(const FilmSource& source, std::size_t part, std::int64_t first, SequenceMixer& mixer,
             int threads)
        : signal_(source, threads), part_(part), first_(first), mixer_(mixer) {}

    void add(std::int64_t frame, const render::Film& picture, bool same_as_before) override {
        mixer_.add(part_, frame - first_, signal_.of(frame, picture, same_as_before));
    }
    void finish() override {}

  private:
    FrameSignal signal_;
    std::size_t part_;
    std::int64_t first_;
    SequenceMixer& mixer_;
};

/// The frames that the options select.
std::vector<std::int64_t> selected(const Sequence& sequence, const FilmJobOptions& options) {
    std::vector<std::int64_t> frames = options.frames.frames(sequence.frames());
    return options.chunk.part_of(frames);
}

FrameRange range_of(const std::vector<std::int64_t>& frames) {
    FrameRange range;
    for (const std::int64_t frame : frames) {
        if (!range.parts.empty() && range.parts.back().last + 1 == frame) {
            range.parts.back().last = frame;
        } else {
            range.parts.push_back({frame, frame, 1});
        }
    }
    return range;
}

/// An observer of one part, whose progress is a part of the whole.
class PartObserver {
  public:
    PartObserver(const Sequence& sequence, const JobObserver& whole, std::int64_t count)
        : sequence_(sequence), whole_(whole), starts_(sequence.starts()), count_(count) {}

    [[nodiscard]] JobObserver of(std::size_t part, std::int64_t own_count) {
        JobObserver observer;
        observer.on_warning = whole_.on_warning;
        if (whole_.on_progress) {
            observer.on_progress = [this, own_count](std::string_view stage, double fraction) {
                if (stage == "render") {
                    whole_.on_progress(stage, (static_cast<double>(done_) +
                                               fraction * static_cast<double>(own_count)) /
                                                  static_cast<double>(count_));
                }
            };
        }
        if (whole_.on_frame) {
            observer.on_frame = [this, part](std::int64_t frame, bool from_store, double seconds,
                                             std::uint64_t rays) {
                const auto& shot = std::get<ShotPart>(sequence_.parts[part].content);
                whole_.on_frame(starts_[part] + frame - shot.first, from_store, seconds, rays);
            };
        }
        return observer;
    }

    void finish(std::int64_t own_count) { done_ += own_count; }

  private:
    const Sequence& sequence_;
    const JobObserver& whole_;
    std::vector<std::int64_t> starts_;
    std::int64_t count_;
    std::int64_t done_ = 0;
};

/// A part of which nothing is rendered yet.
void add_black(SequenceMixer& mixer, std::size_t part, const std::vector<std::int64_t>& frames,
               const ShotPart& shot) {
    const std::vector<std::uint16_t> black(
        3 * static_cast<std::size_t>(shot.shot.render.width * shot.shot.render.height), 0);
    for (const std::int64_t frame : frames) {
        mixer.add(part, frame - shot.first, black);
    }
}

/// Renders all parts in order; `mixer` may be null.
FilmJobResult make_parts(const Sequence& sequence, const SequenceBakes& bakes,
                         const std::vector<std::int64_t>& frames, const FilmJobOptions& options,
                         const JobObserver& observer, SequenceMixer* mixer,
                         const std::stop_token& stop) {
    FilmJobResult result;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        count += std::ssize(own_frames(sequence, i, frames));
    }
    std::int64_t black = 0;
    PartObserver observers(sequence, observer, std::max<std::int64_t>(count, 1));
    const std::vector<std::int64_t> starts = sequence.starts();
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        const SequencePart& part = sequence.parts[i];
        if (const auto* card = std::get_if<TitleCard>(&part.content)) {
            std::vector<std::uint16_t> rgb;
            for (const std::int64_t frame : frames) {
                const std::int64_t own = frame - starts[i];
                if (mixer != nullptr && own >= 0 && own < part.frames) {
                    if (rgb.empty()) {
                        rgb = drawn_card(*card, sequence.width, sequence.height);
                    }
                    mixer->add(i, own, rgb);
                }
            }
            continue;
        }
        const std::vector<std::int64_t> own = own_frames(sequence, i, frames);
        if (own.empty()) {
            continue;
        }
        const auto& shot = std::get<ShotPart>(part.content);
        if (mixer != nullptr && options.so_far &&
            part_status(sequence, i, bakes, options, stop).stored.empty()) {
            add_black(*mixer, i, own, shot);
            black += std::ssize(own);
            continue;
        }
        FilmJobOptions of_part = part_options(options, own);
        if (mixer != nullptr) {
            of_part.sink = [&, i](const FilmSource& source, const FilmPlan&) {
                return std::make_unique<PartSink>(source, i, shot.first, *mixer, options.threads);
            };
        }
        const FilmJobResult one =
            make_film(shot.shot, bakes.at(i), of_part, observers.of(i, std::ssize(own)), stop);
        observers.finish(std::ssize(own));
        result.pictures += one.pictures;
        result.rendered += one.rendered;
        result.counts += one.counts;
    }
    if (black > 0 && black == count) {
        throw Error("none of the film's frames is rendered yet");
    }
    result.frames = std::ssize(frames);
    return result;
}

std::vector<std::uint8_t> to_8(std::span<const std::uint16_t> rgb) {
    std::vector<std::uint8_t> small(rgb.size());
    std::ranges::transform(rgb, small.begin(), [](std::uint16_t value) {
        return static_cast<std::uint8_t>((value + 128U) / 257U);
    });
    return small;
}

/// The first shot, for the metadata of the film.
const Shot& first_shot(const Sequence& sequence, Shot& empty) {
    for (const SequencePart& part : sequence.parts) {
        if (const auto* shot = std::get_if<ShotPart>(&part.content)) {
            return shot->shot;
        }
    }
    return empty;
}

std::map<std::string, std::string> metadata_of(const Sequence& sequence) {
    Shot empty;
    std::map<std::string, std::string> metadata = video_metadata(first_shot(sequence, empty));
    metadata["title"] = sequence.output.title.empty() ? sequence.name : sequence.output.title;
    return metadata;
}

/// The frame that the poster shows, if the film has one.
std::optional<std::int64_t> poster_frame(const Sequence& sequence,
                                         const std::vector<std::int64_t>& frames) {
    if (!sequence.output.poster || frames.empty()) {
        return std::nullopt;
    }
    const auto wanted =
        static_cast<std::int64_t>(*sequence.output.poster * sequence.fps.to_double());
    const auto found = std::ranges::lower_bound(frames, wanted);
    return found == frames.end() ? frames.back() : *found;
}

/// The status of all parts together, in the film's numbers. Title cards need not be rendered.
FilmStatus sequence_status(const Sequence& sequence, const SequenceBakes& bakes,
                           const FilmJobOptions& options, const std::stop_token& stop) {
    const std::vector<std::int64_t> starts = sequence.starts();
    std::set<std::int64_t> missing;
    std::set<std::int64_t> damaged;
    FilmStatus whole;
    whole.frames = selected(sequence, options);
    for (const auto& [part, bake] : bakes) {
        const FilmStatus status = part_status(sequence, part, bakes, options, stop);
        const std::int64_t shift =
            starts[part] - std::get<ShotPart>(sequence.parts[part].content).first;
        for (const std::int64_t frame : status.missing) {
            missing.insert(frame + shift);
        }
        for (const std::int64_t frame : status.damaged) {
            damaged.insert(frame + shift);
        }
        whole.pictures += status.pictures;
    }
    std::ranges::set_difference(whole.frames, missing, std::back_inserter(whole.stored));
    whole.missing.assign(missing.begin(), missing.end());
    whole.damaged.assign(damaged.begin(), damaged.end());
    return whole;
}

}  // namespace

FilmJobOptions part_options(FilmJobOptions options, const std::vector<std::int64_t>& own) {
    options.output.clear();
    options.chunk = {};
    options.sink = nullptr;
    options.sound = nullptr;  // that of the whole film is written with its pictures
    options.frames = range_of(own);
    return options;
}

std::vector<std::int64_t> own_frames(const Sequence& sequence, std::size_t part,
                                     const std::vector<std::int64_t>& frames) {
    std::vector<std::int64_t> own;
    const auto* shot = std::get_if<ShotPart>(&sequence.parts[part].content);
    if (shot == nullptr) {
        return own;
    }
    const std::int64_t start = sequence.starts()[part];
    for (const std::int64_t frame : frames) {
        const std::int64_t inside = frame - start;
        if (inside >= 0 && inside < sequence.parts[part].frames) {
            own.push_back(shot->first + inside);
        }
    }
    return own;
}

SoundMaker sequence_sound(const Sequence& sequence, const SequenceBakes& bakes,
                          std::stop_token stop) {
    const auto is_silent = [&](const auto& part) {
        return std::get<ShotPart>(sequence.parts[part.first].content).shot.sound.is_silent;
    };
    if (std::ranges::all_of(bakes, is_silent)) {
        return {};
    }
    return computed_sound(
        [&sequence, &bakes] {
            std::map<std::size_t, const sim::Timeline*> timelines;
            for (const auto& [part, bake] : bakes) {
                timelines[part] = &bake.timeline;
            }
            return sequence_scene(sequence, timelines, 0, sequence.frames());
        },
        std::move(stop));
}

FilmJobResult make_sequence(const Sequence& sequence, const SequenceBakes& bakes,
                            const FilmJobOptions& options, const JobObserver& observer,
                            const std::stop_token& stop) {
    const std::vector<std::int64_t> frames = selected(sequence, options);
    if (options.output.empty()) {
        return make_parts(sequence, bakes, frames, options, observer, nullptr, stop);
    }
    const VideoFormat format{sequence.width, sequence.height, sequence.fps};
    const SoundMaker sound = with_warnings(
        options.sound ? options.sound : sequence_sound(sequence, bakes, stop), observer.on_warning);
    VideoWriter writer(
        options.output, format, sequence.output, metadata_of(sequence),
        sound_of_frames(sound, sequence.output, {sequence.frames(), sequence.fps}, frames));
    const std::string note = silence_note(sound, sequence.output, options.output, frames);
    if (!note.empty() && observer.on_warning) {
        observer.on_warning(note);
    }
    const std::optional<std::int64_t> poster = poster_frame(sequence, frames);
    SequenceMixer mixer(sequence, [&](std::int64_t frame, std::span<const std::uint16_t> rgb) {
        writer.write(rgb);
        if (frame == poster && writer.has_poster()) {
            writer.set_poster(to_8(rgb));
        } else if (frame == poster) {
            const std::filesystem::path path(options.output);
            write_display_picture(
                to_8(rgb), sequence.width, sequence.height,
                (path.parent_path() / (path.stem().string() + "-poster.jpg")).string());
        }
    });
    const FilmJobResult result =
        make_parts(sequence, bakes, frames, options, observer, &mixer, stop);
    writer.finish();
    return result;
}

FilmStatus part_status(const Sequence& sequence, std::size_t part, const SequenceBakes& bakes,
                       const FilmJobOptions& options, const std::stop_token& stop) {
    const std::vector<std::int64_t> own = own_frames(sequence, part, selected(sequence, options));
    return own.empty() ? FilmStatus{}
                       : film_status(std::get<ShotPart>(sequence.parts[part].content).shot,
                                     bakes.at(part), part_options(options, own), stop);
}

FilmJobResult mux_sequence(const Sequence& sequence, const SequenceBakes& bakes,
                           const FilmJobOptions& options, const JobObserver& observer,
                           const std::stop_token& stop) {
    if (!options.so_far) {
        check_that_all_are_stored(sequence_status(sequence, bakes, options, stop));
    }
    FilmJobOptions without_renderer = options;
    without_renderer.renderer = refuse_to_render;
    return make_sequence(sequence, bakes, without_renderer, observer, stop);
}

void for_each_frame(const Sequence& sequence, const SequenceBakes& bakes,
                    const std::vector<std::int64_t>& frames, const FilmJobOptions& options,
                    const JobObserver& observer,
                    const std::function<void(std::int64_t frame, const DisplayPicture&)>& take,
                    const std::stop_token& stop) {
    SequenceMixer mixer(sequence, [&](std::int64_t frame, std::span<const std::uint16_t> rgb) {
        take(frame, {sequence.width, sequence.height, to_8(rgb)});
    });
    (void)make_parts(sequence, bakes, frames, options, observer, &mixer, stop);
}

}  // namespace carom::pipeline
