// What became of the frames that workers began. Each worker adds lines to a file of its own, so
// that nobody waits for anybody and a killed worker leaves what it had noted.
//   FOLDER/workers/NAME.frames   one flat JSON object a line
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/farm/farm_job.h"

namespace carom::farm {

struct FrameRecord {
    std::string worker;          // the name of its note; not in the file
    std::string end;             // "rendered", "stopped", "failed"; "begun": of the worker itself
    std::string host;            // as in the worker's note
    std::int64_t frame = -1;     // -1 in the record "begun"
    std::int64_t layer = 0;      // of the frame: 1 for the second picture of a cross-fade
    double seconds = 0;          // from the claim to the stored picture
    std::int64_t memory = 0;     // bytes, the most that the worker had in memory meanwhile
    std::int64_t twice = 0;      // 1: somebody else had rendered it, too
    std::int64_t continued = 0;  // 1: with the samples of an earlier attempt
    std::int64_t revision = 0;   // of the wishes that the worker knew (wishes.h)
    double ended = 0;            // Unix time by the worker's clock, for people
    std::string log;             // of the worker's messages, in the job's folder; empty: not there
    std::int64_t log_from = 0;   // the bytes of this frame in it
    std::int64_t log_to = 0;
    std::string problem;  // of a frame that failed
};

/// Adds a line to the worker's file. A failure is ignored: a record is for people.
void add_frame_record(const FarmJob& job, const FrameRecord& record);

/// All records of a job, by the time of their ends. Lines that cannot be read are left out.
[[nodiscard]] std::vector<FrameRecord> read_frame_records(const FarmJob& job);

}  // namespace carom::farm
