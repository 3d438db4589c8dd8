#include "pipeline/studio/picture_rounds.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/field_hasher.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/job/mixed_film.h"
#include "pipeline/job/overlay.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/channel_picture.h"
#include "pipeline/studio/display_picture.h"
#include "render/film/image_file.h"

namespace carom::studio {
namespace {

constexpr int kFirstPixels = 36000;  // of the first, small picture: at most about 250 x 140
// Of a picture with all its layers: the sums take 150 bytes a pixel. A cross-fade at 1920 x 1080
// fits.
constexpr int kMostPixels = 2 * 1920 * 1080;
constexpr int kMostSide = 16384;  // pixels

Vec3 vector_of(const Triple& t) {
    return {t[0], t[1], t[2]};
}

/// The exposure is that of the film at speed 1, around the time.
pipeline::PlannedFrame planned(const FreeView& view, const pipeline::Shutter& shutter) {
    const double half = 0.5 * shutter.exposure.to_double();
    pipeline::PlannedFrame frame;
    frame.scene_time = view.scene_time;
    frame.scene_open = view.scene_time - half;
    frame.scene_close = view.scene_time + half;
    frame.camera_open.position = vector_of(view.position);
    frame.camera_open.target = vector_of(view.target);
    frame.camera_open.up = vector_of(view.up);
    frame.camera_open.vertical_fov = view.fov;
    frame.camera_open.focus_distance = view.focus;
    frame.camera_open.lens_radius = view.lens_radius;
    frame.camera_close = frame.camera_open;
    return frame;
}

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
    const pipeline::Shot& shot;
    const See& question;
    std::stop_token stop;
    pipeline::DisplayView view;
    std::vector<Layer> layers;
    render::PictureText text;
    std::vector<Size> levels;                // growing
    std::vector<std::vector<Hash128>> keys;  // by level, then by layer
    int most = 0;                            // samples
    bool is_films = false;                   // the film's frame at its own size, in colours
    std::optional<ViewChannel> channel;      // shown instead of colours

