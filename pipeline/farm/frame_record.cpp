#include "pipeline/farm/frame_record.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fcntl.h>

#include "core/error.h"
#include "core/write_all.h"
#include "pipeline/farm/record.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::farm {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 1;
constexpr std::uintmax_t kLongest = 64 << 20;  // bytes of a worker's file
constexpr const char* kExtension = ".frames";
constexpr mode_t kMode = 0666;  // less what the process's mask takes away

FrameRecord record_of(const Record& line) {
    if (line.integer("carom_frame") != kFormat) {
        throw Error("another format");
    }
    FrameRecord record;
    record.end = line.text("end");
    record.host = line.text("host");
    record.frame = line.integer("frame");
    record.layer = line.integer("layer");
    record.seconds = line.number("seconds");
    record.memory = line.integer("memory_bytes");
    record.twice = line.integer("twice");
    record.continued = line.integer("continued");
    record.revision = line.integer("revision");
    record.ended = line.number("ended");
    record.log = line.text("log");
    record.log_from = line.integer("log_from");
    record.log_to = line.integer("log_to");
    record.problem = line.text("problem");
    return record;
}

void read_file(const fs::path& path, std::vector<FrameRecord>& records) {
    std::error_code failure;
    if (!fs::is_regular_file(path, failure) || fs::file_size(path, failure) > kLongest) {
        return;  // somebody else's
    }
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        try {
            records.push_back(record_of(Record::parse(line, path.string())));
            records.back().worker = path.stem().string();
        } catch (const Error&) {
            continue;  // half a line of a full store
        }
    }
}

}  // namespace

void add_frame_record(const FarmJob& job, const FrameRecord& record) {
    JsonMembers members;
    members.add("carom_frame", kFormat)
        .add("end", record.end)
        .add("host", record.host)
        .add("frame", record.frame)
        .add("layer", record.layer)
        .add("seconds", record.seconds)
        .add("memory_bytes", record.memory)
        .add("twice", record.twice)
        .add("continued", record.continued)
        .add("revision", record.revision)
        .add("ended", record.ended)
        .add("log", record.log)
        .add("log_from", record.log_from)
        .add("log_to", record.log_to)
        .add("problem", record.problem);
    // The line break is first, too, so that half a line before it spoils only itself.
    const std::string line = "\n" + members.object() + "\n";
    const std::string path = job.folder + "/workers/" + record.worker + kExtension;
    const pipeline::FileDescriptor file(
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kMode));
    if (file.is_open()) {
        (void)write_all(file.get(), std::as_bytes(std::span(line)));
    }
}

std::vector<FrameRecord> read_frame_records(const FarmJob& job) {
    std::vector<FrameRecord> records;
    std::error_code ignored;
    for (fs::directory_iterator entry(job.folder + "/workers", ignored), end;
         !ignored && entry != end; entry.increment(ignored)) {
        if (entry->path().extension() == kExtension) {
            read_file(entry->path(), records);
        }
    }
    std::ranges::stable_sort(records, {}, &FrameRecord::ended);
    return records;
}

}  // namespace carom::farm
