// The scripts of a job's folder, which run its stages.
#pragma once

#include <string>

#include "pipeline/farm/farm_job.h"

namespace carom::farm {

/// Lines of a portable script that go to its folder, also in a copy of the script, as Slurm and PBS
/// run it: Slurm in the job's folder (--chdir), PBS elsewhere.
inline constexpr const char* kGoToFolder =
    "folder=$(dirname -- \"$0\")\n"
    "[ -f \"$folder/job.json\" ] || folder=${PBS_O_WORKDIR:-.}\n"
    "cd -- \"$folder\" || exit 1\n";

/// Writes the scripts of all stages into the job's folder. They run this program, `carom`, again.
/// Throws Error.
void write_scripts(const FarmJob& job, const std::string& carom);

/// The same for a folder that may be copied: the scripts run $CAROM.
void write_portable_scripts(const FarmJob& job);

/// Writes a script that can be run into the job's folder. Throws Error.
void write_script(const FarmJob& job, const std::string& name, const std::string& text);

}  // namespace carom::farm
