#include "pipeline/cli/job_observer.h"

#include <chrono>
#include <memory>

#include "pipeline/cli/terminal/progress_meter.h"
#include "pipeline/cli/terminal/progress_text.h"

namespace carom::cli {

namespace {

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

}  // namespace

pipeline::JobObserver make_console_observer(Console& console, std::int64_t frames) {
    const auto meter = std::make_shared<ProgressMeter>();
    meter->expect_frames(frames);
    pipeline::JobObserver observer;
    observer.on_progress = [meter, &console](std::string_view stage, double fraction) {
        meter->on_progress(stage, fraction, now());
        console.progress(meter->snapshot(now()));
    };
    observer.on_warning = [&console](const std::string& message) { console.warning(message); };
    observer.on_frame = [meter, &console](std::int64_t frame, bool from_store, double seconds,
                                          std::uint64_t rays) {
        meter->on_frame(from_store, rays, now());
        const ProgressSnapshot snapshot = meter->snapshot(now());
        console.event("frame", frame_json(frame, from_store, seconds, snapshot), {}, false);
        console.progress(snapshot);
    };
    return observer;
}

ProgressCallback progress_on(Console& console, const std::string& stage) {
    const auto clock = [] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
    };
    return [&console, stage, clock, meter = ProgressMeter(),
            begin = clock()](double fraction) mutable {
        constexpr double kLong = 1;  // s
        const double now = clock();
        meter.on_progress(stage, fraction, now);
        if (now - begin > kLong) {
            console.progress(meter.snapshot(now));
        }
    };
}

}  // namespace carom::cli
