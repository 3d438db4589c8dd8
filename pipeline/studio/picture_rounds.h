// The rounds in which the path-traced picture of a question is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/hash.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/store/frame_store.h"
#include "pipeline/studio/kept_scene.h"
#include "pipeline/studio/messages.h"
#include "render/frame/progressive_frame.h"

namespace carom::studio {

/// A picture for the page; `rgba` is its payload. If `problem` is not empty, there is none.
struct Picture {
    PictureHead head;
    std::vector<std::uint8_t> rgba;
    std::string problem;
};

/// What is shown: a shot and its timeline, with keyed motions.
struct ShownShot {
    std::shared_ptr<const pipeline::Shot> shot;
    std::shared_ptr<const sim::Timeline> timeline;
    std::int64_t v = 0;
};

struct PictureQuestion;

/// What has been done, for tests and benchmarks.
struct PictureCounts {
    std::uint64_t camera_rays = 0;
    std::uint64_t scenes = 0;  // that were prepared
    std::uint64_t frames_stored = 0;
};

/// Makes pictures for one thread. It keeps the prepared scene while only balls and cameras move,
/// and the sums of the last question's samples: they are used again if only the view changed.
class PictureRounds {
  public:
    /// The usual cache if the folder is empty.
    explicit PictureRounds(std::string cache_folder) : cache_folder_(std::move(cache_folder)) {}

    using Show = std::function<void(Picture)>;

    /// Calls `show` with pictures of growing size and then with growing numbers of samples, at most
    /// `most_samples` (0: no limit). A frame of the film at its own size with all samples goes into
    /// the cache; one that is there is shown at once. Throws Error, Stopped; another call goes on
    /// with the samples that there are.
    void run(const ShownShot& shown, const See& question, int most_samples,
             const std::stop_token& stop, const Show& show);

    [[nodiscard]] PictureCounts counts() const {
        PictureCounts counts = counts_;
        counts.scenes = scene_.count();
        return counts;
    }

  private:
    struct Kept {
        std::shared_ptr<const render::PreparedScene> scene;  // outlives the frame
        std::optional<render::ProgressiveFrame> frame;
        std::optional<render::Film> stored;  // as the film shows it: denoised if it is
        Hash128 film_key{};                  // of `stored`, in the film
    };
    struct Work;

    void open_store();
    void use(const ShownShot& shown);

    /// Forgets the samples of all other questions.
    void keep_samples_of(const PictureQuestion& question);
    /// That all layers of the level have.
    [[nodiscard]] int samples_of(const PictureQuestion& question, std::size_t level) const;

    void refine(Work& work, std::size_t level, int up_to);
    /// At the last level, until the picture is complete.
    void refine_to_end(Work& work, const Show& show);

    [[nodiscard]] Picture picture_of(Work& work, std::size_t level);
    static void count_samples(const Work& work, const Kept& kept, PictureHead& head);
    void paint(Work& work, std::size_t level, const render::Film& film, Picture& picture);

    /// Reads the layers of the last level from the cache. Returns whether it has all.
    [[nodiscard]] bool read_stored(Work& work);
    /// The picture of a layer from the cache, where that may have to be denoised.
    [[nodiscard]] std::optional<render::Film> find_stored(const Work& work, std::size_t layer);
    /// Denoises layers that have all samples, and stores those that are the film's.
    void finish(Work& work);
    void keep_finished(const Work& work, std::size_t layer, render::Film film);
    [[nodiscard]] render::Film denoised(const Work& work, std::size_t layer,
                                        const render::Film& noisy);
    void write_noisy(const Hash128& key, const render::Film& film);
    void write(const Hash128& key, const render::Film& film, const render::ImageMetadata& metadata);

    std::string cache_folder_;
    std::optional<pipeline::FrameStore> store_;  // opened by the first question
    ShownShot shown_;
    std::optional<pipeline::FilmSource> source_;         // of shown_
    std::unique_ptr<pipeline::FrameGraphics> graphics_;  // of shown_
    KeptScene scene_;
    std::map<Hash128, Kept> kept_;  // of the last question
    PictureCounts counts_;
};

}  // namespace carom::studio
