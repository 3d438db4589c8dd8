#include "render/frame/frame.h"

#include <limits>
#include <utility>
#include <vector>

#include "core/free_memory.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/adaptive_progress.h"
#include "render/frame/frame_session.h"
#include "render/frame/large_picture.h"
#include "render/frame/tile_loop.h"

namespace carom::render {
namespace {

/// Writes each tile as soon as it has its samples, and then forgets their sums unless they may be
/// resumed from.
class EvenFrame final : public SessionObserver {
  public:
    EvenFrame(FrameSession& session, FramePlanes& planes, bool keeps_sums,
              const WorkContext& context)
        : session_(session),
          planes_(planes),
          keeps_sums_(keeps_sums),
          progress_(context.progress, session.tiles().tile_count()) {}

    void finished(const SessionRound& /*round*/, int tile) override {
        session_.write(tile, planes_);
        if (!keeps_sums_) {
            session_.release(tile);
        }
        progress_.finish_tile();
    }

  private:
    FrameSession& session_;
    FramePlanes& planes_;
    bool keeps_sums_;
    TileProgress progress_;
};

class AdaptiveFrame final : public SessionObserver {
  public:
    AdaptiveFrame(FrameSession& session, const FrameSums::Data& sums, const WorkContext& context)
        : session_(session),
          sums_(sums),
          progress_(context.progress, session.settings(), session.tiles().tile_count()) {}

    [[nodiscard]] int nth_tile(int n) const override { return progress_.nth_tile(n); }
    void begin(const SessionRound& round) override {
        const bool resumes = !round.is_first && std::exchange(is_begun_, true) == false;
        for (int tile = 0; resumes && tile < session_.tiles().tile_count(); ++tile) {
            finish_first(tile);
        }
        is_begun_ = true;
        if (!round.is_first) {
            progress_.begin_round(round.lacking, round.expected);
        }
    }
    void finished(const SessionRound& round, int tile) override {
        round.is_first ? finish_first(tile) : progress_.tile_done(tile);
    }
    void finish() { progress_.finish(); }

  private:
    void finish_first(int tile) {
        const auto index = static_cast<std::size_t>(tile);
        progress_.first_samples_done(tile, session_.tiles().errors(tile, sums_.tiles[index]),
                                     static_cast<double>(sums_.seconds[index]));
    }

    FrameSession& session_;
    const FrameSums::Data& sums_;
    AdaptiveProgress progress_;
    bool is_begun_ = false;
};

constexpr int kAllSamples = std::numeric_limits<int>::max();

Film render_evenly(FrameSession& session, FrameSums::Data& sums, bool keeps_sums,
                   const WorkContext& context) {
    const RenderSettings& settings = session.settings();
    FramePlanes planes = session.make_planes(settings.aovs, settings.for_denoiser);
    planes.make_room(session.pixel_count());
    EvenFrame observer(session, planes, keeps_sums, context);
    session.refine(kAllSamples, context, observer);
    const Reflections reflections = session.trace_reflections(planes.aovs.has_variance(), context);
    planes.film.statistics = std::exchange(sums, {}).statistics;
    return session.film_of(std::move(planes), reflections);
}

/// The sums of a tile are forgotten once they are written, so that they and the film do not take
/// memory at the same time. From there on nothing can be stopped.
Film render_adaptively(FrameSession& session, FrameSums::Data& sums, const WorkContext& context) {
    const RenderSettings& settings = session.settings();
    AdaptiveFrame observer(session, sums, context);
    session.refine(kAllSamples, context, observer);
    FramePlanes planes = session.make_planes(settings.aovs, settings.for_denoiser);
    const Reflections reflections = session.trace_reflections(planes.aovs.has_variance(), context);
    session.write_all(planes, {}, [&](int tile) {
        constexpr int kTilesAtOnce = 1024;
        session.release(tile);
        if (tile % kTilesAtOnce == kTilesAtOnce - 1) {
            give_back_freed_memory();
        }
    });
    planes.film.statistics = std::exchange(sums, {}).statistics;
    give_back_memory_of(session.pixel_count());
    observer.finish();
    return session.film_of(std::move(planes), reflections);
}

}  // namespace

Film render_frame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                  const FrameInput& frame, const RenderSettings& settings,
                  const WorkContext& context, FrameSums* sums) {
    const FlushDenormals flush;
    FrameSums own;
    FrameSums::Data& data = sums != nullptr ? sums->data() : own.data();
    FrameSession session(scene, tracks, frame, settings, SumsKind::needed_by(settings), data);
    return session.tiles().is_adaptive() ? render_adaptively(session, data, context)
                                         : render_evenly(session, data, sums != nullptr, context);
}

}  // namespace carom::render
