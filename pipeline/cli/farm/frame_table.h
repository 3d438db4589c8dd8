// What is known of each frame of a job, and of each node that worked on it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_state.h"
#include "pipeline/farm/frame_record.h"
#include "pipeline/farm/wishes.h"

namespace carom::cli {

/// How far a frame is.
enum class FrameState { done, rendering, failed, missing, skipped };
[[nodiscard]] const char* name_of(FrameState state);

struct FrameRow {
    std::int64_t frame = 0;
    FrameState state = FrameState::missing;
    double fraction = 0;            // of a frame that is being rendered
    std::string host;               // of the last attempt; empty: nobody has noted any
    std::string worker;             // likewise
    std::optional<double> seconds;  // of the attempts that rendered its pictures
    bool is_slow = false;           // it took more than twice the median
    std::int64_t memory = 0;        // bytes, the most of these
    std::int64_t tries = 0;         // attempts that ended, or were cut off
    std::int64_t failures = 0;      // of these
    double ended = 0;               // Unix time of the last attempt's end
    std::string log;                // the file of the last attempt's messages; empty: not known
    std::string problem;            // of its last failure
};

struct NodeRow {
    std::string host;
    std::int64_t workers = 0;  // that work now
    std::int64_t rendered = 0;
    std::int64_t failures = 0;
    std::optional<double> per_hour;  // frames, from its first worker's start to its last frame
};

struct FrameTable {
    std::vector<FrameRow> frames;  // ascending
    double median_seconds = 0;     // of them; 0: none has any
    std::vector<NodeRow> nodes;    // by name
};

/// Joins what is stored, what the workers have noted, and the wishes. `records`: by
/// time.
[[nodiscard]] FrameTable frame_table(const farm::FarmJob& job, const FarmFrames& frames,
                                     const JobState& state, const farm::Wishes& wishes,
                                     const std::vector<farm::FrameRecord>& records);

/// The folder of the workers' logs and the record's name in it; empty if it is not inside.
[[nodiscard]] std::string log_path(const farm::FarmJob& job, const farm::FrameRecord& record);

}  // namespace carom::cli
