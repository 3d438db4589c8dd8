#include "pipeline/cli/farm/frame_table.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FrameRecord;
using farm::WorkerNote;

constexpr double kSlow = 2;  // times the median

/// The frame and its layer under which workers note a picture.
using PictureName = std::pair<std::int64_t, std::int64_t>;

/// The pictures that each frame of the job shows: none, if it is a title card.
std::map<std::int64_t, std::vector<PictureName>> pictures_of(const FarmFrames& frames) {
    std::map<std::int64_t, std::vector<PictureName>> pictures;
    for (const FarmFrames::Part& part : frames.parts()) {
        const auto name = [&](std::size_t index) {
            const pipeline::FilmPlan::Picture& picture = part.plan.pictures[index];
            return PictureName{picture.frame + part.shift,
                               static_cast<std::int64_t>(picture.layer)};
        };
        for (std::size_t i = 0; i < part.plan.frames.size(); ++i) {
            std::vector<PictureName>& shown = pictures[part.plan.frames[i] + part.shift];
            shown.push_back(name(part.plan.picture_of[i]));
            if (const pipeline::FilmPlan::Blend* blend = part.plan.blend_of(i)) {
                shown.push_back(name(blend->picture));
            }
        }
    }
    return pictures;
}

/// The notes of workers that work, by the frame; those of dead ones apart.
struct Workers {
    std::map<std::int64_t, const WorkerNote*> alive;
    std::map<std::int64_t, const WorkerNote*> dead;
    std::map<std::string, std::int64_t> on_host;  // of those alive, also of those that wait

    Workers(const farm::FarmJob& job, const JobState& state) {
        for (const WorkerNote& note : state.workers) {
            if (note.state == "ended") {
                continue;
            }
            const bool is_alive = state.state == "running" && state.is_alive(job, note);
            on_host[note.host] += is_alive ? 1 : 0;
            if (note.frame >= 0 && note.fraction < 1) {
                (is_alive ? alive : dead)[note.frame] = &note;
            }
        }
    }
};

/// What attempts have noted of one picture since it was last retried.
struct Attempts {
    const FrameRecord* last = nullptr;
    const FrameRecord* rendered = nullptr;
    const FrameRecord* failed = nullptr;
    std::int64_t tries = 0;
    std::int64_t failures = 0;
};

std::map<PictureName, Attempts> attempts_of(const std::vector<FrameRecord>& records,
                                            const farm::Wishes& wishes) {
    std::map<PictureName, Attempts> attempts;
    for (const FrameRecord& record : records) {
        const auto retried = wishes.retried.find(record.frame);
        if (record.frame < 0 ||
            (retried != wishes.retried.end() && record.revision < retried->second)) {
            continue;
        }
        Attempts& of_picture = attempts[{record.frame, record.layer}];
        of_picture.last = &record;
        ++of_picture.tries;
        if (record.end == "rendered") {
            of_picture.rendered = &record;
        } else if (record.end == "failed") {
            of_picture.failed = &record;
            ++of_picture.failures;
        }
    }
    return attempts;
}

/// Adds what was noted of one of the frame's pictures.
void add(const farm::FarmJob& job, const Attempts& attempts, FrameRow& row) {
    row.tries = std::max(row.tries, attempts.tries);
    row.failures += attempts.failures;
    if (attempts.rendered != nullptr) {
        row.seconds = row.seconds.value_or(0) + attempts.rendered->seconds;
        row.memory = std::max(row.memory, attempts.rendered->memory);
    }
    if (attempts.failed != nullptr) {
        row.problem = attempts.failed->problem;
    }
    if (attempts.last->ended >= row.ended) {
        row.host = attempts.last->host;
        row.worker = attempts.last->worker;
        row.ended = attempts.last->ended;
        row.log = log_path(job, *attempts.last);
    }
}

