#include "pipeline/cli/terminal/progress_meter.h"

#include <algorithm>

namespace carom::cli {

namespace {

constexpr std::string_view kRenderStage = "render";

}  // namespace

void ProgressMeter::enter(std::string_view stage, double now) {
    if (stage_ != stage) {
        stage_ = stage;
        stage_begin_ = now;
        share_ = 0;
    }
}

void ProgressMeter::on_progress(std::string_view stage, double share, double now) {
    enter(stage, now);
    share_ = std::clamp(share, share_, 1.0);
}

void ProgressMeter::on_frame(bool found, std::uint64_t rays, double now) {
    enter(kRenderStage, now);
    ++frames_done_;
    frames_found_ += found ? 1 : 0;
    rays_ += rays;
}

std::optional<double> ProgressMeter::seconds_left(double elapsed) const {
    if (stage_ == kRenderStage && frames_total_ > 0) {
        // Found frames take no time and say nothing about the others.
        const std::int64_t rendered = frames_done_ - frames_found_;
        if (rendered == 0) {
            return std::nullopt;
        }
        const std::int64_t remaining = std::max<std::int64_t>(frames_total_ - frames_done_, 0);
        return elapsed / static_cast<double>(rendered) * static_cast<double>(remaining);
    }
    constexpr double kTooEarly = 0.01;
    if (share_ < kTooEarly) {
        return std::nullopt;
    }
    return elapsed * (1 - share_) / share_;
}

ProgressSnapshot ProgressMeter::snapshot(double now) const {
    ProgressSnapshot snapshot;
    snapshot.stage = stage_;
    snapshot.share = share_;
    snapshot.elapsed = now - stage_begin_;
    snapshot.left = seconds_left(snapshot.elapsed);
    if (stage_ == kRenderStage) {
        snapshot.frames_total = frames_total_;
        snapshot.frames_done = frames_done_;
        snapshot.frames_found = frames_found_;
        if (frames_total_ > 0) {
            const double by_frames =
                static_cast<double>(frames_done_) / static_cast<double>(frames_total_);
            snapshot.share = std::clamp(std::max(share_, by_frames), 0.0, 1.0);
        }
        if (rays_ > 0 && snapshot.elapsed > 0) {
            snapshot.rays_rate = static_cast<double>(rays_) / snapshot.elapsed;
        }
    }
    return snapshot;
}

}  // namespace carom::cli
