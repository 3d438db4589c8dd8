#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <optional>

#include <fmt/core.h>

#include "core/json_text.h"
#include "core/text.h"
#include "pipeline/cli/cache_copies.h"
#include "pipeline/cli/duration_text.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/store/reservations.h"

namespace carom::cli {

namespace {

using pipeline::CacheEntry;
using Clock = std::chrono::system_clock;

std::string folder_of(const CacheOptions& cache) {
    return cache.folder.empty() ? pipeline::default_cache_folder() : cache.folder;
}

std::uint64_t limit_of(const CacheOptions& cache) {
    try {
        return pipeline::cache_size_limit(cache.size);
    } catch (const Error& error) {
        throw InputError(error.what());
    }
}

/// A time in the local time zone.
std::string date_text(Clock::time_point time) {
    const std::time_t seconds = Clock::to_time_t(time);
    std::tm local{};
    ::localtime_r(&seconds, &local);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local);
    return text.data();
}

struct Total {
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;
    std::optional<Clock::time_point> oldest, newest;  // times of last use
};

Total total_of(const std::vector<CacheEntry>& entries, CacheEntry::Kind kind) {
    Total total;
    for (const CacheEntry& entry : entries) {
        if (entry.kind == kind) {
            ++total.count;
            total.bytes += entry.bytes;
            total.oldest = total.oldest.value_or(entry.last_used);
            total.newest = entry.last_used;
        }
    }
    return total;
}

std::string total_text(const std::vector<CacheEntry>& entries, CacheEntry::Kind kind,
                       const char* noun) {
    const Total total = total_of(entries, kind);
    std::string text = counted(total.count, noun) + ", " + pipeline::size_text(total.bytes);
    if (total.count > 0) {
        text += ", used between " + date_text(*total.oldest) + " and " + date_text(*total.newest);
    }
    return text + "\n";
}

const char* name_of(CacheEntry::Kind kind) {
    switch (kind) {
        case CacheEntry::Kind::frame:
            return "frame";
        case CacheEntry::Kind::sums:
            return "stopped frame";
        case CacheEntry::Kind::noisy:
            return "noisy frame";
        case CacheEntry::Kind::answer:
            return "answer";
        case CacheEntry::Kind::light:
            return "light of a room";
        case CacheEntry::Kind::bake:
            break;
    }
    return "bake";
}

std::string entry_json(const CacheEntry& entry) {
    JsonMembers members;
    members.add("kind", name_of(entry.kind))
        .add("path", entry.path)
        .add("bytes", static_cast<std::int64_t>(entry.bytes))
        .add("last_used",
             std::chrono::duration<double>(entry.last_used.time_since_epoch()).count());
    return members.object() + "\n";
}

std::string reservation_json(const pipeline::Reservation& reservation) {
    JsonMembers members;
    members.add("kind", "reservation")
        .add("owner", reservation.owner)
        .add("files", static_cast<std::int64_t>(reservation.files))
        .add("bytes", static_cast<std::int64_t>(reservation.bytes));
    return members.object() + "\n";
}

std::string reservations_text(const std::vector<pipeline::Reservation>& reservations) {
    std::uint64_t bytes = 0;
    std::string lines;
    for (const pipeline::Reservation& reservation : reservations) {
        bytes += reservation.bytes;
        lines += "  " + reservation.owner + ": " + counted(reservation.files, "file") + ", " +
                 pipeline::size_text(reservation.bytes) + "\n";
    }
    return "reserved for running jobs: " + pipeline::size_text(bytes) + "\n" + lines;
}

void list(const CacheCommand& command) {
    const std::string folder = folder_of(command.cache);
    const std::vector<CacheEntry> entries = pipeline::list_cache(folder);
    const std::vector<pipeline::Reservation> reservations = pipeline::list_reservations(folder);
    std::string text;
    if (command.json) {
        for (const CacheEntry& entry : entries) {
            text += entry_json(entry);
        }
        for (const pipeline::Reservation& reservation : reservations) {
            text += reservation_json(reservation);
        }
    } else {
        text = folder + ": limit " + pipeline::size_text(limit_of(command.cache)) + "\n" +
               total_text(entries, CacheEntry::Kind::frame, "frame") +
               total_text(entries, CacheEntry::Kind::bake, "bake");
        if (total_of(entries, CacheEntry::Kind::sums).count > 0) {
            text += total_text(entries, CacheEntry::Kind::sums, "stopped frame");
        }
        if (total_of(entries, CacheEntry::Kind::noisy).count > 0) {
            text += total_text(entries, CacheEntry::Kind::noisy, "noisy frame");
        }
        if (total_of(entries, CacheEntry::Kind::answer).count > 0) {
            text += total_text(entries, CacheEntry::Kind::answer, "answer");
        }
        if (const Total total = total_of(entries, CacheEntry::Kind::light); total.count > 0) {
            text += "lights of rooms: " + std::to_string(total.count) + ", " +
                    pipeline::size_text(total.bytes) + "\n";
        }
        text += reservations_text(reservations);
    }
    print_text(text);
}

void prune(const CacheCommand& command, CommandContext& context) {
    pipeline::PruneOptions options;
    if (command.features) {
        options.only_noisy = true;
        options.limit = command.unused_for.empty() ? 0 : pipeline::kNoLimit;
    } else {
        options.limit = command.all ? 0 : limit_of(command.cache);
    }
    if (!command.unused_for.empty()) {
        options.remove_before = Clock::now() - std::chrono::duration_cast<Clock::duration>(
                                                   parse_duration(command.unused_for));
    }
    options.dry_run = command.dry_run;
    const std::string folder = folder_of(command.cache);
    const pipeline::PruneResult result = pipeline::prune_cache(folder, options);
    context.console.info(
        std::string(command.dry_run ? "would remove " : "removed ") +
        counted(result.removed, "file") + " (" + pipeline::size_text(result.removed_bytes) + "); " +
        counted(result.kept, "file") + " (" + pipeline::size_text(result.kept_bytes) + ") " +
        (result.kept == 1 ? "stays" : "stay") + " in '" + folder + "'");
}

void verify(const CacheCommand& command, CommandContext& context) {
    const std::string folder = folder_of(command.cache);
    const pipeline::VerifyResult result = pipeline::verify_cache(folder, {}, context.stop);
    for (const CacheEntry& entry : result.damaged) {
        print_path(entry.path);
        if (!command.keep && !pipeline::remove_entry(entry)) {
            context.console.warning("the damaged file '" + entry.path + "' cannot be removed");
        }
    }
    for (const CacheEntry& entry : result.unreadable) {
        errno = EACCES;
        context.console.warning(pipeline::system_problem(entry.path, "it cannot be checked"));
    }
    if (!result.damaged.empty()) {
        const bool is_one = result.damaged.size() == 1;
        throw Error(
            fmt::format("{} of {} in '{}' {} damaged{}", result.damaged.size(),
                        counted(result.checked, "file"), folder, is_one ? "is" : "are",
                        command.keep ? ""
                        : is_one     ? " and was removed; it is made again when it is needed"
                                 : " and were removed; they are made again when they are needed"));
    }
    if (!result.unreadable.empty()) {
        throw Error(fmt::format("{} of {} in '{}' cannot be checked; none of the others is damaged",
                                result.unreadable.size(), counted(result.checked, "file"), folder));
    }
    context.console.info("checked " + counted(result.checked, "file") + " in '" + folder +
                         "': none is damaged");
}

}  // namespace

void run(const CacheCommand& command, CommandContext& context) {
    switch (command.action) {
        case CacheCommand::Action::list:
            list(command);
            break;
        case CacheCommand::Action::prune:
            prune(command, context);
            break;
        case CacheCommand::Action::verify:
            verify(command, context);
            break;
        case CacheCommand::Action::push:
        case CacheCommand::Action::pull:
        case CacheCommand::Action::merge:
            copy_between_caches(command, {}, context);
            break;
    }
}

}  // namespace carom::cli
