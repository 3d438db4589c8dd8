#include "sound/rolling/rolling_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/assert.h"
#include "core/splitmix.h"
#include "sound/rolling/read_out.h"
#include "sound/rolling/rolling_plan.h"

namespace carom::sound {
namespace {

constexpr double kFade = 0.005;        // s of the scene
constexpr double kLeastOffset = 1000;  // m; offsets reach to twice of it

/// The factor with which a stretch fades in and out.
double fade_of(const Stretch& stretch, double time) {
    const double fade = std::min(kFade, (stretch.to - stretch.from) / 4);
    return std::clamp(std::min(time - stretch.from, stretch.to - time) / fade, 0.0, 1.0);
}

}  // namespace

class RollingSource::Implementation {
  public:
    explicit Implementation(RollingPlan what)
        : plan(std::move(what)),
          rolled_(plan.seed, plan.texture),
          slid_(plan.seed + kSplitMixStep, plan.texture) {}

    const RollingPlan plan;

    [[nodiscard]] bool sounds(double from, double to) const {
        const auto next = first_ending_after(std::min(from, to));
        return next != plan.stretches.end() && next->from <= std::max(from, to);
    }

    void add(const PassageBlock& block, std::span<double> pressure) {
        CAROM_ASSERT(pressure.size() == block.scene_time.size());
        if (block.first != next_sample_) {
            begin();
        }
        next_sample_ = block.first + static_cast<std::int64_t>(pressure.size());
        if (block.dynamics != dynamics_) {
            dynamics_ = block.dynamics;
            present_ = kNone;
        }
        if (pressure.empty() || !sounds(block.scene_time.front(), block.scene_time.back())) {
            return;
        }
        for (std::size_t n = 0; n < pressure.size(); ++n) {
            const double time = block.scene_time[n];
            const Stretch* stretch = block.speed[n] > 0 ? stretch_at(time) : nullptr;
            if (stretch != nullptr) {
                const double sum = rolled_.at(time, block.speed[n], block.ratio[n]) +
                                   slid_.at(time, block.speed[n], block.ratio[n]);
                pressure[n] += block.presence[n] * fade_of(*stretch, time) * sum;
            }
        }
    }

    void begin() {
        rolled_.begin();
        slid_.begin();
    }

  private:
    using Iterator = std::vector<Stretch>::const_iterator;

    static constexpr auto kNone = static_cast<std::size_t>(-1);

    [[nodiscard]] Iterator first_ending_after(double time) const {
        return std::partition_point(plan.stretches.begin(), plan.stretches.end(),
                                    [&](const Stretch& s) { return s.to <= time; });
    }

    /// The stretch with this time, or nullptr. Makes its ways.
    const Stretch* stretch_at(double time) {
        if (present_ < plan.stretches.size() && is_in(plan.stretches[present_], time)) {
            return &plan.stretches[present_];
        }
        const auto next = first_ending_after(time);
        if (next == plan.stretches.end() || !is_in(*next, time)) {
            return nullptr;
        }
        present_ = static_cast<std::size_t>(next - plan.stretches.begin());
        BallWays ways = plan.ways(*next);
        apply_dynamics(dynamics_, ways);
        const std::uint64_t bits = split_mix(plan.seed + (present_ + 2) * kSplitMixStep);
        const double offset = kLeastOffset * (1 + unit_number(bits));
        rolled_.set_way(std::move(ways.rolled), offset);
        slid_.set_way(std::move(ways.slid), offset);
        return &*next;
    }

    static bool is_in(const Stretch& stretch, double time) {
        return stretch.from <= time && time < stretch.to;
    }

    ReadOut rolled_, slid_;
    std::size_t present_ = kNone;  // the stretch whose ways there are
    double dynamics_ = 1;          // of those ways
    std::int64_t next_sample_ = 0;
};

RollingSource::RollingSource(RollingPlan plan)
    : implementation_(std::make_unique<Implementation>(std::move(plan))) {}
RollingSource::~RollingSource() = default;
RollingSource::RollingSource(RollingSource&&) noexcept = default;
RollingSource& RollingSource::operator=(RollingSource&&) noexcept = default;

const std::string& RollingSource::body() const {
    return implementation_->plan.body;
}

const sim::Track* RollingSource::track() const {
    return implementation_->plan.track;
}

Vec3 RollingSource::place(double scene_time) const {
    return track() != nullptr ? track()->sample(scene_time).position : implementation_->plan.place;
}

bool RollingSource::sounds(double from, double to) const {
    return implementation_->sounds(from, to);
}

void RollingSource::add(const PassageBlock& block, std::span<double> pressure) {
    implementation_->add(block, pressure);
}

void RollingSource::begin() {
    implementation_->begin();
}

}  // namespace carom::sound
