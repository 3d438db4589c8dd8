#include "render/scene/scene_problems.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>

namespace carom::render {

namespace {

bool is_black(const Vec3& colour) {
    return colour == Vec3(0, 0, 0);
}

bool refracts(const MaterialDescription& material) {
    return material.phong ? !is_black(material.phong->transmittance)
                          : material.surface.transmission > 0;
}

/// A refracting surface also reflects: beyond the critical angle it reflects everything.
bool reflects(const MaterialDescription& material) {
    const StandardMaterial& surface = material.surface;
    return refracts(material) ||
           (material.phong ? !is_black(material.phong->reflectance)
                           : surface.metal.most() > 0 || surface.coat.weight.most() > 0);
}

/// Radiance, intensity or irradiance.
template <class Light>
Vec3 brightness_of(const Light& light) {
    if constexpr (requires { light.radiance; }) {
        return light.radiance;
    } else if constexpr (requires { light.intensity; }) {
        return light.intensity;
    } else {
        return light.irradiance;
    }
}

bool is_radiance(const Vec3& c) {
    // The condition is written so that NaN is invalid.
    const auto valid = [](double x) { return x >= 0 && x < 1e30; };
    return valid(c.x) && valid(c.y) && valid(c.z);
}

void add_problems(const LightDescription& light, std::vector<Diagnostic>& problems) {
    const auto add = [&](const LightProblem& problem) {
        problems.push_back({{Subject::Kind::light, light.name},
                            problem.field,
                            "light '" + light.name + "': " + problem.what});
    };
    std::visit(
        [&](const auto& one) {
            if (const LightProblem problem = problem_of(one); problem.what != nullptr) {
                add(problem);
            }
            if (!is_radiance(brightness_of(one))) {
                add({"radiance", "the radiance is negative, infinite or not a number"});
            }
        },
        light.light);
}

}  // namespace

bool is_emissive(const MaterialDescription& material) {
    if (material.phong) {
        return !is_black(material.phong->emission);
    }
    const StandardMaterial& surface = material.surface;
    const auto* constant = std::get_if<Vec3>(&surface.emission);
    return surface.emission_strength > 0 && (constant == nullptr || !is_black(*constant));
}

RayBranches ray_branches(const SceneDescription& scene) {
    RayBranches branches;
    const std::vector<MaterialDescription>& materials = scene.materials;
    branches.reflects = std::any_of(materials.begin(), materials.end(), reflects);
    branches.refracts = std::any_of(materials.begin(), materials.end(), refracts);
    const auto shines = [&](const ObjectDescription& object) {
        return std::any_of(materials.begin(), materials.end(), [&](const auto& material) {
            return material.name == object.material && is_emissive(material);
        });
    };
    branches.lights =
        scene.lights.size() +
        static_cast<std::size_t>(std::count_if(scene.objects.begin(), scene.objects.end(), shines));
    return branches;
}

std::vector<Diagnostic> find_problems(const std::vector<LightDescription>& lights) {
    std::vector<Diagnostic> problems;
    const LightDescription* environment = nullptr;
    for (const LightDescription& light : lights) {
        add_problems(light, problems);
        if (!std::holds_alternative<EnvironmentLight>(light.light)) {
            continue;
        }
        if (environment != nullptr) {
            problems.push_back({{Subject::Kind::light, light.name},
                                "",
                                "light '" + light.name +
                                    "' is a second environment; the first is '" +
                                    environment->name + "'"});
        } else {
            environment = &light;
        }
    }
    return problems;
}

std::vector<Diagnostic> find_problems(const DistributedSettings& settings,
                                      const RayBranches& branches) {
    std::vector<Diagnostic> problems;
    const auto add = [&](const std::ostringstream& text) {
        problems.push_back({{Subject::Kind::settings}, "distributed", text.str()});
    };
    const std::int64_t camera_rays = std::int64_t{settings.pixel_samples} *
                                     std::int64_t{settings.blur_samples} *
                                     std::int64_t{settings.lens_samples};
    if (camera_rays > kMostCameraSamples) {
        std::ostringstream text;
        text << "'pixel_samples', 'blur_samples' and 'lens_samples' ask for " << camera_rays
             << " rays per pixel; at most " << kMostCameraSamples << " are possible";
        add(text);
    }
    const double rays =
        rays_per_camera_ray(settings, branches.lights, branches.reflects, branches.refracts);
    if (rays > kMostRaysPerCameraRay) {
        std::ostringstream text;
        text << "one camera ray could branch into " << rays << " rays; at most "
             << kMostRaysPerCameraRay
             << " are possible: lower 'recursion_limit' or the samples of 'distributed'";
        add(text);
    }
    return problems;
}

}  // namespace carom::render
