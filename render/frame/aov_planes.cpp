#include "render/frame/aov_planes.h"

#include <algorithm>
#include <array>
#include <span>

namespace carom::render {
namespace {

constexpr float kMiddle = 0.5f;              // of the shutter
constexpr float kBackgroundDistance = 1e5f;  // m, for the motion of the background

struct Aov {
    std::string_view name;
    std::array<std::string_view, 3> channels;  // empty names if there are fewer than three
    bool is_seen_by_centre;
};

constexpr std::string_view kVariance = "variance";
constexpr std::string_view kVarianceChannel = "variance.X";

// A name of more than one letter ends in ".X" or similar: compositors take the part before the last
// dot as the layer and drop channels without one.
constexpr std::array<Aov, 8> kAovs{{{"depth", {"Z"}, true},
                                    {"normal", {"N.X", "N.Y", "N.Z"}, false},
                                    {"albedo", {"albedo.R", "albedo.G", "albedo.B"}, false},
                                    {"roughness", {"roughness.X"}, false},
                                    {"motion", {"motion.X", "motion.Y"}, true},
                                    {"object_id", {"object_id.X"}, true},
                                    {"material_id", {"material_id.X"}, true},
                                    {kVariance, {kVarianceChannel}, false}}};

constexpr std::string_view kObjectMatte = "cryptomatte_object";
constexpr std::string_view kMaterialMatte = "cryptomatte_material";
constexpr std::string_view kObjectLayer = "CryptoObject";
constexpr std::string_view kMaterialLayer = "CryptoMaterial";
// The material name of lights, which have no material.
constexpr const char* kLightMaterial = "light";

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
    return find_aov(name) != nullptr || is_matte(name);
}

bool is_matte(std::string_view name) {
    return name == kObjectMatte || name == kMaterialMatte;
}

AovPlanes::AovPlanes(const RenderSettings& settings, const FrameInput& frame,
                     const FrameScene& scene, const SceneNames& names)
    : names_(settings.aovs),
      scene_names_(names),
      scene_(scene),
      camera_(without_lens(frame.camera_open), without_lens(frame.camera_close), settings.width,
              settings.height, 0, PixelFilter::box, 1),
      width_(settings.width) {
    const std::size_t pixels =
        static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
    const auto add_channel = [&](std::string_view name) {
        channels_.push_back({std::string(name), std::vector<float>(pixels)});
    };
    for (const std::string& name : names_) {
        if (is_matte(name)) {
            for (const std::string& channel : add_matte(name)) {
                add_channel(channel);
            }
            continue;
        }
        const Aov* aov = find_aov(name);
        for (const std::string_view channel : aov->channels) {
            if (!channel.empty()) {
                add_channel(channel);
            }
        }
        needs_centre_ray_ = needs_centre_ray_ || aov->is_seen_by_centre;
    }
    if (has_variance() && has_halves(settings)) {
        squared_differences_.resize(pixels);
    }
}

/// Adds the channels of a matte and returns their names.
std::vector<std::string> AovPlanes::add_matte(std::string_view name) {
    if (name == kObjectMatte) {
        for (const std::string& object : scene_names_.objects) {
            object_ids_.push_back(matte_id(object));
        }
        notes_.merge(matte_notes(kObjectLayer, scene_names_.objects));
        return matte_channels(kObjectLayer);
    }
    std::vector<std::string> materials = scene_names_.materials;
    materials.emplace_back(kLightMaterial);
    for (const std::uint32_t material : scene_names_.material_of) {
        material_ids_.push_back(
            matte_id(materials[std::min<std::size_t>(material, materials.size() - 1)]));
    }
    notes_.merge(matte_notes(kMaterialLayer, materials));
    return matte_channels(kMaterialLayer);
}

V2f AovPlanes::motion_of(const V3f& at_open, const V3f& at_close) const {
    const auto open = camera_.project(at_open, 0);
    const auto close = camera_.project(at_close, 1);
    return open && close ? *close - *open : V2f(0, 0);
}

AovPlanes::CentreHit AovPlanes::trace_centre(int x, int y) const {
    const Ray ray = camera_.ray(x, y, {V2f(kMiddle, kMiddle), V2f(kMiddle, kMiddle), kMiddle});
    CentreHit centre;
    Hit hit;
    if (!scene_.structure().closest_hit(ray, hit)) {
        const V3f far = ray.origin + ray.direction * kBackgroundDistance;
        centre.motion = motion_of(far, far);
        return centre;
    }
    const V3f point = ray.origin + ray.direction * hit.t;
    const CameraFrame frame = camera_.frame_at(kMiddle);
    centre.depth = (point - frame.position).dot(frame.forward);
    centre.motion = motion_of(scene_.moved(hit.object, point, kMiddle, 0),
                              scene_.moved(hit.object, point, kMiddle, 1));
    centre.object = static_cast<float>(hit.object + 1);
    const std::uint32_t material = scene_names_.material_of[hit.object];
    centre.material =
        material < scene_names_.materials.size() ? static_cast<float>(material + 1) : 0.0f;
    return centre;
}

MatteRanks AovPlanes::ranks(const PixelMeans& means, const std::vector<float>& ids) const {
    std::vector<MatteRank> found;
    for (const ObjectCount& entry : means.objects) {
        found.push_back({ids[entry.object],
                         static_cast<float>(entry.samples) / static_cast<float>(means.samples)});
    }
    return ranked(found);
}

bool AovPlanes::has_variance() const {
    return std::find(names_.begin(), names_.end(), kVariance) != names_.end();
}

namespace {

/// Sums over squares of 17x17 values, cut at the edges of the picture.
std::vector<double> sums_around(const std::vector<float>& values, int width) {
    constexpr int kReach = 8;
    const int height = static_cast<int>(std::ssize(values) / width);
    // Sums over the rectangles from the first value on (Crow 1984, "Summed-area tables for texture
    // mapping").
    const std::size_t stride = static_cast<std::size_t>(width) + 1;
    std::vector<double> table(stride * (static_cast<std::size_t>(height) + 1));
    const auto corner = [&](int x, int y) -> double& {
        return table[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)];
    };
    for (int y = 0; y < height; ++y) {
        double row = 0;
        for (int x = 0; x < width; ++x) {
            row += static_cast<double>(
                values[static_cast<std::size_t>(y) * (stride - 1) + static_cast<std::size_t>(x)]);
            corner(x + 1, y + 1) = corner(x + 1, y) + row;
        }
    }
    std::vector<double> result;
    result.reserve(values.size());
    for (int y = 0; y < height; ++y) {
        const auto [top, bottom] =
            std::pair(std::max(0, y - kReach), std::min(height, y + kReach + 1));
        for (int x = 0; x < width; ++x) {
            const auto [left, right] =
                std::pair(std::max(0, x - kReach), std::min(width, x + kReach + 1));
            result.push_back(corner(right, bottom) - corner(left, bottom) - corner(right, top) +
                             corner(left, top));
        }
    }
    return result;
}

}  // namespace