    [[nodiscard]] render::RenderSettings settings(std::size_t level) const {
        render::RenderSettings result = shot.render;
        result.width = levels[level].width;
        result.height = levels[level].height;
        return result;
    }
};

void PictureRounds::use(const ShownShot& shown) {
    if (!source_ || shown_.shot != shown.shot || shown_.timeline != shown.timeline) {
        source_.reset();
        shown_ = shown;
        source_.emplace(*shown_.shot, *shown_.timeline);
    }
    shown_.v = shown.v;
}

// Names are those of tracks, and of objects and materials for mattes.
std::shared_ptr<const render::PreparedScene> PictureRounds::scene_of(const pipeline::Shot& shot) {
    FieldHasher hasher;
    hasher.add(source_->scene_hash().to_string());
    hasher.add(static_cast<std::int32_t>(shot.render.acceleration));
    for (const render::ObjectDescription& object : shot.scene.objects) {
        hasher.add(object.name).add(object.material).add(object.track);
    }
    for (const render::MaterialDescription& material : shot.scene.materials) {
        hasher.add(material.name);
    }
    for (const render::LightDescription& light : shot.scene.lights) {
        hasher.add(light.name);
    }
    const Hash128 key = hasher.finish();
    if (!scene_ || !(key == scene_key_)) {
        scene_ = std::make_shared<const render::PreparedScene>(shot.scene, shot.render);
        scene_key_ = key;
        counts_.scenes += 1;
    }
    return scene_;
}

void PictureRounds::run(const ShownShot& shown, const See& question, int most_samples,
                        const std::stop_token& stop, const std::function<void(Picture)>& show) {
    if (!store_) {
        store_.emplace((cache_folder_.empty() ? pipeline::default_cache_folder() : cache_folder_) +
                       "/frames");
    }
    use(shown);
    const pipeline::Shot& shot = *shown_.shot;
    Work work{shot, question, stop, pipeline::DisplayView(shot.output), {}, {}, {}, {},
              0,    false,    {}};
    if (!question.channel.empty() && question.channel != "colour") {
        work.channel = view_channel(question.channel);
    }
    if (question.frame) {
        const std::int64_t count = pipeline::frame_count(shot.cameras, shot.timing);
        if (*question.frame < 0 || *question.frame >= count) {
            throw Error("the film has no frame " + std::to_string(*question.frame));
        }
        const std::vector<pipeline::PlannedFrame> layers = source_->layers(*question.frame);
        for (const pipeline::PlannedFrame& layer : layers) {
            work.layers.push_back({source_->inputs(layer), layer.weight});
        }
        work.text = pipeline::overlay_text(shot.output.overlay, layers.front());
    } else if (question.view) {
        work.layers.push_back({source_->inputs(planned(*question.view, shot.timing.shutter)), 1});
    } else {
        throw Error("a question for a picture needs a frame or a view");
    }
    Size size{question.width > 0 ? question.width : shot.render.width,
              question.height > 0 ? question.height : shot.render.height};
    size = {std::min(size.width, kMostSide), std::min(size.height, kMostSide)};
    const double area =
        static_cast<double>(size.width) * size.height * static_cast<double>(work.layers.size());
    const double shrink = std::min(1.0, std::sqrt(kMostPixels / area));
    size = {std::max(1, static_cast<int>(size.width * shrink)),
            std::max(1, static_cast<int>(size.height * shrink))};
    work.is_films = question.frame && !work.channel && size.width == shot.render.width &&
                    size.height == shot.render.height;
    work.levels.push_back(size);
    while (size.width > 1 && size.height > 1 && size.width * size.height > kFirstPixels) {
        size = {size.width / 2, size.height / 2};
        work.levels.insert(work.levels.begin(), size);
    }
    std::map<Hash128, Kept> kept;
    for (std::size_t level = 0; level < work.levels.size(); ++level) {
        work.keys.emplace_back();
        for (const Layer& layer : work.layers) {
            const Hash128 key = source_->key(layer.inputs, work.settings(level));
            work.keys.back().push_back(key);
            if (auto found = kept_.extract(key)) {
                kept.insert(std::move(found));
            }
        }
    }
    kept_ = std::move(kept);
    work.most = most_samples > 0 ? most_samples : std::numeric_limits<int>::max();
    if (question.samples > 0) {
        work.most = std::min(work.most, question.samples);
    }
    if (work.channel) {
        work.layers.resize(1);
        if (work.channel->samples > 0) {
            work.most = std::min(work.most, work.channel->samples);
        }
        for (auto& [key, one] : kept_) {
            one.stored.reset();  // it has colours only
        }
    }

    const std::size_t last = work.levels.size() - 1;
    if (work.is_films && read_stored(work)) {
        show(picture_of(work, last));
        return;
    }
    const auto samples_of = [&](std::size_t level) {
        int samples = std::numeric_limits<int>::max();
        for (const Hash128& key : work.keys[level]) {
            const auto found = kept_.find(key);
            const bool has = found != kept_.end() && found->second.frame;
            samples = std::min(samples, has ? found->second.frame->samples() : 0);
        }
        return samples;
    };
    if (samples_of(last) == 0) {
        for (std::size_t level = 0; level < last; ++level) {
            refine(work, level, 1);
            show(picture_of(work, level));
        }
    }
    int up_to = std::max(1, samples_of(last));
    for (;;) {
        refine(work, last, std::min(up_to, work.most));
        if (work.is_films) {
            store(work);
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
    for (std::size_t i = 0; i < work.layers.size(); ++i) {
        const Layer& layer = work.layers[i];
        Kept& kept = kept_[work.keys[level][i]];
        if (kept.stored) {
            continue;
        }
        if (!kept.frame) {
            kept.scene = scene_of(work.shot);
            kept.frame.emplace(*kept.scene, layer.inputs.tracks, layer.inputs.frame,
                               work.settings(level));
        }
        const std::uint64_t before = kept.frame->statistics().camera_rays;
        WorkContext context;
        context.stop = work.stop;
        try {
            kept.frame->refine(up_to, context);
        } catch (const Stopped&) {
            counts_.camera_rays += kept.frame->statistics().camera_rays - before;
            throw;
        }
        counts_.camera_rays += kept.frame->statistics().camera_rays - before;
    }
}

Picture PictureRounds::picture_of(Work& work, std::size_t level) {
    WorkContext context;
    context.stop = work.stop;
    Picture picture;
    picture.head.complete = level + 1 == work.levels.size();
    picture.head.stored = work.is_films && picture.head.complete;
    picture.head.samples = std::numeric_limits<int>::max();
    std::optional<render::Film> film;
    for (std::size_t i = 0; i < work.layers.size(); ++i) {
        const Kept& kept = kept_.at(work.keys[level][i]);
        int samples = kept.stored ? mean_samples(*kept.stored, work.shot.render.samples) : 0;
        int most = samples;
        if (!kept.stored) {
            samples = kept.frame->samples();
            most = std::max(samples, std::min(kept.frame->most_samples(), work.most));
            picture.head.complete =
                picture.head.complete && (kept.frame->finished() || samples >= work.most);
            picture.head.stored = false;
        }
        picture.head.samples = std::min(picture.head.samples, samples);
        picture.head.of_samples = std::max(picture.head.of_samples, most);
        render::Film part = kept.stored ? *kept.stored : kept.frame->picture(context);
        if (film) {
            pipeline::mix_in(part, work.layers[i].weight, *film);
        } else {
            film = std::move(part);
        }
    }
    picture.head.q = work.question.q;
    picture.head.v = shown_.v;
    picture.head.width = film->width;
    picture.head.height = film->height;
    picture.head.channel = work.question.channel;
    if (work.channel) {
        const render::ProgressiveFrame& frame = *kept_.at(work.keys[level].front()).frame;
        ChannelPicture shown = channel_picture(work.question.channel,
                                               frame.channels(work.channel->aov, context), *film);
        picture.rgba = std::move(shown.rgba);
        picture.head.legend = std::move(shown.legend);
        return picture;
    }
    picture.rgba = display_rgba(*film, work.shot.output, work.view, work.text, work.stop);
    return picture;
}

bool PictureRounds::read_stored(Work& work) {
    bool all = true;
    for (const Hash128& key : work.keys.back()) {
        const auto found = kept_.find(key);
        if (found != kept_.end() && found->second.stored) {
            continue;
        }
        std::optional<render::Film> film = store_->read(key);
        all = all && film.has_value();
        if (film) {
            store_->mark_used(key);
            kept_[key].stored = std::move(film);
            kept_[key].frame.reset();
        }
    }
    return all;
}

// A frame is claimed only while it is written: a film that is rendered at the same time does not
// wait for somebody who looks at a picture.
void PictureRounds::store(Work& work) {
    for (const Hash128& key : work.keys.back()) {
        Kept& kept = kept_.at(key);
        if (kept.stored || !kept.frame->finished()) {
            continue;
        }
        WorkContext context;
        context.stop = work.stop;
        render::Film film = kept.frame->film(context);
        const render::ImageMetadata metadata =
            pipeline::stored_frame_metadata(work.shot, film.statistics);
        if (!store_->contains(key)) {
            if (const auto claim = store_->claim(key)) {
                store_->write(key, film, metadata);
                counts_.frames_stored += 1;
            }
        }
        kept.stored = render::as_stored(std::move(film), metadata);
        kept.frame.reset();
    }
}

}  // namespace carom::studio
