#include "pipeline/farm/farm_job.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/hash.h"
#include "pipeline/farm/record.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::farm {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 4;
constexpr int kMostJobs = 10000;  // of one film in one store

std::string farm_folder(const std::string& store) {
    return store + "/farm";
}

/// The film's name in that of its job's folder.
std::string name_of_film(const std::string& film) {
    const std::string name = simple_name(fs::path(film).stem().string());
    return name.empty() ? "film" : name;
}

/// Returns whether it was made, which is not the case if the name is taken. Throws Error.
bool make_folder(const std::string& path, Readers readers) {
    if (::mkdir(path.c_str(), 0700) == 0) {
        const mode_t mode = readers == Readers::group ? 02750 : 0755;
        if (readers != Readers::none && ::chmod(path.c_str(), mode) != 0) {
            throw Error(pipeline::system_problem(path, "others cannot be allowed to read it"));
        }
        return true;
    }
    if (errno != EEXIST) {
        throw Error(pipeline::system_problem(path, "the folder cannot be made"));
    }
    return false;
}

/// In a folder that several users share, none may replace the jobs of others, whose scripts run as
/// these.
void keep_entries_of_owners(const std::string& folder) {
    struct stat status {};
    if (::stat(folder.c_str(), &status) == 0 && (status.st_mode & 022U) != 0) {
        (void)::chmod(folder.c_str(), (status.st_mode & 07777U) | S_ISVTX);  // by its owner
    }
}

std::string option_name(std::size_t index) {
    return fmt::format("engine_option_{}", index + 1);
}

std::string text_of(const std::optional<Record>& record, const char* name) {
    return record->text(name);
}

}  // namespace

void write_job(const FarmJob& job) {
    JsonMembers members;
    members.add("carom_farm_job", kFormat)
        .add("film", job.film)
        .add("shot", job.shot)
        .add("name", job.name)
        .add("store", job.store)
        .add("root", job.root)
        .add("frames", job.frames)
        .add("workers", job.workers)
        .add("tasks_at_once", job.tasks_at_once)
        .add("processors", job.processors)
        .add("memory_mb", job.memory)
        .add("frame_bytes", job.frame_bytes)
        .add("budget_seconds", job.budget)
        .add("dead_after_seconds", job.dead_after)
        .add("partition", job.partition)
        .add("account", job.account)
        .add("priority", job.priority)
        .add("time_minutes", job.time)
        .add("film_time_minutes", job.film_time)
        .add("exec_after", job.exec_after)
        .add("engine", job.engine)
        .add("film_mask", job.film_mask)
        .add("sequence", job.is_sequence ? 1 : 0)
        .add("portable", job.is_portable ? 1 : 0)
        .add("id", job.id);
    for (std::size_t i = 0; i < job.engine_options.size(); ++i) {
        members.add(option_name(i), job.engine_options[i]);
    }
    write_record(job.folder + "/job.json", members);
}

FarmJob read_job(const std::string& folder) {
    const std::string path = folder + "/job.json";
    const std::optional<Record> record = Record::read(path);
    if (!record) {
        throw Error("'" + folder + "' is not the folder of a job: it has no job.json");
    }
    if (record->integer("carom_farm_job") != kFormat) {
        throw Error("'" + path +
                    "' was written by another version of carom; submit the film again");
    }
    FarmJob job;
    const fs::path absolute = fs::absolute(folder).lexically_normal();
    job.folder = (absolute.has_filename() ? absolute : absolute.parent_path()).string();
    // Absolute, unless the job is portable.
    job.film = (fs::path(job.folder) / text_of(record, "film")).string();
    job.shot = text_of(record, "shot");
    job.name = text_of(record, "name");
    job.store = (fs::path(job.folder) / text_of(record, "store")).string();
    job.root = text_of(record, "root");
    if (!job.root.empty()) {
        job.root = (fs::path(job.folder) / job.root).lexically_normal().string();
    }
    job.frames = text_of(record, "frames");
    job.workers = record->integer("workers");
    job.tasks_at_once = record->integer("tasks_at_once");
    job.processors = record->integer("processors");
    job.memory = record->integer("memory_mb");
    job.frame_bytes = record->integer("frame_bytes");
    job.budget = record->number("budget_seconds");
    job.dead_after = record->number("dead_after_seconds");
    job.partition = text_of(record, "partition");
    job.account = text_of(record, "account");
    job.priority = record->integer("priority");
    job.time = record->integer("time_minutes");
    job.film_time = record->integer("film_time_minutes");
    job.exec_after = text_of(record, "exec_after");
    for (std::string option = text_of(record, option_name(0).c_str()); !option.empty();
         option = text_of(record, option_name(job.engine_options.size()).c_str())) {
        job.engine_options.push_back(option);
    }
    job.engine = text_of(record, "engine");
    job.film_mask = record->text("film_mask").empty() ? -1 : record->integer("film_mask");
    job.is_sequence = record->integer("sequence") != 0;
    job.is_portable = record->integer("portable") != 0;
    job.id = text_of(record, "id");
    if (job.workers < 1 || job.processors < 1 || job.budget <= 0 || job.dead_after <= 0) {
        throw Error("'" + path +
                    "' has no workers, or no time or processor for them; submit the film again");
    }
    return job;
}