void AovPlanes::finish_variance(const std::vector<float>& more) {
    if (!has_variance()) {
        return;
    }
    const auto channel = std::find_if(channels_.begin(), channels_.end(),
                                      [](const Channel& c) { return c.name == kVarianceChannel; });
    std::vector<float>& variance = channel->values;
    if (!squared_differences_.empty()) {
        const std::vector<double> measured = sums_around(squared_differences_, width_);
        const std::vector<double> assumed = sums_around(variance, width_);
        for (std::size_t pixel = 0; pixel < variance.size(); ++pixel) {
            variance[pixel] *=
                assumed[pixel] > 0 ? static_cast<float>(measured[pixel] / assumed[pixel]) : 0.0F;
        }
    }
    for (std::size_t pixel = 0; pixel < variance.size(); ++pixel) {
        variance[pixel] += more[pixel];
    }
}

void AovPlanes::write(int x, int y, const PixelMeans& means) {
    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x);
    const CentreHit centre = needs_centre_ray_ ? trace_centre(x, y) : CentreHit{};
    auto channel = channels_.begin();
    const auto put = [&](std::span<const float> values) {
        for (const float value : values) {
            channel->values[pixel] = value;
            ++channel;
        }
    };
    const auto put_ranks = [&](const MatteRanks& ranks) {
        for (const MatteRank& rank : ranks) {
            put(std::array{rank.id, rank.coverage});
        }
    };
    for (const std::string& name : names_) {
        if (name == kObjectMatte) {
            put_ranks(ranks(means, object_ids_));
        } else if (name == kMaterialMatte) {
            put_ranks(ranks(means, material_ids_));
        } else if (name == "depth") {
            put(std::array{centre.depth});
        } else if (name == "normal") {
            put(std::array{means.normal.x, means.normal.y, means.normal.z});
        } else if (name == "albedo") {
            put(std::array{means.albedo.x, means.albedo.y, means.albedo.z});
        } else if (name == "roughness") {
            put(std::array{means.roughness});
        } else if (name == "motion") {
            put(std::array{centre.motion.x, centre.motion.y});
        } else if (name == "object_id") {
            put(std::array{centre.object});
        } else if (name == "material_id") {
            put(std::array{centre.material});
        } else {
            put(std::array{means.variance});
            if (!squared_differences_.empty()) {
                squared_differences_[pixel] = means.squared_difference;
            }
        }
    }
}

}  // namespace carom::render
