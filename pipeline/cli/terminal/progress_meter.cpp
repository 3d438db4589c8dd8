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
        fraction_ = 0;
    }
}

void ProgressMeter::on_progress(std::string_view stage, double fraction, double now) {
    enter(stage, now);
    fraction_ = std::clamp(fraction, fraction_, 1.0);
}

void ProgressMeter::on_frame(bool found, std::uint64_t rays, double now) {
    enter(kRenderStage, now);
    ++frames_done_;
    frames_found_ += found ? 1 : 0;
    rays_ += rays;
    last_frame_ = now;
}

std::optional<double> ProgressMeter::seconds_left(double elapsed) const {
    if (stage_ == kRenderStage && frames_total_ > 0) {
        // Found frames take no time, so they are excluded from the rate. A frame in progress counts
        // by its fraction.
        const auto total = static_cast<double>(frames_total_);
        const double reached = std::max(fraction_ * total, static_cast<double>(frames_done_));
        const double worked = reached - static_cast<double>(frames_found_);
        constexpr double kMinFrames = 0.1;
        if (worked < kMinFrames) {
            return std::nullopt;
        }
        return elapsed / worked * std::max(total - reached, 0.0);
    }
    constexpr double kMinFraction = 0.01;
    if (fraction_ < kMinFraction) {
        return std::nullopt;
    }
    return elapsed * (1 - fraction_) / fraction_;
}

ProgressSnapshot ProgressMeter::snapshot(double now) const {
    ProgressSnapshot snapshot;
    snapshot.stage = stage_;
    snapshot.fraction = fraction_;
    snapshot.elapsed = now - stage_begin_;
    snapshot.left = seconds_left(snapshot.elapsed);
    if (stage_ == kRenderStage) {
        snapshot.frames_total = frames_total_;
        snapshot.frames_done = frames_done_;
        snapshot.frames_found = frames_found_;
        if (frames_total_ > 0) {
            const double by_frames =
                static_cast<double>(frames_done_) / static_cast<double>(frames_total_);
            snapshot.fraction = std::clamp(std::max(fraction_, by_frames), 0.0, 1.0);
        }
        // Rays are known only when a frame is finished, so the rate is constant between two frames.
        if (rays_ > 0 && last_frame_ > stage_begin_) {
            snapshot.rays_rate = static_cast<double>(rays_) / (last_frame_ - stage_begin_);
        }
    }
    return snapshot;
}

}  // namespace carom::cli
