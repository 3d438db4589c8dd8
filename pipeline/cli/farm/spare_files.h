// Copies of a job's own files, in case that one is damaged.
//   FOLDER/spare/   has the bakes and the file of a film of several shots under the same names
#pragma once

#include "pipeline/farm/farm_job.h"

namespace carom::cli {

/// Copies the files of the job's folder. Throws Error.
void write_spare_files(const farm::FarmJob& job);

/// How a job's own files are: as they should be, so again after copies took their places, or
/// damaged or missing like a copy.
enum class OwnFiles { intact, restored, damaged };

/// Puts copies that are intact where the job's files have other contents or are missing: only those
/// that a job has, and none through a link. To be called by the owner of the folder, which others
/// could change meanwhile. Throws Error if a file or folder cannot be read or written to.
[[nodiscard]] OwnFiles restore_files(const farm::FarmJob& job);

}  // namespace carom::cli
