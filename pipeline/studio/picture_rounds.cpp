#include "pipeline/studio/picture_rounds.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "core/error.h"
#include "pipeline/job/denoised_picture.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/job/mixed_film.h"
#include "pipeline/job/viewed_frame.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/channel_picture.h"
#include "pipeline/studio/display_picture.h"
#include "pipeline/studio/picture_question.h"
#include "render/film/image_file.h"

namespace carom::studio {
namespace {

/// The samples of a pixel of a stored frame, on average. With adaptive sampling they are more than
/// `least`, which each pixel has.
int mean_samples(const render::Film& stored, int least) {
    const auto rays = stored.notes.find(std::string(render::kRaysPrefix) + "camera");
    if (rays == stored.notes.end()) {
        return least;
    }
    const double pixels = static_cast<double>(stored.width) * stored.height;
    return std::max(least, static_cast<int>(
                               std::min(1e9, std::strtod(rays->second.c_str(), nullptr) / pixels)));
}

}  // namespace

struct PictureRounds::Work {
    PictureQuestion question;
    WorkContext context;  // with the stop token
    pipeline::DisplayView view;
};

void PictureRounds::open_store() {
    if (!store_) {
        store_.emplace((cache_folder_.empty() ? pipeline::default_cache_folder() : cache_folder_) +
                       "/frames");
    }
}

void PictureRounds::use(const ShownShot& shown) {
    if (!source_ || shown_.shot != shown.shot || shown_.timeline != shown.timeline) {
        graphics_.reset();
        source_.reset();
        shown_ = shown;
        source_.emplace(*shown_.shot, *shown_.timeline);
        graphics_ =
            std::make_unique<pipeline::FrameGraphics>(*shown_.shot, *shown_.timeline, std::nullopt);
    }
    shown_.v = shown.v;
}

void PictureRounds::run(const ShownShot& shown, const See& question, int most_samples,
                        const std::stop_token& stop, const Show& show) {
    open_store();
    use(shown);
    Work work{read_question(question, *source_, most_samples),
              {.stop = stop},
              pipeline::DisplayView(shown_.shot->output)};
    keep_samples_of(work.question);
    const std::size_t last = work.question.last();
    if (work.question.is_films && read_stored(work)) {
        show(picture_of(work, last));
        return;
    }
    if (samples_of(work.question, last) == 0) {
        for (std::size_t level = 0; level < last; ++level) {
            refine(work, level, 1);
            show(picture_of(work, level));
        }
    }
    refine_to_end(work, show);
}

void PictureRounds::keep_samples_of(const PictureQuestion& question) {
    std::map<Hash128, Kept> kept;
    for (const std::vector<Hash128>& keys : question.keys) {
        for (const Hash128& key : keys) {
            if (auto found = kept_.extract(key)) {
                kept.insert(std::move(found));
            }
        }
    }
    kept_ = std::move(kept);
    for (auto& [key, one] : kept_) {
        // With a channel, because it has colours only; otherwise, if it is denoised differently.
        if (question.channel ||
            std::ranges::find(question.film_keys, one.film_key) == question.film_keys.end()) {
            one.stored.reset();
        }
    }
}

int PictureRounds::samples_of(const PictureQuestion& question, std::size_t level) const {
    int samples = std::numeric_limits<int>::max();
    for (const Hash128& key : question.keys[level]) {
        const auto found = kept_.find(key);
        if (found != kept_.end() && found->second.stored) {
            continue;  // it has all
        }
        const bool has = found != kept_.end() && found->second.frame;
        samples = std::min(samples, has ? found->second.frame->samples() : 0);
    }
    return samples;
}

void PictureRounds::refine_to_end(Work& work, const Show& show) {
    const std::size_t last = work.question.last();
    int up_to = std::max(1, samples_of(work.question, last));
    for (;;) {
        refine(work, last, std::min(up_to, work.question.most));
        if (work.question.is_films ||
            (!work.question.channel && pipeline::denoises(work.question.shot))) {
            finish(work);
        }
        Picture picture = picture_of(work, last);
        const bool complete = picture.head.complete;
        show(std::move(picture));
        if (complete) {
            return;
        }
        up_to *= 2;
    }
}

void PictureRounds::refine(Work& work, std::size_t level, int up_to) {
    const PictureQuestion& question = work.question;
    for (std::size_t i = 0; i < question.layers.size(); ++i) {
        const PictureLayer& layer = question.layers[i];
        Kept& kept = kept_[question.keys[level][i]];
        if (kept.stored) {
            continue;
        }
        if (!kept.frame) {
            kept.scene = scene_.of(question.shot, source_->scene_hash());
            kept.frame.emplace(*kept.scene, layer.inputs.tracks, layer.inputs.frame,
                               question.settings(level));
        }
        const std::uint64_t before = kept.frame->statistics().camera_rays;
        try {
            kept.frame->refine(up_to, work.context);
        } catch (const Stopped&) {
            counts_.camera_rays += kept.frame->statistics().camera_rays - before;
            throw;
        }
        counts_.camera_rays += kept.frame->statistics().camera_rays - before;
    }
}

/// Adds the samples of a layer to the head of the picture.
void PictureRounds::count_samples(const Work& work, const Kept& kept, PictureHead& head) {
    int samples = 0;
    int most = 0;
    if (kept.stored) {
        samples = most = mean_samples(*kept.stored, work.question.shot.render.samples);
    } else {
        samples = kept.frame->samples();
        most = std::max(samples, std::min(kept.frame->most_samples(), work.question.most));
        head.complete = head.complete && (kept.frame->finished() || samples >= work.question.most);
        head.stored = false;
    }
    head.samples = std::min(head.samples, samples);
    head.of_samples = std::max(head.of_samples, most);
}

Picture PictureRounds::picture_of(Work& work, std::size_t level) {
    const PictureQuestion& question = work.question;
    Picture picture;
    PictureHead& head = picture.head;
    head.complete = level == question.last();
    head.stored = question.is_films && head.complete;
    head.samples = std::numeric_limits<int>::max();
    std::optional<render::Film> film;
    for (std::size_t i = 0; i < question.layers.size(); ++i) {
        const Kept& kept = kept_.at(question.keys[level][i]);
        count_samples(work, kept, head);
        render::Film part = kept.stored ? *kept.stored : kept.frame->picture(work.context);
        if (film) {
            pipeline::mix_in(part, question.layers[i].weight, *film);
        } else {
            film = std::move(part);
        }
    }
    head.q = question.see.q;
    head.v = shown_.v;
    head.width = film->width;
    head.height = film->height;
    head.channel = question.see.channel;
    paint(work, level, *film, picture);
    return picture;
}

void PictureRounds::paint(Work& work, std::size_t level, const render::Film& film,
                          Picture& picture) {
    const PictureQuestion& question = work.question;
    if (question.channel) {
        const render::ProgressiveFrame& frame = *kept_.at(question.keys[level].front()).frame;
        ChannelPicture shown = channel_picture(
            question.see.channel, frame.channels(question.channel->aov, work.context), film);
        picture.rgba = std::move(shown.rgba);
        picture.head.legend = std::move(shown.legend);
        return;
    }
    const auto draw_over = [&](std::span<std::uint8_t> rgb, int width, int height) {
        if (question.see.frame) {
            graphics_->draw(question.planned, rgb, width, height);
        } else {
            graphics_->draw_in_scene(question.planned.front(), rgb, width, height);
        }
    };
    picture.rgba =
        display_rgba(film, question.shot.output, work.view,
                     pipeline::viewed_frame(question.planned), draw_over, work.context.stop);
}

bool PictureRounds::read_stored(Work& work) {
    bool all = true;
    for (std::size_t i = 0; i < work.question.layers.size(); ++i) {
        Kept& kept = kept_[work.question.keys.back()[i]];
        if (!kept.stored) {
            if (std::optional<render::Film> film = find_stored(work, i)) {
                keep_finished(work, i, std::move(*film));
            }
        }
        all = all && kept.stored.has_value();
    }
    return all;
}

std::optional<render::Film> PictureRounds::find_stored(const Work& work, std::size_t layer) {
    const Hash128& film_key = work.question.film_keys[layer];
    std::optional<render::Film> film = store_->read(film_key);
    if (film) {
        store_->mark_used(film_key);
    } else if (pipeline::denoises(work.question.shot)) {
        film = store_->read_noisy(work.question.keys.back()[layer]);
        if (film) {
            film = denoised(work, layer, *film);
        }
    }
    return film;
}

void PictureRounds::keep_finished(const Work& work, std::size_t layer, render::Film film) {
    Kept& kept = kept_.at(work.question.keys.back()[layer]);
    kept.stored = std::move(film);
    kept.film_key = work.question.film_keys[layer];
    kept.frame.reset();
}

/// The picture that the film shows, which is stored if it is a frame of the film.
render::Film PictureRounds::denoised(const Work& work, std::size_t layer,
                                     const render::Film& noisy) {
    const pipeline::Shot& shot = work.question.shot;
    render::Film film = pipeline::denoised_picture(noisy, shot, {{}, work.context.stop});
    if (work.question.is_films) {
        write(work.question.film_keys[layer], film, pipeline::stored_frame_metadata(shot, {}));
    }
    return film;
}

// A frame is claimed only while it is written: a film that is rendered at the same time does not
// wait for somebody who looks at a picture.
void PictureRounds::finish(Work& work) {
    const pipeline::Shot& shot = work.question.shot;
    const bool denoises = pipeline::denoises(shot);
    for (std::size_t i = 0; i < work.question.layers.size(); ++i) {
        const Hash128& key = work.question.keys.back()[i];
        Kept& kept = kept_.at(key);
        if (kept.stored || !kept.frame->finished()) {
            continue;
        }
        render::Film film = kept.frame->film(work.context);
        const render::ImageMetadata metadata =
            pipeline::stored_frame_metadata(shot, film.statistics);
        if (work.question.is_films && !denoises) {
            write(key, film, metadata);
        }
        film = render::as_stored(std::move(film), metadata);
        if (denoises) {
            if (work.question.is_films) {
                write_noisy(key, film);
            }
            film = denoised(work, i, film);
        }
        keep_finished(work, i, std::move(film));
    }
}

void PictureRounds::write_noisy(const Hash128& key, const render::Film& film) {
    if (store_->noisy_size_bytes(key) > 0) {
        return;
    }
    if (auto claim = store_->claim(key)) {
        store_->write_noisy(key, film);
        claim->finish();
    }
}

void PictureRounds::write(const Hash128& key, const render::Film& film,
                          const render::ImageMetadata& metadata) {
    if (store_->contains(key)) {
        return;
    }
    if (auto claim = store_->claim(key)) {
        store_->write(key, film, metadata);
        claim->finish();
        counts_.frames_stored += 1;
    }
}

}  // namespace carom::studio
