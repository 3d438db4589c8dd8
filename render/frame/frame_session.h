// One frame whose samples are taken in rounds: for films, for the studio's previews and for the
// blocks from which the cost of a film is forecast. Internal to this folder.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "render/frame/aov_planes.h"
#include "render/frame/denoiser_planes.h"
#include "render/frame/frame.h"
#include "render/frame/frame_part.h"
#include "render/frame/frame_sums_data.h"
#include "render/frame/sample_plan.h"
#include "render/frame/splat_picture.h"
#include "render/frame/tile_renderer.h"
#include "render/frame_scene/frame_scene.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// Samples that all tiles of a session get before it looks at their noise again.
struct SessionRound {
    bool is_first = false;  // the first samples of all pixels
    bool is_last = false;   // no round is known to follow
    /// Of a further one, by tile of the frame, as multiples of the first samples: those that the
    /// round takes, and those that are expected in all rounds from it on.
    std::vector<double> lacking{}, expected{};
};

/// Is told what a session does, from any thread.
class SessionObserver {
  public:
    virtual ~SessionObserver() = default;

    /// Which of the session's tiles takes its first samples as the n-th.
    [[nodiscard]] virtual int nth_tile(int n) const { return n; }
    virtual void begin(const SessionRound& /*round*/) {}
    /// The round has added what is counted to the tile, in this CPU time; also if it was stopped.
    virtual void sampled(int /*tile*/, const RenderStatistics& /*count*/, double /*seconds*/) {}
    /// The tile has all samples of the round.
    virtual void finished(const SessionRound& /*round*/, int /*tile*/) {}
    virtual void traced(int /*tile*/, double /*seconds*/) {}  // its features
    virtual void planned(double /*seconds*/) {}               // CPU time of all threads
};

/// What a frame consists of. Its rows take memory as they are reached.
struct FramePlanes {
    Film film;
    AovPlanes aovs;
    DenoiserPlanes denoiser;

    void make_room(std::size_t pixels) {
        film.rgba.resize(std::max(film.rgba.size(), 4 * pixels));
        denoiser.make_room(pixels);
    }
};

/// The light that pixels do not sample themselves.
struct Reflections {
    std::vector<SplatPicture> pictures;  // one, or one of each half
    SplatMoments moments;                // their variance, if it is wanted
    RenderStatistics statistics;         // their rays
};

class FrameSession {
  public:
    /// `scene` and `sums` must outlive it. A session resumes from the samples in `sums` and keeps
    /// all of its own there. Throws as render_frame does.
    FrameSession(const PreparedScene& scene, std::span<const sim::Track> tracks,
                 const FrameInput& frame, const RenderSettings& settings, const SumsKind& kind,
                 FrameSums::Data& sums);

    [[nodiscard]] const RenderSettings& settings() const { return settings_; }
    [[nodiscard]] const FrameScene& scene() const { return frame_scene_; }
    [[nodiscard]] const TileRenderer& tiles() const { return tiles_; }
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(settings_.width) *
               static_cast<std::size_t>(settings_.height);
    }

    /// Samples only these tiles. Those that are sampled already keep their samples.
    void restrict_to(FramePart part);

    /// Takes samples until each pixel has `up_to`, or all of its own if that is fewer. Throws
    /// Stopped soon after a stop is requested, at the latest after one batch of samples per thread;
    /// the samples that are complete by then stay, and another call resumes from them.
    void refine(int up_to, const WorkContext& context, SessionObserver& observer);

    /// No further round is needed.
    [[nodiscard]] bool is_planned() const { return is_planned_; }
    /// Every pixel has this number of samples, or all of its own in the current round.
    [[nodiscard]] int samples() const { return samples_; }
    /// The most samples of a pixel after the current round.
    [[nodiscard]] int most_of_round() const;

    /// The sums of a tile, which it gets now if it has none.
    [[nodiscard]] TileSums& sums_of(int tile);
    /// Forgets the sums of a tile.
    void release(int tile) { sums_.tiles[static_cast<std::size_t>(tile)] = {}; }

    /// With the channels of these names. There is no room for pixels yet.
    [[nodiscard]] FramePlanes make_planes(const std::vector<std::string>& aovs,
                                          bool for_denoiser) const;
    /// Writes a tile, for which there is room.
    void write(int tile, FramePlanes& planes) const;
    /// Makes room for and writes all tiles in which there are samples, and calls `written` after
    /// each one from one thread. Throws Stopped.
    void write_all(FramePlanes& planes, const std::stop_token& stop,
                   const std::function<void(int tile)>& written = {}) const;
    /// Traces the images of lights in balls, with as many samples as pixels have on average. Throws
    /// Stopped.
    [[nodiscard]] Reflections trace_reflections(bool with_variance,
                                                const WorkContext& context) const;
    /// The frame, of which all tiles are written.
    [[nodiscard]] Film film_of(FramePlanes planes, const Reflections& reflections) const;

  private:
    /// A half of the samples, of which there are `samples` per pixel.
    struct Half {
        double samples = 0;
        int index = 0;
        float weight = 1;  // in the picture
    };

    void take(int up_to, const SessionRound& round, const WorkContext& context,
              SessionObserver& observer);
    void trace_features(const WorkContext& context, SessionObserver& observer);
    void plan_next_round(const WorkContext& context, SessionObserver& observer);
    [[nodiscard]] MeasuredError measured_error(const WorkContext& context) const;
    [[nodiscard]] double mean_samples() const;
    [[nodiscard]] SessionRound further_round() const;
    /// Calls visit(x, y, tile, pixel) for the pixels of the part's picture.
    template <class Visit>
    void for_each_pixel(const Visit& visit) const;

    [[nodiscard]] Reflections trace_reflections(double samples, bool with_variance,
                                                const WorkContext& context) const;
    [[nodiscard]] std::vector<std::vector<Splat>> trace_half(const Half& half,
                                                             RenderStatistics& statistics,
                                                             const WorkContext& context) const;

    const PreparedScene& prepared_;
    RenderSettings settings_;
    FrameInput frame_;
    SumsKind kind_;
    FrameSums::Data& sums_;
    FrameScene frame_scene_;
    LightSet lights_;
    TransportScene transport_;
    TileRenderer tiles_;
    FramePart part_;
    bool is_whole_ = true;
    bool is_planned_;
    int samples_ = 0;
    std::vector<double> expected_;  // SessionRound::expected of the planned round
};

}  // namespace carom::render
