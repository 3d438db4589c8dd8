// The files with which engines run an exported job.
#pragma once

#include <string>
#include <vector>

#include "pipeline/farm/farm_job.h"

namespace carom::farm {

struct EngineFile {
    std::string name;  // in the job's folder
    std::string text;
    bool is_script = false;
};

struct EngineFiles {
    std::vector<EngineFile> files;
    std::string start;     // the file with which the job begins
    std::string sentence;  // how it is started, for the README: "`./run.sh`"
    std::string note;      // what else the engine needs; empty: nothing
};

/// The files for the job's engine: slurm, parallel, k8s, openjd or pbs.
[[nodiscard]] EngineFiles engine_files(const FarmJob& job);

/// Writes one of them into the job's folder. Throws Error.
void write_engine_file(const FarmJob& job, const EngineFile& file);

/// A recipe for a container with carom's Debian package.
[[nodiscard]] EngineFile container_file();

}  // namespace carom::farm
