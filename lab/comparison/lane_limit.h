// How many numbers the renderer's vectors hold.
#pragma once

namespace carom::pipeline {

/// Limits the vectors of the whole process while the object exists; to be made before structures
/// are prepared, and not twice at the same time. Rays hit the same with every limit.
class LaneLimit {
  public:
    /// 4 (SSE4), 8 (AVX2) or 16 (AVX-512); the machine has them.
    explicit LaneLimit(int lanes);
    ~LaneLimit();
    LaneLimit(const LaneLimit&) = delete;
    LaneLimit& operator=(const LaneLimit&) = delete;

    /// Whether this machine's processor has vectors of so many numbers, whatever the limit.
    [[nodiscard]] static bool machine_has(int lanes);
};

}  // namespace carom::pipeline
