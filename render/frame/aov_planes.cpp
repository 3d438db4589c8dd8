#include "render/frame/aov_planes.h"

#include <algorithm>
#include <array>
#include <span>

namespace carom::render {
namespace {

constexpr float kMiddle = 0.5f;              // of the shutter
constexpr float kBackgroundDistance = 1e5f;  // m, for the motion of what is infinitely far

struct Aov {
    std::string_view name;
    std::array<std::string_view, 3> channels;  // empty names: fewer than three
    bool is_seen_by_centre;
};

constexpr std::array<Aov, 6> kAovs{{{"depth", {"Z"}, true},
                                    {"normal", {"N.X", "N.Y", "N.Z"}, false},
                                    {"albedo", {"albedo.R", "albedo.G", "albedo.B"}, false},
                                    {"motion", {"motion.X", "motion.Y"}, true},
                                    {"object_id", {"object_id"}, true},
                                    {"variance", {"variance"}, false}}};

const Aov* find_aov(std::string_view name) {
    const auto* found =
        std::find_if(kAovs.begin(), kAovs.end(), [&](const Aov& aov) { return aov.name == name; });
    return found == kAovs.end() ? nullptr : found;
}

CameraState without_lens(CameraState state) {
    state.lens_radius = 0;
    return state;
}

}  // namespace

bool is_aov(std::string_view name) {
    return find_aov(name) != nullptr;
}

AovPlanes::AovPlanes(const RenderSettings& settings, const FrameInput& frame,
                     const FrameScene& scene)
    : names_(settings.aovs),
      scene_(scene),
      camera_(without_lens(frame.camera_open), without_lens(frame.camera_close), settings.width,
              settings.height, 0, PixelFilter::box, 1),
      width_(settings.width) {
    const std::size_t pixels =
        static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
    for (const std::string& name : names_) {
        const Aov* aov = find_aov(name);
        for (const std::string_view channel : aov->channels) {
            if (!channel.empty()) {
                channels_.push_back({std::string(channel), std::vector<float>(pixels)});
            }
        }
        looks_ = looks_ || aov->is_seen_by_centre;
    }
}

V2f AovPlanes::motion_of(const V3f& at_open, const V3f& at_close) const {
    const auto open = camera_.project(at_open, 0);
    const auto close = camera_.project(at_close, 1);
    return open && close ? *close - *open : V2f(0, 0);
}

AovPlanes::Seen AovPlanes::look(int x, int y) const {
    const Ray ray = camera_.ray(x, y, {V2f(kMiddle, kMiddle), V2f(kMiddle, kMiddle), kMiddle});
    Seen seen;
    Hit hit;
    if (!scene_.structure().closest_hit(ray, hit)) {
        const V3f far = ray.origin + ray.direction * kBackgroundDistance;
        seen.motion = motion_of(far, far);
        return seen;
    }
    const V3f point = ray.origin + ray.direction * hit.t;
    const CameraFrame frame = camera_.frame_at(kMiddle);
    seen.depth = (point - frame.position) ^ frame.forward;
    seen.motion = motion_of(scene_.moved(hit.object, point, kMiddle, 0),
                            scene_.moved(hit.object, point, kMiddle, 1));
    seen.object = static_cast<float>(hit.object + 1);
    return seen;
}

void AovPlanes::write(int x, int y, const PixelMeans& means) {
    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x);
    const Seen seen = looks_ ? look(x, y) : Seen{};
    auto channel = channels_.begin();
    const auto put = [&](std::span<const float> values) {
        for (const float value : values) {
            channel->values[pixel] = value;
            ++channel;
        }
    };
    for (const std::string& name : names_) {
        if (name == "depth") {
            put(std::array{seen.depth});
        } else if (name == "normal") {
            put(std::array{means.normal.x, means.normal.y, means.normal.z});
        } else if (name == "albedo") {
            put(std::array{means.albedo.x, means.albedo.y, means.albedo.z});
        } else if (name == "motion") {
            put(std::array{seen.motion.x, seen.motion.y});
        } else if (name == "object_id") {
            put(std::array{seen.object});
        } else {
            put(std::array{means.variance});
        }
    }
}

}  // namespace carom::render
