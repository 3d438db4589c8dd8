// The table of options, command by command.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's
class App;
}

namespace carom::cli {

struct Targets;

/// Each adds its command; parsing fills `targets`, which outlives the app.
void add_render(CLI::App& app, Targets& targets);
void add_retime(CLI::App& app, Targets& targets);
void add_frame(CLI::App& app, Targets& targets);
void add_contact_sheet(CLI::App& app, Targets& targets);
void add_mux(CLI::App& app, Targets& targets);
void add_compare(CLI::App& app, Targets& targets);

void add_bake(CLI::App& app, Targets& targets);
void add_check(CLI::App& app, Targets& targets);
void add_info(CLI::App& app, Targets& targets);
void add_export(CLI::App& app, Targets& targets);
void add_report(CLI::App& app, Targets& targets);
void add_plan(CLI::App& app, Targets& targets);

void add_new(CLI::App& app, Targets& targets);
void add_schema(CLI::App& app, Targets& targets);
void add_import(CLI::App& app, Targets& targets);
void add_import_track(CLI::App& app, Targets& targets);
void add_cache_actions(CLI::App& app, Targets& targets);
void add_completion(CLI::App& app, Targets& targets);
void add_manual(CLI::App& app, Targets& targets);

}  // namespace carom::cli
