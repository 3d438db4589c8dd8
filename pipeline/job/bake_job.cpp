// The bake of a shot, kept under its physics hash.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/cache_folder.h"
#include "sim/bake.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

void warn(const JobObserver& observer, const std::string& message) {
    if (observer.on_warning) {
        observer.on_warning(message);
    }
}

// What the simulation warned of is kept beside the bake, so that it is heard again: one line each,
// the sentence and, after a tab, the number of the event.
std::string warnings_path(const std::string& bake_path) {
    return bake_path + ".warnings";
}

std::string bake_path(const std::string& cache_folder, const Hash128& physics_hash) {
    const std::string cache = cache_folder.empty() ? default_cache_folder() : cache_folder;
    return cache + "/bakes/" + physics_hash.to_string() + ".bake";
}

SimulationWarning warning_of(const std::string& line) {
    const std::size_t tab = line.find('\t');
    SimulationWarning warning{line.substr(0, tab), -1};
    if (tab != std::string::npos) {
        std::from_chars(line.data() + tab + 1, line.data() + line.size(), warning.event);
    }
    return warning;
}

std::string line_of(const SimulationWarning& warning) {
    return warning.sentence + (warning.event < 0 ? "" : "\t" + std::to_string(warning.event)) +
           "\n";
}

std::vector<SimulationWarning> warnings_of(const sim::BakeResult& result) {
    std::vector<SimulationWarning> warnings;
    for (std::size_t i = 0; i < result.warnings.size(); ++i) {
        warnings.push_back({result.warnings[i], result.warned_events[i]});
    }
    return warnings;
}

std::optional<sim::Bake> read_kept(const std::string& path, const Hash128& physics_hash,
                                   const JobObserver& observer,
                                   std::vector<SimulationWarning>& warnings) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        return std::nullopt;
    }
    try {
        sim::Bake bake = sim::read_bake(path);
        if (bake.physics_hash == physics_hash) {
            mark_used(path);
            std::ifstream kept(warnings_path(path));
            for (std::string line; std::getline(kept, line);) {
                warnings.push_back(warning_of(line));
            }
            return bake;
        }
        warn(observer, "'" + path + "' is the bake of another shot; baking again");
    } catch (const Error& error) {
        warn(observer, std::string("the kept bake cannot be used, baking again: ") + error.what());
    }
    return std::nullopt;
}

void keep(const sim::Bake& bake, const std::vector<SimulationWarning>& warnings,
          const std::string& path) {
    std::error_code failure;
    fs::create_directories(fs::path(path).parent_path(), failure);
    if (failure) {
        throw Error("'" + fs::path(path).parent_path().string() +
                    "': the folder cannot be made: " + failure.message());
    }
    std::string lines;
    for (const SimulationWarning& warning : warnings) {
        lines += line_of(warning);
    }
    // First, so that a bake is never without its warnings.
    write_file_atomically(warnings_path(path), std::as_bytes(std::span<const char>(lines)));
    sim::write_bake(bake, path);
}

}  // namespace

void add_keyed_motions(sim::Bake& bake, const Shot& shot) {
    std::vector<sim::Track>& tracks = bake.timeline.tracks;
    for (const sim::Track& keyed : shot.keyed) {
        const auto known = std::ranges::find(tracks, keyed.name(), &sim::Track::name);
        if (known != tracks.end()) {
            *known = keyed;
        } else {
            tracks.push_back(keyed);
        }
    }
}

std::optional<sim::Bake> find_kept_bake(const Shot& shot, const std::string& cache_folder,
                                        const JobObserver& observer,
                                        std::vector<SimulationWarning>& warnings) {
    const Hash128 physics_hash = sim::physics_hash(shot.world);
    std::optional<sim::Bake> kept =
        read_kept(bake_path(cache_folder, physics_hash), physics_hash, observer, warnings);
    if (kept) {
        // Shots that differ in their look alone share a bake.
        kept->shot_text = shot.resolved_text;
        kept->assets = shot.assets;
        add_keyed_motions(*kept, shot);
    }
    return kept;
}

sim::Bake bake_or_reuse(const Shot& shot, const std::string& cache_folder,
                        const JobObserver& observer, const std::stop_token& stop,
                        BakeOrigin* origin, std::vector<SimulationWarning>* warnings) {
    std::vector<SimulationWarning> heard;
    const auto tell = [&] {
        if (warnings != nullptr) {
            *warnings = heard;
            return;
        }
        for (const SimulationWarning& warning : heard) {
            warn(observer, warning.sentence);
        }
    };
    const Hash128 physics_hash = sim::physics_hash(shot.world);
    std::error_code ignored;
    const bool is_there = fs::exists(bake_path(cache_folder, physics_hash), ignored);
    std::optional<sim::Bake> kept = find_kept_bake(shot, cache_folder, observer, heard);
    if (origin != nullptr) {
        *origin = kept ? BakeOrigin::kept : is_there ? BakeOrigin::replaced : BakeOrigin::made;
    }
    if (kept) {
        tell();
        return std::move(*kept);
    }
    WorkContext context;
    context.stop = stop;
    if (observer.on_progress) {
        context.progress = [&observer](double share) { observer.on_progress("bake", share); };
    }
    sim::BakeResult result = sim::bake(shot.world, context);
    heard = warnings_of(result);
    tell();
    sim::Bake bake{std::move(result.timeline), physics_hash, shot.resolved_text, shot.assets};
    try {
        keep(bake, heard, bake_path(cache_folder, physics_hash));
    } catch (const Error& error) {
        warn(observer, std::string("the bake is not kept for next time: ") + error.what());
    }
    add_keyed_motions(bake, shot);
    return bake;
}

}  // namespace carom::pipeline
