// The files that a shot names (meshes, pictures), copied beside its bake.
#pragma once

#include <string>

#include "pipeline/cli/shot_input.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

/// Copies all files of the shot into `folder`/files and makes the bake's text and assets name the
/// copies, relative to `folder`, where the bake is to be written. The copies have the names of the
/// files; a number is added where two files have the same name. Throws Error if a file cannot be
/// copied, or has changed since the shot was read.
void copy_files(const pipeline::Shot& shot, const pipeline::ShotSource& source, sim::Bake& bake,
                const std::string& folder);

}  // namespace carom::cli
