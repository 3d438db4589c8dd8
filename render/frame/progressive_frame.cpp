#include "render/frame/progressive_frame.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/frame_session.h"

namespace carom::render {
namespace {

/// A round of adaptive sampling fills half of the rest of the progress.
class RoundProgress final : public SessionObserver {
  public:
    RoundProgress(const ProgressCallback& callback, int tiles)
        : callback_(callback), tiles_(tiles) {}

    void begin(const SessionRound& round) override {
        from_ = to_;
        to_ = round.is_last ? 1 : 0.5 * (1 + from_);
        done_ = 0;
    }
    void finished(const SessionRound& /*round*/, int /*tile*/) override {
        const std::lock_guard lock(mutex_);
        ++done_;
        report(from_ + (to_ - from_) * done_ / tiles_);
    }
    void report(double fraction) const {
        if (callback_) {
            callback_(fraction);
        }
    }

  private:
    const ProgressCallback& callback_;
    int tiles_;
    std::mutex mutex_;
    double from_ = 0;
    double to_ = 0;
    int done_ = 0;
};

}  // namespace

struct ProgressiveFrame::Data {
    Data(const PreparedScene& scene, std::span<const sim::Track> tracks, const FrameInput& frame,
         const RenderSettings& settings)
        : session(scene, tracks, frame, settings, SumsKind::for_all_aovs(settings), sums) {}

    FrameSums::Data sums;
    FrameSession session;

    [[nodiscard]] int most_samples() const {
        const RenderSettings& settings = session.settings();
        return session.is_planned() ? session.most_of_round()
                                    : std::max(settings.samples, settings.max_samples);
    }
    [[nodiscard]] Film film(const std::vector<std::string>& aovs, bool for_denoiser,
                            const WorkContext& context) const {
        FramePlanes planes = session.make_planes(aovs, for_denoiser);
        const Reflections reflections =
            session.trace_reflections(planes.aovs.has_variance(), context);
        session.write_all(planes, context.stop);
        planes.film.statistics = sums.statistics;
        return session.film_of(std::move(planes), reflections);
    }
};

ProgressiveFrame::ProgressiveFrame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                                   const FrameInput& frame, const RenderSettings& settings) {
    const FlushDenormals flush;
    data_ = std::make_unique<Data>(scene, tracks, frame, settings);
}

ProgressiveFrame::~ProgressiveFrame() = default;
ProgressiveFrame::ProgressiveFrame(ProgressiveFrame&&) noexcept = default;
ProgressiveFrame& ProgressiveFrame::operator=(ProgressiveFrame&&) noexcept = default;

void ProgressiveFrame::refine(int up_to_samples, const WorkContext& context) {
    FrameSession& session = data_->session;
    if (session.is_planned() && up_to_samples <= session.samples()) {
        return;
    }
    const bool was_planned = session.is_planned();
    RoundProgress progress(context.progress, session.tiles().tile_count());
    session.refine(up_to_samples, context, progress);
    if (session.is_planned() && !was_planned) {
        progress.report(1);
    }
}

int ProgressiveFrame::samples() const {
    return data_->session.samples();
}

int ProgressiveFrame::most_samples() const {
    return data_->most_samples();
}

bool ProgressiveFrame::finished() const {
    return data_->session.is_planned() && samples() >= most_samples();
}

const RenderStatistics& ProgressiveFrame::statistics() const {
    return data_->sums.statistics;
}

Film ProgressiveFrame::picture(const WorkContext& context) const {
    return data_->film({}, false, context);
}

std::vector<Channel> ProgressiveFrame::channels(const std::string& aov,
                                                const WorkContext& context) const {
    if (!is_aov(aov)) {
        throw Error("there is no AOV '" + aov + "'");
    }
    return data_->film({aov}, false, context).aovs;
}

Film ProgressiveFrame::film(const WorkContext& context) const {
    const RenderSettings& settings = data_->session.settings();
    return data_->film(settings.aovs, settings.for_denoiser, context);
}

}  // namespace carom::render
