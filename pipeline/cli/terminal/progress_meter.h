// Measures the progress of a job, its speed, and the remaining time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace carom::cli {

struct ProgressSnapshot {
    std::string stage;                // "bake", "render", "encode"; empty before the first one
    double fraction = 0;              // of the stage, [0, 1]
    std::int64_t frames_total = 0;    // 0: the stage has no frames to count
    std::int64_t frames_done = 0;     // rendered or found
    std::int64_t frames_found = 0;    // of these, frames whose picture was stored or is shown again
    double elapsed = 0;               // s since the stage began
    std::optional<double> left;       // s; empty until it can be estimated
    std::optional<double> rays_rate;  // per second of the stage
};

/// Accumulates the calls of a job's observer. Times are seconds of any steady clock. For one thread
/// at a time.
class ProgressMeter {
  public:
    /// Sets the number of frames of the "render" stage.
    void expect_frames(std::int64_t total) { frames_total_ = total; }

    void on_progress(std::string_view stage, double fraction, double now);
    void on_frame(bool found, std::uint64_t rays, double now);

    [[nodiscard]] ProgressSnapshot snapshot(double now) const;

  private:
    void enter(std::string_view stage, double now);
    [[nodiscard]] std::optional<double> seconds_left(double elapsed) const;

    std::string stage_;
    double stage_begin_ = 0;
    double fraction_ = 0;
    std::int64_t frames_total_ = 0;
    std::int64_t frames_done_ = 0;
    std::int64_t frames_found_ = 0;
    std::uint64_t rays_ = 0;
    double last_frame_ = 0;  // when it was finished
};

}  // namespace carom::cli
