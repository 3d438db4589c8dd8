// The bake of a shot, simulated or read from the cache, where its physics hash is its name.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <fmt/core.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/claims.h"
#include "pipeline/store/wait_notice.h"
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
    return bake_file(cache, physics_hash);
}

enum class Use { marked, not_marked };  // in the time of the file

/// What the cache has of a shot.
struct CachedBake {
    std::optional<sim::Bake> bake;
    BakeOrigin origin = BakeOrigin::simulated;  // of the bake, or of one that is made in its place
};

CachedBake read_cached(const std::string& path, const Hash128& physics_hash, Use use,
                       const JobObserver& observer) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        return {};
    }
    try {
        sim::Bake bake = sim::read_bake(path);
        if (bake.physics_hash == physics_hash) {
            if (use == Use::marked) {
                mark_used(path);
            }
            return {std::move(bake), BakeOrigin::cached};
        }
        warn(observer, "'" + path + "' is the bake of another shot; this shot is simulated again");
    } catch (const sim::OtherBakeVersion&) {
        return {std::nullopt, BakeOrigin::outdated};
    } catch (const Error& error) {
        warn(observer, std::string("the cached bake cannot be used, so the shot is simulated "
                                   "again: ") +
                           error.what());
    }
    return {std::nullopt, BakeOrigin::replaced};
}

void save(const sim::Bake& bake, const std::string& path) {
    create_folder(fs::path(path).parent_path().string());
    write_file_atomically(path, sim::encode_bake(bake), FileAccess::of_folder);
}

// The bake as the cache stores it: without the keyed motions.
sim::Bake simulate(const Shot& shot, const WorkContext& context) {
    return {sim::bake(shot.world, context), sim::physics_hash(shot.world), shot.resolved_text,
            shot.assets};
}

}  // namespace

void add_keyed_motions(sim::Bake& bake, const Shot& shot) {
    std::vector<sim::Track>& tracks = bake.timeline.tracks;
    const auto add = [&](const sim::Track& track) {
        const auto known = std::ranges::find(tracks, track.name(), &sim::Track::name);
        if (known != tracks.end()) {
            *known = track;
        } else {
            tracks.push_back(track);
        }
    };
    std::ranges::for_each(shot.keyed, add);
    if (!shot.stick.events.empty()) {
        add(stick_motion(shot.stick, shot.world, bake.timeline));
    }
}

sim::Bake bake_shot(const Shot& shot, const WorkContext& context) {
    sim::Bake bake = simulate(shot, context);
    add_keyed_motions(bake, shot);
    return bake;
}

namespace {

CachedBake find_bake(const Shot& shot, const std::string& cache_folder, Use use,
                     const JobObserver& observer) {
    const Hash128 physics_hash = sim::physics_hash(shot.world);
    CachedBake cached =
        read_cached(bake_path(cache_folder, physics_hash), physics_hash, use, observer);
    if (cached.bake) {
        // Shots that differ only in their look share a bake.
        cached.bake->shot_text = shot.resolved_text;
        cached.bake->assets = shot.assets;
        add_keyed_motions(*cached.bake, shot);
    }
    return cached;
}

/// Of a simulation, which reports its progress.
WorkContext context_of(const JobObserver& observer, const std::stop_token& stop) {
    WorkContext context;
    context.stop = stop;
    if (observer.on_progress) {
        context.progress = [&observer](double fraction) { observer.on_progress("bake", fraction); };
    }
    return context;
}

constexpr std::chrono::milliseconds kPollInterval{100};

/// Waits while another process, perhaps on another machine, simulates the same world. Returns the
/// claim to do it now, or nothing if the bake is there, or if the cache cannot be written to.
std::optional<Claim> claim_bake(Claims& claims, const Hash128& physics_hash,
                                const std::string& path, const JobObserver& observer,
                                const std::stop_token& stop) {
    const std::string name = physics_hash.to_string();
    WaitNotice wait;
    while (true) {
        if (stop.stop_requested()) {
            throw Stopped();
        }
        try {
            std::optional<Claim> claim = claims.claim(name);
            std::error_code ignored;
            if (claim || fs::exists(path, ignored)) {
                return claim;
            }
            if (const std::optional<std::string> waited = wait.due()) {
                warn(observer, fmt::format("waiting for {} for the simulation of this shot: {}",
                                           *waited, claims.holder(name)));
            }
        } catch (const Error&) {
            return std::nullopt;
        }
        std::this_thread::sleep_for(kPollInterval);
    }
}

}  // namespace

std::optional<sim::Bake> find_cached_bake(const Shot& shot, const std::string& cache_folder,
                                          const JobObserver& observer) {
    return find_bake(shot, cache_folder, Use::marked, observer).bake;
}

BakedShot bake_without_store(const Shot& shot, const std::string& cache_folder,
                             const JobObserver& observer, const std::stop_token& stop) {
    const std::string folder = readable_cache_folder(cache_folder);
    CachedBake cached = find_bake(shot, folder, Use::not_marked, observer);
    if (cached.bake) {
        return {std::move(*cached.bake), cached.origin};
    }
    return {bake_shot(shot, context_of(observer, stop)), cached.origin};
}

BakedShot bake_or_reuse(const Shot& shot, const std::string& cache_folder,
                        const JobObserver& observer, const std::stop_token& stop) {
    const Hash128 physics_hash = sim::physics_hash(shot.world);
    CachedBake cached = find_bake(shot, cache_folder, Use::marked, observer);
    if (cached.bake) {
        return {std::move(*cached.bake), cached.origin};
    }
    const std::string path = bake_path(cache_folder, physics_hash);
    Claims claims(fs::path(path).parent_path().parent_path().string() + "/locks");
    const std::optional<Claim> claim = claim_bake(claims, physics_hash, path, observer, stop);
    std::error_code ignored;
    if (cached.origin == BakeOrigin::simulated && fs::exists(path, ignored)) {
        // Another process has made it meanwhile.
        if (std::optional<sim::Bake> made = find_cached_bake(shot, cache_folder, observer)) {
            return {std::move(*made), BakeOrigin::cached};
        }
    }
    sim::Bake bake = simulate(shot, context_of(observer, stop));
    try {
        save(bake, path);
    } catch (const Error& error) {
        warn(observer, std::string("the bake cannot be saved in the cache: ") + error.what());
    }
    add_keyed_motions(bake, shot);
    return {std::move(bake), cached.origin};
}

}  // namespace carom::pipeline
