#include "pipeline/cli/cache_copies.h"

#include <vector>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/transfer/cache_transfer.h"

namespace carom::cli {

namespace {

using transfer::TransferOptions;
using transfer::TransferResult;

TransferOptions options_of(const CacheCommand& command,
                           const std::optional<std::set<Hash128>>& keys) {
    TransferOptions options;
    const std::string& given = command.cache.folder;
    options.cache_folder = given.empty() ? pipeline::default_cache_folder() : given;
    options.place = command.place;
    options.keys = keys;
    options.dry_run = command.dry_run;
    try {
        options.cache_limit = pipeline::cache_size_limit(command.cache.size);
    } catch (const Error& error) {
        throw InputError(error.what());
    }
    return options;
}

void refuse_options_of_a_shot(const CacheCommand& command) {
    const InputOptions& input = command.input;
    if (input.path.empty() && (!input.overrides.empty() || !input.quality.empty() ||
                               !input.camera_file.empty() || !command.frames.empty())) {
        throw InputError("--set, --quality, --camera and --frames belong to a shot; name it, too");
    }
}

/// "6 frames and 1 bake copied, 2 were there"
std::string counts_text(const TransferResult& result, bool dry_run) {
    std::string text = fmt::format(
        "{} and {} {}, {} {} there", counted(result.frames, "frame"), counted(result.bakes, "bake"),
        dry_run ? "would be copied" : "copied", result.there, result.there == 1 ? "was" : "were");
    if (result.bytes > 0) {
        text += ", " + pipeline::size_text(result.bytes);
    }
    if (result.missing > 0) {
        text += fmt::format("; {} of this film {} in neither cache",
                            counted(result.missing, "file"), result.missing == 1 ? "is" : "are");
    }
    return text;
}

void add(const TransferResult& from, TransferResult& to) {
    to.frames += from.frames;
    to.bakes += from.bakes;
    to.bytes += from.bytes;
    to.there += from.there;
    to.missing += from.missing;
    to.damaged.insert(to.damaged.end(), from.damaged.begin(), from.damaged.end());
    to.unreadable.insert(to.unreadable.end(), from.unreadable.begin(), from.unreadable.end());
    to.exceeds_limit = from.exceeds_limit;
}

void report(const TransferOptions& options, const TransferResult& result, CommandContext& context) {
    if (result.exceeds_limit) {
        context.console.warning("the cache '" + options.cache_folder + "' has " +
                                pipeline::size_text(*result.exceeds_limit) +
                                ", more than its limit of " +
                                pipeline::size_text(options.cache_limit) +
                                "; the next job will remove what it does not need");
    }
    for (const std::string& path : result.damaged) {
        context.console.warning("'" + path + "' is damaged and was not copied");
    }
    for (const std::string& path : result.unreadable) {
        context.console.warning("'" + path + "' may not be read by you and was not copied");
    }
    context.console.info(counts_text(result, options.dry_run));
    if (!result.damaged.empty()) {
        throw Error(counted(result.damaged.size(), "damaged file") +
                    (result.damaged.size() == 1 ? " was" : " were") +
                    " not copied; 'carom cache verify' removes damaged files where they are");
    }
    if (!result.unreadable.empty()) {
        throw Error(counted(result.unreadable.size(), "file") + " of other users " +
                    (result.unreadable.size() == 1 ? "was" : "were") + " not copied");
    }
}

}  // namespace

void copy_between_caches(const CacheCommand& command, const std::optional<std::set<Hash128>>& keys,
                         CommandContext& context) {
    refuse_options_of_a_shot(command);
    TransferOptions options = options_of(command, keys);
    const bool is_merge = command.action == CacheCommand::Action::merge;
    const std::vector<std::string> places =
        is_merge ? command.folders : std::vector<std::string>{command.place};
    const auto copy =
        command.action == CacheCommand::Action::push ? transfer::push : transfer::pull;
    const pipeline::JobObserver observer = make_console_observer(context.console);
    WorkContext work;
    work.stop = context.stop;
    options.on_wait = observer.on_warning;
    work.progress = [&observer](double fraction) { observer.on_progress("copy", fraction); };
    TransferResult result;
    for (const std::string& place : places) {
        options.place = place;
        add(copy(options, work), result);
    }
    context.console.end_progress();
    report(options, result, context);
}

}  // namespace carom::cli
