// Converts the settings to those of the distributed integrator.
#include <algorithm>
#include <sstream>

#include "pipeline/import/conversion.h"

namespace carom::pipeline::scene_text {

namespace {

class RenderText {
  public:
    explicit RenderText(Conversion& conversion)
        : conversion_(conversion), given_(conversion.scene.settings.value_or(Settings{})) {}

    std::string operator()() {
        const double fps = defaulted(given_.fps, 24, "fps");
        const double ratio = defaulted(given_.blur_switch_ratio, 0.2, "blur_switch_ratio");
        const int blur = count(given_.blur_samples, "blur_samples");
        std::ostringstream out;
        out << "render:\n"
            << "  size: [" << yaml(defaulted(given_.width, kDefaultWidth, "width")) << ", "
            << yaml(defaulted(given_.height, kDefaultHeight, "height")) << "]\n"
            << "  fps: " << yaml(fps) << "\n"
            << "  shutter: {time: "
            << (blur == 1              ? "0 s"
                : given_.blur_duration ? yaml(*given_.blur_duration) + " s"
                                       : "1/" + yaml(fps) + " s")
            << ", position: start, switch_ratio: " << yaml(ratio) << "}\n"
            << "  integrator: distributed\n"
            << "  filter: gaussian\n"
            << "  distributed: {" << counts(blur) << ",\n"
            << "                ambient_coefficient: 0.12}\n"
            << "output: {view: raw}   # colours were computed as a display shows them\n";
        return out.str();
    }

  private:
    double defaulted(const Real& value, double otherwise, const char* name) {
        if (!value) {
            conversion_.note(std::string(name) + " has its default, " + yaml(otherwise));
        }
        return value.value_or(otherwise);
    }

    /// 0 and 1 both disable an effect.
    int count(const Real& value, const char* name) {
        return static_cast<int>(std::max(1.0, defaulted(value, 0, name)));
    }

    /// The count of rays that are sent on where `part` of a material is above 0. If it is so
    /// nowhere, the count may be 0 as in the text; otherwise 0 means one ray without a spread.
    int branches(const Real& value, Real PhongInfo::*part, const char* name) {
        const std::vector<PhongInfo>& infos = conversion_.scene.phong_infos;
        const bool is_used = std::any_of(infos.begin(), infos.end(), [&](const PhongInfo& phong) {
            return (phong.*part).value_or(0) > 0;
        });
        return value && *value == 0 && !is_used ? 0 : count(value, name);
    }

    std::string counts(int blur) {
        const int side = count(given_.interpolate_samples, "interpolate_samples");
        if (side > 1) {
            conversion_.note("interpolate_samples " + yaml(side) + " is a matrix of " + yaml(side) +
                             " x " + yaml(side) + " rays in each pixel");
        }
        std::ostringstream out;
        out << "pixel_samples: " << side * side << ", blur_samples: " << blur
            << ", lens_samples: " << count(given_.dof_samples, "dof_samples")
            << ", shadow_samples: " << count(given_.soft_shadow_samples, "soft_shadow_samples")
            << ",\n                reflection_samples: "
            << branches(given_.diffuse_reflection_samples, &PhongInfo::reflectance,
                        "diffuse_reflection_samples")
            << ", refraction_samples: "
            << branches(given_.diffuse_refraction_samples, &PhongInfo::refraction,
                        "diffuse_refraction_samples")
            << ", recursion_limit: " << yaml(defaulted(given_.recursion, 1, "recursion"));
        return out.str();
    }

    Conversion& conversion_;
    Settings given_;
};

}  // namespace

std::string render_section(Conversion& conversion) {
    return RenderText(conversion)();
}

}  // namespace carom::pipeline::scene_text
