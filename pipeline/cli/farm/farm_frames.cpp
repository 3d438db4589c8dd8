// The frames of a job.
#include <algorithm>

#include <fmt/core.h>

#include "core/printable.h"
#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/frame_table.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/store/cache_maintenance.h"

namespace carom::cli {
namespace {

/// Whether the user wants to see the frame.
bool is_wanted(const FrameRow& row, const FarmCommand& command) {
    const bool is_all = !command.only_failed && !command.only_slow && !command.only_missing;
    return is_all || (command.only_failed && row.failures > 0) ||
           (command.only_slow && row.is_slow) ||
           (command.only_missing && row.state != FrameState::done);
}

std::string json_of(const FrameRow& row) {
    JsonMembers members;
    members.add("frame", row.frame).add("state", name_of(row.state));
    if (row.state == FrameState::rendering) {
        members.add("fraction", row.fraction);
    }
    if (!row.worker.empty()) {
        members.add("node", row.host).add("worker", row.worker);
    }
    if (row.seconds) {
        members.add("seconds", *row.seconds)
            .add("slow", row.is_slow ? 1 : 0)
            .add("memory_bytes", row.memory);
    }
    members.add("tries", row.tries).add("failures", row.failures);
    if (row.ended > 0) {
        members.add("ended", row.ended).add("log", row.log);
    }
    if (!row.problem.empty()) {
        members.add("problem", row.problem);
    }
    return members.object();
}

std::string json_of(const NodeRow& row) {
    JsonMembers members;
    members.add("node", row.host)
        .add("workers", row.workers)
        .add("rendered", row.rendered)
        .add("failures", row.failures);
    if (row.per_hour) {
        members.add("frames_per_hour", *row.per_hour);
    }
    return members.object();
}

template <class Row>
std::string list_of(const std::vector<Row>& rows) {
    std::vector<std::string> objects;
    objects.reserve(rows.size());
    for (const Row& row : rows) {
        objects.push_back(json_of(row));
    }
    return "[" + join(objects, ",") + "]";
}

std::string json_of(const farm::FarmJob& job, const JobState& state, const FrameTable& table) {
    JsonMembers members;
    members.add("id", farm::job_id(job.folder))
        .add("film", job.film)
        .add("folder", job.folder)
        .add("state", state.state)
        .add("message", state.message)
        .add("frames", state.frames)
        .add("finished", std::ssize(state.finished))
        .add("median_seconds", table.median_seconds);
    if (state.left) {
        members.add("seconds_left", *state.left);
    }
    return fmt::format("{{{},\"rows\":{},\"nodes\":{}}}\n", members.text(), list_of(table.frames),
                       list_of(table.nodes));
}

std::string time_text(double seconds) {
    constexpr double kShort = 100;
    return seconds < kShort ? fmt::format("{:.1f} s", seconds) : duration_text(seconds);
}

std::string text_of(const FrameRow& row) {
    const std::string state = row.state == FrameState::rendering
                                  ? fmt::format("{:.0f} %", 100 * row.fraction)
                                  : name_of(row.state);
    std::string text = fmt::format(
        "{:>6} {:8} {:14} {:>10} {:>8} {:>5} {}", row.frame, state, row.host.substr(0, 14),
        row.seconds ? time_text(*row.seconds) : "",
        row.memory > 0 ? pipeline::size_text(static_cast<std::uint64_t>(row.memory)) : "",
        row.tries > 0 ? std::to_string(row.tries) : "", row.worker);
    text = printable(text.substr(0, text.find_last_not_of(' ') + 1)) + "\n";
    return text + (row.problem.empty() ? "" : "       " + printable(row.problem) + "\n");
}

}  // namespace

void farm_frames(const FarmCommand& command, CommandContext& context) {
    const farm::FarmJob job = find_job(command, JobUse::look);
    const FarmFilm film = read_film(job, JobUse::look, context);
    const FarmFrames frames(film, context.stop);
    const JobState state = state_of(job, frames);
    FrameTable table =
        frame_table(job, frames, state, farm::read_wishes(job), farm::read_frame_records(job));
    std::erase_if(table.frames, [&](const FrameRow& row) { return !is_wanted(row, command); });
    if (command.json) {
        return print_text(json_of(job, state, table));
    }
    std::string text = fmt::format("{}: {}, {} of {} frames", printable(job.film), state.state,
                                   state.finished.size(), state.frames);
    text += table.median_seconds > 0 ? ", median " + time_text(table.median_seconds) + " a frame\n"
                                     : "\n";
    text += fmt::format("{:>6} {:8} {:14} {:>10} {:>8} {:>5} {}\n", "FRAME", "STATE", "NODE",
                        "TIME", "MEMORY", "TRIES", "WORKER");
    for (const FrameRow& row : table.frames) {
        text += text_of(row);
    }
    print_text(text);
}

}  // namespace carom::cli
