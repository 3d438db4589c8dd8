#include "render/scene/scene_problems.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>
#include <string>

namespace carom::render {

namespace {

constexpr double kLargestSkew = 1e-6;  // cosine between two sides of a rectangle light

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
    return refracts(material) || (material.phong ? !is_black(material.phong->reflectance)
                                                 : surface.metal > 0 || surface.coat.weight > 0);
}

bool is_emissive(const MaterialDescription& material) {
    return !is_black(material.phong ? material.phong->emission : material.surface.emission);
}

bool is_radiance(const Vec3& c) {
    // The condition is written so that NaN is invalid.
    const auto valid = [](double x) { return x >= 0 && x < 1e30; };
    return valid(c.x) && valid(c.y) && valid(c.z);
}

/// The problems of one light.
class LightCheck {
  public:
    LightCheck(const std::string& name, std::vector<Diagnostic>& problems)
        : name_(name), problems_(problems) {}

    void operator()(const RectangleLight& light) {
        const Vec3& u = light.edge_u;
        const Vec3& v = light.edge_v;
        const Vec3& n = light.normal;
        const double area = u.length() * v.length();
        if (!require(area > 0 && std::isfinite(area), "rectangle", "the rectangle has no area")) {
            return;
        }
        const double skew =
            std::max({std::abs(u.normalized().dot(v.normalized())), std::abs(u.normalized().dot(n)),
                      std::abs(v.normalized().dot(n)), std::abs(n.length() - 1)});
        require(skew < kLargestSkew, "rectangle",
                "edges and normal of the rectangle are not at right angles to each other");
        require_radiance(light.radiance);
    }
    void operator()(const SphereLight& light) {
        require(light.radius > 0 && std::isfinite(light.radius), "sphere",
                "the radius is not above 0");
        require_radiance(light.radiance);
    }
    void operator()(const EnvironmentLight& light) {
        require(std::isfinite(light.rotation), "rotation", "the rotation is not a number");
        require_radiance(light.radiance);
    }
    void operator()(const PointLight& light) { require_radiance(light.intensity); }
    void operator()(const SpotLight& light) {
        require(light.direction.length() > 1e-9, "facing", "the axis has no length");
        require(light.inner_angle >= 0 && light.inner_angle <= light.outer_angle &&
                    light.outer_angle > 0 && light.outer_angle <= std::numbers::pi,
                "angle", "the angles are not 0 <= inner <= outer <= 180 degrees");
        require_radiance(light.intensity);
    }
    void operator()(const DirectionalLight& light) {
        require(light.direction.length() > 1e-9, "facing", "the direction has no length");
        require_radiance(light.irradiance);
    }

  private:
    bool require(bool holds, const char* field, const char* what) {
        if (!holds) {
            problems_.push_back(
                {{Subject::Kind::light, name_}, field, "light '" + name_ + "': " + what});
        }
        return holds;
    }
    void require_radiance(const Vec3& radiance) {
        require(is_radiance(radiance), "radiance",
                "the radiance is negative, infinite or not a number");
    }

    const std::string& name_;
    std::vector<Diagnostic>& problems_;
};

}  // namespace

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
        std::visit(LightCheck(light.name, problems), light.light);
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
