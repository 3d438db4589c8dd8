#include "pipeline/job/far_light.h"

#include <chrono>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "core/error.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/frame_key.h"
#include "render/frame/bake_far_light.h"
#include "render/scene/still_scene.h"

namespace carom::pipeline {
namespace {

using render::FarLight;

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::shared_ptr<const FarLight> read(const std::string& path, const Hash128& key,
                                     const render::FarRegion& region) {
    return render::decoded(text_of(path), key.to_string(), region);
}

std::string file_in(const FrameStore& store, const Hash128& key) {
    return store.file_of(key, kFarLightExtension);
}

void write(const FrameStore& store, const Hash128& key, const FarLight& light) {
    PartialFile partial = store.begin_file(key);
    std::ofstream file(partial.path(), std::ios::binary);
    const std::string bytes = render::encoded(light, key.to_string());
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        throw CacheUnusable("'" + partial.path() + "' cannot be written");
    }
    partial.rename_to(file_in(store, key));
}

std::shared_ptr<const FarLight> known(const render::SceneDescription& scene, const Hash128& key,
                                      const FrameStore* store) {
    if (!scene.far->file.empty()) {
        if (auto light = read(scene.far->file, key, *scene.far)) {
            return light;
        }
    }
    if (store == nullptr) {
        return nullptr;
    }
    auto light = read(file_in(*store, key), key, *scene.far);
    if (light && store->may_write()) {
        mark_used(file_in(*store, key));
    }
    return light;
}

/// Computes and stores it, or waits for who does.
std::shared_ptr<const FarLight> stored(const render::SceneDescription& scene, const Hash128& key,
                                       const FrameStore& store, const WorkContext& context) {
    constexpr std::chrono::milliseconds kPause{200};
    for (;;) {
        if (const std::optional<Claim> claim = store.claim(key)) {
            if (auto light = known(scene, key, &store)) {
                return light;
            }
            auto light = render::bake_far_light(scene, context);
            write(store, key, *light);
            return light;
        }
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        std::this_thread::sleep_for(kPause);
        if (auto light = known(scene, key, &store)) {
            return light;
        }
    }
}

}  // namespace

Hash128 far_light_key(const render::SceneDescription& scene) {
    return hash_scene(render::still_scene(scene));
}

std::shared_ptr<const FarLight> known_far_light(const render::SceneDescription& scene,
                                                const FrameStore* store) {
    return scene.far ? known(scene, far_light_key(scene), store) : nullptr;
}

std::shared_ptr<const FarLight> far_light(const render::SceneDescription& scene,
                                          const FrameStore* store, const WorkContext& context) {
    if (!scene.far) {
        return nullptr;
    }
    const Hash128 key = far_light_key(scene);
    if (auto light = known(scene, key, store)) {
        return light;
    }
    return store != nullptr && store->may_write() ? stored(scene, key, *store, context)
                                                  : render::bake_far_light(scene, context);
}

std::shared_ptr<const FarLight> quick_far_light(const render::SceneDescription& scene,
                                                const FrameStore* store,
                                                const WorkContext& context) {
    auto light = known_far_light(scene, store);
    if (light || !scene.far) {
        return light;
    }
    constexpr double kCoarser = 8;
    constexpr int kSamples = 8;
    render::SceneDescription coarse = scene;
    coarse.far->cell *= kCoarser;
    coarse.far->samples = kSamples;
    return render::bake_far_light(coarse, context);
}

}  // namespace carom::pipeline
