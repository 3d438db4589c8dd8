// Options that several commands share.
#pragma once

#include <string>

#include "pipeline/cli/command_description.h"
#include "pipeline/cli/commands.h"

namespace carom::cli {

/// The argument SHOT|BAKE.
void add_input(CommandDescription& description, InputOptions& input);
/// --set, --quality and --root.
void add_changes(CommandDescription& description, InputOptions& input);
void add_camera_file(CommandDescription& description, InputOptions& input);
void add_cache(CommandDescription& description, CacheOptions& cache);
/// --no-store.
void add_no_store(CommandDescription& description, CacheOptions& cache);
void add_cache_size(CommandDescription& description, CacheOptions& cache);
void add_frames(CommandDescription& description, std::string& frames);
void add_dry_run(CommandDescription& description, bool& dry_run);
/// --tier, which chose the vector instructions of frames while frames depended on them.
void add_tier(CommandDescription& description);
/// --port, --no-browser and --idle.
void add_page(CommandDescription& description, PageOptions& page);
void add_threads(CommandDescription& description, int& threads);
void add_output(CommandDescription& description, std::string& output, const char* help);
void add_drawing(CommandDescription& description, DrawingOptions& drawing);
/// --speed, --from, --to, --reverse, --ramp, --easing and --rig.
void add_retime_words(CommandDescription& description, RetimeWords& words);

}  // namespace carom::cli
