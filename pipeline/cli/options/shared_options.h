// What commands' options have in common. For the .cpp files of this folder only.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "pipeline/cli/options/targets.h"

namespace carom::cli {

[[nodiscard]] std::string example(const char* lines);

void add_input(CLI::App& app, InputOptions& input, const char* name, const char* what);
/// `--set` and `--quality`.
void add_changes(CLI::App& app, InputOptions& input);
void add_camera_file(CLI::App& app, InputOptions& input);
void add_talk(CLI::App& app, Targets& targets);
void add_cache(CLI::App& app, CacheOptions& cache);
void add_cache_size(CLI::App& app, CacheOptions& cache);
void add_frames(CLI::App& app, std::string& frames);
void add_dry_run(CLI::App& app, bool& dry_run);
void add_threads(CLI::App& app, int& threads);
void add_output(CLI::App& app, std::string& output, const char* what);
void add_drawing(CLI::App& app, DrawingOptions& drawing);

}  // namespace carom::cli