bool is_job_folder(const std::string& folder) {
    std::error_code failure;
    return fs::exists(folder + "/job.json", failure) || failure == std::errc::permission_denied;
}

bool is_own(const std::string& folder) {
    struct stat status {};
    struct stat link {};
    return ::stat(folder.c_str(), &status) == 0 && ::lstat(folder.c_str(), &link) == 0 &&
           status.st_uid == ::geteuid() && link.st_uid == ::geteuid();
}

std::string job_id(const std::string& folder) {
    constexpr std::size_t kHash = 6;  // digits, as make_job_folder takes them
    const std::string name = fs::path(folder).filename().string();
    const std::size_t dash = name.rfind('-');
    const bool is_usual = dash != std::string::npos && dash > kHash + 1 && dash + 1 < name.size() &&
                          name[dash - kHash - 1] == '-' &&
                          name.find_first_not_of("0123456789", dash + 1) == std::string::npos &&
                          name.find_first_not_of("0123456789abcdef", dash - kHash) == dash;
    return is_usual ? name.substr(dash - kHash) : name;
}

std::string bake_path(const FarmJob& job) {
    return job.folder + "/" + job.name + ".bake";
}

std::string sequence_path(const FarmJob& job) {
    return job.folder + "/" + job.name + ".yaml";
}

std::string part_folder_name(std::size_t part) {
    return fmt::format("{}{}", kPartFolder, part + 1);
}

std::vector<std::string> job_folders(const std::string& store) {
    std::vector<std::pair<fs::file_time_type, std::string>> found;
    std::error_code ignored;
    for (fs::directory_iterator entry(farm_folder(store), ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        const fs::path folder = entry->path();
        std::error_code unknown;
        if (is_job_folder(folder.string())) {
            found.emplace_back(fs::last_write_time(folder / "job.json", unknown), folder.string());
        }
    }
    std::sort(found.begin(), found.end(), std::greater<>());
    std::vector<std::string> folders;
    folders.reserve(found.size());
    for (const auto& [time, folder] : found) {
        folders.push_back(folder);
    }
    return folders;
}

void make_store(const std::string& store, Readers readers) {
    const fs::path path = fs::path(store) / "";  // ends in "/", also if the store's name does
    pipeline::create_folder(path.parent_path().parent_path().string());
    (void)make_folder(path.parent_path().string(), readers);
}

std::string make_job_folder(const std::string& store, const std::string& film, Readers readers) {
    const std::string farm = farm_folder(store);
    pipeline::create_folder(farm);
    keep_entries_of_owners(store);
    keep_entries_of_owners(farm);
    const Hash128 hash = hash_bytes(std::as_bytes(std::span(film)));
    const std::string name = name_of_film(film) + "-" + hash.to_string().substr(0, 6);
    for (int number = 1; number <= kMostJobs; ++number) {
        std::string folder = fmt::format("{}/{}-{}", farm, name, number);
        if (make_folder(folder, readers)) {
            pipeline::create_folder(folder + "/logs");
            pipeline::create_folder(folder + "/workers");
            return folder;
        }
    }
    throw Error("'" + farm + "' has too many jobs of this film; remove the old ones");
}

void let_readers_read(const std::string& folder) {
    constexpr mode_t kReading = 055;
    struct stat status {};
    if (::stat(folder.c_str(), &status) == 0) {
        ::umask(::umask(0) & ~(status.st_mode & kReading));
    }
}

void write_end(const FarmJob& job, const JobEnd& end) {
    JsonMembers members;
    members.add("state", end.state)
        .add("message", end.message)
        .add("frames", end.frames)
        .add("skipped", end.skipped);
    write_record(job.folder + "/end.json", members);
}

void remove_end(const FarmJob& job) {
    std::error_code ignored;
    fs::remove(job.folder + "/end.json", ignored);
}

std::optional<JobEnd> read_end(const FarmJob& job) {
    const std::optional<Record> record = Record::read(job.folder + "/end.json");
    return record ? std::optional(JobEnd{record->text("state"), record->text("message"),
                                         record->integer("frames"), record->integer("skipped")})
                  : std::nullopt;
}

}  // namespace carom::farm
