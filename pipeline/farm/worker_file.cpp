#include "pipeline/farm/worker_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "core/error.h"
#include "pipeline/farm/record.h"

namespace carom::farm {
namespace {

namespace fs = std::filesystem;

std::optional<WorkerNote> read_worker(const std::string& path) {
    try {
        const std::optional<Record> record = Record::read(path);
        if (!record) {
            return std::nullopt;
        }
        std::error_code unknown;
        return WorkerNote{record->text("name"),           record->text("host"),
                          record->text("state"),          record->integer("frame"),
                          record->number("fraction"),     record->integer("heartbeat"),
                          record->number("seconds_left"), record->integer("rendered"),
                          record->integer("twice"),       record->integer("continued"),
                          record->text("problem"),        fs::last_write_time(path, unknown)};
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

void write_worker(const FarmJob& job, const WorkerNote& note) {
    JsonMembers members;
    members.add("name", note.name)
        .add("host", note.host)
        .add("state", note.state)
        .add("frame", note.frame)
        .add("fraction", note.fraction)
        .add("heartbeat", note.heartbeat)
        .add("seconds_left", note.seconds_left)
        .add("rendered", note.rendered)
        .add("twice", note.twice)
        .add("continued", note.continued)
        .add("problem", note.problem);
    write_record(job.folder + "/workers/" + note.name + ".json", members);
}

std::vector<WorkerNote> read_workers(const FarmJob& job) {
    std::vector<WorkerNote> notes;
    std::error_code ignored;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(job.folder + "/workers", ignored)) {
        if (entry.path().extension() == ".json") {
            if (std::optional<WorkerNote> note = read_worker(entry.path().string())) {
                notes.push_back(std::move(*note));
            }
        }
    }
    std::sort(notes.begin(), notes.end(),
              [](const WorkerNote& a, const WorkerNote& b) { return a.name < b.name; });
    return notes;
}

}  // namespace carom::farm
