// A job of the farm: what its folder says, which is all that its workers need.
//   FOLDER/job.json      this file
//   FOLDER/NAME.bake     the motion, with the shot's text; NAME is the shot's, which films tell
//   FOLDER/NAME.yaml     of a film of several shots instead, with FOLDER/part-1/SHOT.bake and so on
//   FOLDER/spare/        copies of these, in case that they are damaged
//   FOLDER/workers/      what each worker does now, and its frames (frame_record.h)
//   FOLDER/logs/         what the tasks print
//   FOLDER/locks/        the claim on writing the film
//   FOLDER/round.json    numbers of the tasks in the queue, and what was learned (round.h)
//   FOLDER/wishes.json   which frames come first, again or not at all (wishes.h)
//   FOLDER/end.json      how the job ended
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carom::farm {

struct FarmJob {
    std::string folder;        // absolute; not in the file
    std::string film;          // absolute
    std::string shot;          // as it was given, for people
    std::string name;          // of the shot, or of the film of several
    std::string store;         // the cache of bakes and frames that all workers share, absolute
    std::string root;          // the folder in which the shot's files must lie; empty: anywhere
    std::string frames;        // "0-47x2"; empty: all
    std::int64_t workers = 1;  // tasks of the array
    std::int64_t tasks_at_once = 0;  // of them; 0: as many as the cluster has room for
    std::int64_t processors = 1;     // of each
    std::int64_t memory = 0;         // of each, MB
    std::int64_t frame_bytes = 0;    // that a frame is expected to take in the store
    double budget = 600;             // of each, seconds
    double dead_after = 30;          // seconds without a heartbeat
    std::string partition;           // of the engine; empty: its default
    std::string account;
    std::int64_t priority = 0;                // among the jobs of the engine, higher is sooner
    std::int64_t time = 0;                    // the first limit of a worker, minutes
    std::int64_t film_time = 0;               // and of the task that writes the film
    std::vector<std::string> engine_options;  // words for the engine's own program that submits
    std::string exec_after;                   // a command of the shell when the film is there
    std::string engine = "slurm";             // or what else starts the tasks (engine.h)
    std::int64_t film_mask = -1;              // the film's (umask); -1: that of its process
    bool is_sequence = false;                 // a film of several shots
    bool is_portable = false;  // the folder may be copied: its scripts and paths are relative
    std::string id;            // of such a job, which tells it from others of its film

    bool operator==(const FarmJob&) const = default;
};

/// Writes job.json. Throws Error.
void write_job(const FarmJob& job);

/// Reads the job of a folder. Throws Error that names the file and what is wrong with it.
[[nodiscard]] FarmJob read_job(const std::string& folder);

/// Also of a folder that may not be looked into: read_job says so then.
[[nodiscard]] bool is_job_folder(const std::string& folder);

/// Whether the folder is this user's, and no other user's link to it.
[[nodiscard]] bool is_own(const std::string& folder);

/// The end of the folder's name that tells the jobs of a store apart: "1f3a5b-2"; of a folder with
/// another kind of name all of it.
[[nodiscard]] std::string job_id(const std::string& folder);

[[nodiscard]] std::string bake_path(const FarmJob& job);
/// Of a film of several shots: the film's file, and the folder beside it that has the bake of a
/// part, by its index from 0.
[[nodiscard]] std::string sequence_path(const FarmJob& job);
inline constexpr const char* kPartFolder = "part-";  // and a number from 1
[[nodiscard]] std::string part_folder_name(std::size_t part);

/// The folders of all jobs of a store, the newest first.
[[nodiscard]] std::vector<std::string> job_folders(const std::string& store);

/// Who may read a folder besides its owner.
enum class Readers { none, group, all };

/// Makes the store's folder if it does not exist. Throws Error.
void make_store(const std::string& store, Readers readers);

/// Makes a new folder for a job that makes this film. What is made in it is of its group, if it is
/// for the group. The mask of the process (umask) changes neither folder. Throws Error.
[[nodiscard]] std::string make_job_folder(const std::string& store, const std::string& film,
                                          Readers readers);

/// Lets those read what this process and its tasks make who may read the job's folder, whatever the
/// user's mask is. Slurm gives the mask of the process that submits to the tasks.
void let_readers_read(const std::string& folder);

/// How a job ended.
struct JobEnd {
    std::string state;  // "complete", "stopped", "failed"
    std::string message;
    std::int64_t frames = 0;   // of the film; 0: not known
    std::int64_t skipped = 0;  // of these, others stand in for them
};
void write_end(const FarmJob& job, const JobEnd& end);
void remove_end(const FarmJob& job);
[[nodiscard]] std::optional<JobEnd> read_end(const FarmJob& job);

}  // namespace carom::farm
