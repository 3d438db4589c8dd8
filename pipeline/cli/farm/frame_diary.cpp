#include "pipeline/cli/farm/frame_diary.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/farm/frame_record.h"
#include "pipeline/farm/wishes.h"
#include "pipeline/store/cache_maintenance.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;

/// Bytes: the most that the process had in memory since reset_peak_memory(), or since its start
/// where the kernel does not reset it (proc(5), VmHWM). 0 if this is not known.
std::int64_t peak_memory() {
    constexpr std::int64_t kKibibyte = 1024;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::int64_t size = 0;
        if (word == "VmHWM:" && status >> size) {
            return kKibibyte * size;
        }
    }
    return 0;
}

void reset_peak_memory() {
    std::ofstream("/proc/self/clear_refs") << "5";  // proc(5)
}

/// The file of standard error in the job's folder, relative to that; empty if it is elsewhere.
std::string own_log(const std::string& folder) {
    std::error_code failure;
    const fs::path log = fs::read_symlink("/proc/self/fd/2", failure);
    const fs::path inside =
        failure ? fs::path() : log.lexically_relative(fs::canonical(folder, failure));
    const bool is_inside =
        !failure && !inside.empty() && *inside.begin() != ".." && fs::is_regular_file(log, failure);
    return is_inside ? inside.string() : "";
}

/// How long the log is: others may write to it, too, such as the task's shell.
std::int64_t log_length() {
    struct stat status {};
    return ::fstat(STDERR_FILENO, &status) == 0 && S_ISREG(status.st_mode) ? status.st_size : 0;
}

const char* end_of(pipeline::FrameAttempt::End end) {
    switch (end) {
        case pipeline::FrameAttempt::End::rendered:
            return "rendered";
        case pipeline::FrameAttempt::End::stopped:
            return "stopped";
        case pipeline::FrameAttempt::End::failed:
            return "failed";
    }
    return "";
}

}  // namespace

FrameDiary::FrameDiary(const farm::FarmJob& job, std::string worker, std::string host,
                       Console& console)
    : job_(job),
      worker_(std::move(worker)),
      host_(std::move(host)),
      console_(console),
      log_position_(log_length()) {
    note({.frame = -1}, "begun", 0);
    reset_peak_memory();
}

pipeline::FrameWishes FrameDiary::wishes() {
    try {
        const farm::Wishes wishes = farm::read_wishes(job_);
        wishes_ = {wishes.revision, wishes.preferred, wishes.skipped};
    } catch (const Error&) {
        return wishes_;
    }
    return wishes_;
}

void FrameDiary::add(const pipeline::FrameAttempt& attempt) {
    const std::int64_t memory = peak_memory();
    const char* end = end_of(attempt.end);
    console_.info(fmt::format("frame {} {} in {} with {}{}{}", attempt.frame, end,
                              duration_text(attempt.seconds),
                              pipeline::size_text(static_cast<std::uint64_t>(memory)),
                              attempt.problem.empty() ? "" : ": ", attempt.problem));
    note(attempt, end, memory);
    reset_peak_memory();
}

void FrameDiary::note(const pipeline::FrameAttempt& attempt, const char* end, std::int64_t memory) {
    const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
    farm::FrameRecord record{.worker = worker_,
                             .end = end,
                             .host = host_,
                             .frame = attempt.frame,
                             .layer = static_cast<std::int64_t>(attempt.layer),
                             .seconds = attempt.seconds,
                             .memory = memory,
                             .twice = attempt.twice ? 1 : 0,
                             .continued = attempt.continued ? 1 : 0,
                             .revision = wishes_.revision,
                             .ended = now.count(),
                             .log = own_log(job_.folder),
                             .log_from = log_position_,
                             .log_to = log_length(),
                             .problem = attempt.problem};
    log_position_ = record.log_to;
    farm::add_frame_record(job_, record);
}

}  // namespace carom::cli
