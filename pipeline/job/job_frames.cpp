#include "pipeline/job/job_frames.h"

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/store/cache_folder.h"

namespace carom::pipeline {
namespace {

StoreAccess access_of(const FilmJobOptions& options) {
    return options.no_store ? StoreAccess::only_read : StoreAccess::read_and_write;
}

}  // namespace

std::vector<std::int64_t> job_frames(const Shot& shot, const FilmJobOptions& options) {
    const std::int64_t count = frame_count(shot.cameras, shot.timing);
    std::vector<std::int64_t> frames = options.chunk.part_of(options.frames.frames(count));
    if (frames.empty()) {
        throw Error(fmt::format("none of the film's {} frames is selected", count));
    }
    return frames;
}

std::string cache_folder_of(const FilmJobOptions& options) {
    if (options.no_store) {
        return readable_cache_folder(options.cache_folder);
    }
    return options.cache_folder.empty() ? default_cache_folder() : options.cache_folder;
}

std::string frames_folder(const FilmJobOptions& options) {
    return cache_folder_of(options) + "/frames";
}

FrameStore open_store(const FilmJobOptions& options, DamageReport& damages) {
    return FrameStore(
        frames_folder(options),
        [&damages](const std::string& path, const std::string& damage) {
            damages.add(path, damage);
        },
        options.claim_times, access_of(options));
}

FrameStore open_store(const FilmJobOptions& options) {
    return FrameStore(frames_folder(options), {}, options.claim_times, access_of(options));
}

std::vector<Hash128> keys_of(const FilmPlan& plan, const sim::Bake& bake) {
    std::vector<Hash128> keys{bake.physics_hash};
    for (const FilmPlan::Picture& picture : plan.pictures) {
        keys.push_back(picture.key);
    }
    return keys;
}

RenderFunction renderer_of(const Shot& shot, const FilmJobOptions& options) {
    if (options.renderer) {
        return options.renderer;
    }
    return make_scene_renderer(shot, options.threads, options.structures,
                               std::make_shared<const FrameStore>(open_store(options)));
}

}  // namespace carom::pipeline
