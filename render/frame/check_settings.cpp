#include "render/frame/check_settings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "core/error.h"
#include "render/frame/aov_planes.h"
#include "render/integrator/distributed_ray_counts.h"

namespace carom::render {
namespace {

class Problems {
  public:
    template <class Value>
    void unless_between(const char* name, Value value, Value low, Value high) {
        // Written so that NaN is a problem too.
        if (!(value >= low && value <= high)) {
            std::ostringstream text;
            text << name << " is " << value << "; it must lie between " << low << " and " << high;
            list_.push_back(text.str());
        }
    }
    void add(std::string text) { list_.push_back(std::move(text)); }
    [[nodiscard]] std::vector<std::string> take() { return std::move(list_); }

  private:
    std::vector<std::string> list_;
};

constexpr int kMostSamples = 1024;

void add_problems_of(const DistributedSettings& settings, Problems& problems) {
    const auto count = [&](const char* name, int value) {
        problems.unless_between(name, value, 1, kMostSamples);
    };
    count("pixel_samples", settings.pixel_samples);
    count("blur_samples", settings.blur_samples);
    count("lens_samples", settings.lens_samples);
    count("shadow_samples", settings.shadow_samples);
    count("reflection_samples", settings.reflection_samples);
    count("refraction_samples", settings.refraction_samples);
    problems.unless_between("recursion_limit", settings.recursion_limit, 0, 32);
    problems.unless_between("ambient_coefficient", settings.ambient_coefficient, 0.0, 1e6);
    const std::int64_t rays = std::int64_t{settings.pixel_samples} *
                              std::int64_t{settings.blur_samples} *
                              std::int64_t{settings.lens_samples};
    if (rays > kMostCameraSamples) {
        problems.add("pixel_samples, blur_samples and lens_samples together ask for " +
                     std::to_string(rays) + " rays per pixel; at most " +
                     std::to_string(kMostCameraSamples) + " can be had");
    }
}

}  // namespace

std::vector<std::string> problems_of(const RenderSettings& settings) {
    Problems problems;
    problems.unless_between("width", settings.width, 1, 16384);
    problems.unless_between("height", settings.height, 1, 16384);
    problems.unless_between("samples", settings.samples, 1, 65536);
    problems.unless_between("noise", settings.noise, 0.0, 1.0);
    problems.unless_between("max_samples", settings.max_samples, 1, 65536);
    if (settings.noise > 0 && settings.samples % 4 != 0) {
        problems.add("samples is " + std::to_string(settings.samples) +
                     "; with noise it must be a multiple of 4");
    }
    problems.unless_between("max_bounces", settings.max_bounces, 0, 64);
    problems.unless_between("clamp", settings.clamp, 0.0, 1e30);
    problems.unless_between("filter_width", settings.filter_width, 0.5, 8.0);
    if (settings.integrator == IntegratorKind::distributed) {
        add_problems_of(settings.distributed, problems);
    }
    for (const std::string& name : settings.aovs) {
        if (!is_aov(name)) {
            problems.add("there is no AOV '" + name + "'");
        }
    }
    return problems.take();
}

std::vector<std::string> problems_of(const FrameInput& frame) {
    Problems problems;
    problems.unless_between("switch_ratio", frame.switch_ratio, 0.0, 1.0);
    if (!(std::isfinite(frame.scene_open) && std::isfinite(frame.scene_close) &&
          frame.scene_open <= frame.scene_close)) {
        std::ostringstream text;
        text << "the shutter opens at " << frame.scene_open << " s and closes at "
             << frame.scene_close << " s of scene time";
        problems.add(text.str());
    }
    return problems.take();
}

void check_integrator(const RenderSettings& settings, const std::vector<Material>& materials,
                      std::size_t lights) {
    if (settings.integrator == IntegratorKind::path) {
        return;
    }
    const bool reflects = std::any_of(materials.begin(), materials.end(), [](const Material& m) {
        return m.phong().metal > 0 || m.phong().reflectance != V3f(0, 0, 0) ||
               m.phong().transmittance != V3f(0, 0, 0);
    });
    const bool refracts = std::any_of(materials.begin(), materials.end(), [](const Material& m) {
        return m.phong().transmittance != V3f(0, 0, 0);
    });
    const double rays = rays_per_camera_ray(settings.distributed, lights, reflects, refracts);
    if (rays > kMostRaysPerCameraRay) {
        std::ostringstream text;
        text << "one camera ray could branch into " << rays << " rays, and more than "
             << kMostRaysPerCameraRay
             << " would take too long; lower recursion_limit or the sample counts of the "
                "distributed integrator, or let them fall off with depth";
        throw Error(text.str());
    }
}

void check(const RenderSettings& settings, const FrameInput& frame) {
    std::vector<std::string> all = problems_of(settings);
    const std::vector<std::string> others = problems_of(frame);
    all.insert(all.end(), others.begin(), others.end());
    if (all.empty()) {
        return;
    }
    std::string text = "the frame cannot be rendered: ";
    for (std::size_t i = 0; i < all.size(); ++i) {
        text += (i == 0 ? "" : "; ") + all[i];
    }
    throw Error(text);
}

}  // namespace carom::render