/// Adds what the notes of workers say of a frame that is not there.
void add(const Workers& workers, std::int64_t noted_as, FrameRow& row) {
    if (const auto dead = workers.dead.find(noted_as); dead != workers.dead.end()) {
        ++row.tries;
        ++row.failures;
        row.problem = "worker " + dead->second->name + " was cut off in this frame";
        row.host = dead->second->host;
        row.worker = dead->second->name;
    }
    if (const auto alive = workers.alive.find(noted_as); alive != workers.alive.end()) {
        row.state = FrameState::rendering;
        row.fraction = alive->second->fraction;
        row.host = alive->second->host;
        row.worker = alive->second->name;
    }
}

std::vector<NodeRow> nodes_of(const std::vector<FrameRecord>& records, const Workers& workers) {
    struct Span {
        double begin = 0;
        double end = 0;
    };
    std::map<std::string, std::pair<NodeRow, Span>> nodes;
    for (const FrameRecord& record : records) {
        auto& [row, span] = nodes[record.host];
        row.rendered += record.end == "rendered" ? 1 : 0;
        row.failures += record.end == "failed" ? 1 : 0;
        const double begin = record.ended - record.seconds;
        span.begin = span.begin == 0 ? begin : std::min(span.begin, begin);
        span.end = std::max(span.end, record.ended);
    }
    for (const auto& [host, count] : workers.on_host) {
        nodes[host].first.workers = count;
    }
    for (const auto& [frame, note] : workers.dead) {
        ++nodes[note->host].first.failures;
    }
    std::vector<NodeRow> rows;
    for (auto& [host, node] : nodes) {
        auto& [row, span] = node;
        row.host = host;
        if (row.rendered > 0 && span.end > span.begin) {
            row.per_hour = 3600 * static_cast<double>(row.rendered) / (span.end - span.begin);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Of those that have any; 0 if none has.
double median_seconds(const std::vector<FrameRow>& rows) {
    std::vector<double> seconds;
    for (const FrameRow& row : rows) {
        if (row.seconds) {
            seconds.push_back(*row.seconds);
        }
    }
    if (seconds.empty()) {
        return 0;
    }
    const auto middle = seconds.begin() + std::ssize(seconds) / 2;
    std::ranges::nth_element(seconds, middle);
    return *middle;
}

}  // namespace

const char* name_of(FrameState state) {
    switch (state) {
        case FrameState::done:
            return "done";
        case FrameState::rendering:
            return "rendering";
        case FrameState::failed:
            return "failed";
        case FrameState::missing:
            return "missing";
        case FrameState::skipped:
            return "skipped";
    }
    return "";
}

FrameTable frame_table(const farm::FarmJob& job, const FarmFrames& frames, const JobState& state,
                       const farm::Wishes& wishes, const std::vector<farm::FrameRecord>& records) {
    const std::map<PictureName, Attempts> attempts = attempts_of(records, wishes);
    const Workers workers(job, state);
    const std::set<std::int64_t> finished(state.finished.begin(), state.finished.end());
    auto pictures = pictures_of(frames);
    FrameTable table;
    for (const std::int64_t frame : frames.numbers()) {
        FrameRow row;
        row.frame = frame;
        const bool is_done = finished.contains(frame);
        for (const PictureName& picture : pictures[frame]) {
            if (const auto noted = attempts.find(picture); noted != attempts.end()) {
                add(job, noted->second, row);
            }
            if (!is_done) {
                add(workers, picture.first, row);
            }
        }
        if (is_done) {
            row.state = FrameState::done;
        } else if (wishes.skipped.contains(frame)) {
            row.state = FrameState::skipped;
        } else if (row.state != FrameState::rendering && row.failures > 0) {
            row.state = FrameState::failed;
        }
        table.frames.push_back(std::move(row));
    }
    table.median_seconds = median_seconds(table.frames);
    for (FrameRow& row : table.frames) {
        row.is_slow = row.seconds && *row.seconds > kSlow * table.median_seconds;
    }
    table.nodes = nodes_of(records, workers);
    return table;
}

std::string log_path(const farm::FarmJob& job, const farm::FrameRecord& record) {
    const fs::path name = fs::path(record.log).lexically_normal();
    const bool is_inside = !name.empty() && name.is_relative() && *name.begin() != "..";
    return is_inside ? job.folder + "/" + name.string() : "";
}

}  // namespace carom::cli
