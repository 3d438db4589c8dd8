// The bake of a shot, kept under its physics hash.
#include <algorithm>
#include <filesystem>

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

std::string bake_path(const std::string& cache_folder, const Hash128& physics_hash) {
    const std::string cache = cache_folder.empty() ? default_cache_folder() : cache_folder;
    return cache + "/bakes/" + physics_hash.to_string() + ".bake";
}

std::optional<sim::Bake> read_kept(const std::string& path, const Hash128& physics_hash,
                                   const JobObserver& observer) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        return std::nullopt;
    }
    try {
        sim::Bake bake = sim::read_bake(path);
        if (bake.physics_hash == physics_hash) {
            mark_used(path);
            return bake;
        }
        warn(observer, "'" + path + "' is the bake of another shot; baking again");
    } catch (const Error& error) {
        warn(observer, std::string("the kept bake cannot be used, baking again: ") + error.what());
    }
    return std::nullopt;
}

void keep(const sim::Bake& bake, const std::string& path) {
    std::error_code failure;
    fs::create_directories(fs::path(path).parent_path(), failure);
    if (failure) {
        throw Error("'" + fs::path(path).parent_path().string() +
                    "': the folder cannot be made: " + failure.message());
    }
    sim::write_bake(bake, path);
}

// Without the keyed motions, as it is kept.
sim::Bake simulate(const Shot& shot, const WorkContext& context) {
    return {sim::bake(shot.world, context), sim::physics_hash(shot.world), shot.resolved_text,
            shot.assets};
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

sim::Bake bake_shot(const Shot& shot, const WorkContext& context) {
    sim::Bake bake = simulate(shot, context);
    add_keyed_motions(bake, shot);
    return bake;
}

std::optional<sim::Bake> find_kept_bake(const Shot& shot, const std::string& cache_folder,
                                        const JobObserver& observer) {
    const Hash128 physics_hash = sim::physics_hash(shot.world);
    std::optional<sim::Bake> kept =
        read_kept(bake_path(cache_folder, physics_hash), physics_hash, observer);
    if (kept) {
        // Shots that differ in their look alone share a bake.
        kept->shot_text = shot.resolved_text;
        kept->assets = shot.assets;
        add_keyed_motions(*kept, shot);
    }
    return kept;
}

BakedShot bake_or_reuse(const Shot& shot, const std::string& cache_folder,
                        const JobObserver& observer, const std::stop_token& stop) {
    const Hash128 physics_hash = sim::physics_hash(shot.world);
    std::error_code ignored;
    const bool is_there = fs::exists(bake_path(cache_folder, physics_hash), ignored);
    if (std::optional<sim::Bake> kept = find_kept_bake(shot, cache_folder, observer)) {
        return {std::move(*kept), BakeOrigin::kept};
    }
    WorkContext context;
    context.stop = stop;
    if (observer.on_progress) {
        context.progress = [&observer](double fraction) { observer.on_progress("bake", fraction); };
    }
    sim::Bake bake = simulate(shot, context);
    try {
        keep(bake, bake_path(cache_folder, physics_hash));
    } catch (const Error& error) {
        warn(observer, std::string("the bake is not kept for next time: ") + error.what());
    }
    add_keyed_motions(bake, shot);
    return {std::move(bake), is_there ? BakeOrigin::replaced : BakeOrigin::made};
}

}  // namespace carom::pipeline
