#include "render/frame/check_settings.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "render/frame/aov_planes.h"
#include "sim/timeline/error.h"

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

}  // namespace

std::vector<std::string> problems_of(const RenderSettings& settings) {
    Problems problems;
    problems.unless_between("width", settings.width, 1, 16384);
    problems.unless_between("height", settings.height, 1, 16384);
    problems.unless_between("samples", settings.samples, 1, 65536);
    problems.unless_between("max_bounces", settings.max_bounces, 0, 64);
    problems.unless_between("clamp", settings.clamp, 0.0, 1e30);
    problems.unless_between("filter_width", settings.filter_width, 0.5, 8.0);
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
