#include "render/frame/check_settings.h"

#include <cmath>
#include <sstream>

#include <fmt/core.h>

#include "core/error.h"
#include "render/frame/aov_planes.h"

namespace carom::render {
namespace {

class Problems {
  public:
    template <class Value>
    void unless_between(const char* name, Value value, Value low, Value high) {
        // The condition is written so that NaN is a problem, too.
        if (!(value >= low && value <= high)) {
            std::ostringstream text;
            text << name << " is " << value << "; it must lie between " << low << " and " << high;
            add(prefix_ + name, text.str());
        }
    }
    void add(std::string field, std::string sentence) {
        list_.push_back({{Subject::Kind::settings}, std::move(field), std::move(sentence)});
    }
    void add_all(const std::vector<Diagnostic>& problems) {
        list_.insert(list_.end(), problems.begin(), problems.end());
    }
    /// Sets the prefix of the fields of the following problems.
    void go_into(const std::string& field) { prefix_ = field + "."; }
    [[nodiscard]] std::vector<Diagnostic> take() { return std::move(list_); }

  private:
    std::vector<Diagnostic> list_;
    std::string prefix_;
};

constexpr int kMostSamples = 1024;

void check_distributed(const DistributedSettings& settings, const RayBranches& branches,
                       Problems& problems) {
    problems.go_into("distributed");
    const auto count = [&](const char* name, int value, int fewest = 1) {
        problems.unless_between(name, value, fewest, kMostSamples);
    };
    count("pixel_samples", settings.pixel_samples);
    count("blur_samples", settings.blur_samples);
    count("lens_samples", settings.lens_samples);
    count("shadow_samples", settings.shadow_samples);
    count("reflection_samples", settings.reflection_samples, 0);
    count("refraction_samples", settings.refraction_samples, 0);
    problems.unless_between("recursion_limit", settings.recursion_limit, 0, 32);
    problems.unless_between("ambient_coefficient", settings.ambient_coefficient, 0.0, 1e6);
    problems.add_all(find_problems(settings, branches));
}

}  // namespace

std::vector<Diagnostic> find_problems(const RenderSettings& settings, const RayBranches& branches) {
    Problems problems;
    problems.unless_between("width", settings.width, 1, kLongestSide);
    problems.unless_between("height", settings.height, 1, kLongestSide);
    problems.unless_between("samples", settings.samples, 1, 65536);
    problems.unless_between("noise", settings.noise, 0.0, 1.0);
    problems.unless_between("max_samples", settings.max_samples, 1, 65536);
    if (settings.noise > 0 && settings.samples % 2 != 0) {
        problems.add("samples", fmt::format("samples is {}; with noise it must be an even number",
                                            settings.samples));
    }
    if (settings.for_denoiser && settings.integrator == IntegratorKind::distributed) {
        problems.add("for_denoiser", "frames of the distributed integrator cannot be denoised");
    } else if (settings.for_denoiser && settings.samples % 2 != 0) {
        problems.add(
            "samples",
            fmt::format("samples is {}; a frame that will be denoised needs an even number",
                        settings.samples));
    }
    problems.unless_between("max_bounces", settings.max_bounces, 0, 64);
    problems.unless_between("clamp", settings.clamp, 0.0, 1e30);
    problems.unless_between("filter_width", settings.filter_width, 0.5, 8.0);
    for (const std::string& name : settings.aovs) {
        if (!is_aov(name)) {
            problems.add("aovs", "there is no AOV '" + name + "'");
        }
    }
    if (settings.integrator == IntegratorKind::distributed) {
        check_distributed(settings.distributed, branches, problems);
    }
    return problems.take();
}

std::vector<Diagnostic> find_problems(const FrameInput& frame) {
    Problems problems;
    problems.unless_between("switch_ratio", frame.switch_ratio, 0.0, 1.0);
    if (!(std::isfinite(frame.scene_open) && std::isfinite(frame.scene_close) &&
          frame.scene_open <= frame.scene_close)) {
        std::ostringstream text;
        text << "the shutter opens at " << frame.scene_open << " s and closes at "
             << frame.scene_close << " s of scene time";
        problems.add("shutter", text.str());
    }
    return problems.take();
}

void check(const RenderSettings& settings, const FrameInput& frame, const RayBranches& branches) {
    std::vector<Diagnostic> all = find_problems(settings, branches);
    const std::vector<Diagnostic> others = find_problems(frame);
    all.insert(all.end(), others.begin(), others.end());
    if (all.empty()) {
        return;
    }
    std::string text = "the frame cannot be rendered: ";
    for (std::size_t i = 0; i < all.size(); ++i) {
        text += (i == 0 ? "" : "; ") + all[i].sentence;
    }
    throw Error(text);
}

}  // namespace carom::render
