#include "sound/rolling/rolling_source.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "core/assert.h"
#include "core/hash.h"
#include "core/splitmix.h"
#include "sound/rolling/ball_way.h"
#include "sound/rolling/rolling_level.h"
#include "sound/rolling/stretches.h"
#include "sound/rolling/texture.h"

namespace carom::sound {
namespace {

constexpr double kFade = 0.005;          // s of the scene
constexpr double kLongestOffset = 1000;  // m

bool is_cloth(const std::string& surface) {
    return surface == "cloth" || surface == "cushion";
}

/// A texture that is read out along a way.
class ReadOut {
  public:
    ReadOut(std::uint64_t seed, const Texture& texture) : reader_(seed, texture) {}

    [[nodiscard]] const TextureReader& reader() const { return reader_; }

    void set_way(Way way, double offset) {
        way_ = std::move(way);
        offset_ = offset;
        piece_ = kNoPiece;
        begin();
    }

    void begin() { has_last_ = false; }

    /// The speed of the way, m/s.
    [[nodiscard]] double speed_at(double time) { return way_.speed(way_.at(time)); }

    /// The place that is read is the integral of `ratio` over the way. In parts,
    ///     int r dx = r x - int x dr,
    /// it depends on the time alone where the ratio is constant.
    double at(double time, double playing_speed, double ratio) {
        const WayPoint point = way_.at(time);
        if (has_last_) {
            shift_ += (point.way + last_way_) / 2 * (ratio - last_ratio_);
        } else {
            shift_ = 0;
            has_last_ = true;
        }
        last_way_ = point.way;
        last_ratio_ = ratio;
        if (point.stands) {
            return 0;
        }
        if (point.piece != piece_ || playing_speed != playing_speed_) {
            enter_piece(point.piece, playing_speed);
        }
        return is_silent_ ? 0
                          : reader_.at(offset_ + ratio * point.way - shift_, first_weights_,
                                       last_weights_, point.part);
    }

  private:
    /// Between the ends of a piece, weights times strengths are linear: a function of scene time
    /// and playing speed alone.
    void enter_piece(std::size_t piece, double playing_speed) {
        const WayEnds& ends = way_.ends(piece);
        piece_ = piece;
        playing_speed_ = playing_speed;
        is_silent_ = ends.strengths[0] == 0 && ends.strengths[1] == 0;
        if (!is_silent_) {
            first_weights_ = scaled(ends.speeds[0] * playing_speed, ends.strengths[0]);
            last_weights_ = scaled(ends.speeds[1] * playing_speed, ends.strengths[1]);
        }
    }

    [[nodiscard]] TextureReader::Weights scaled(double speed, double strength) const {
        TextureReader::Weights weights = reader_.weights(speed);
        for (double& weight : weights) {
            weight *= strength;
        }
        return weights;
    }

    static constexpr auto kNoPiece = static_cast<std::size_t>(-1);

    TextureReader reader_;
    Way way_;
    double offset_ = 0;  // m
    bool has_last_ = false;
    double last_way_ = 0;
    double last_ratio_ = 1;
    double shift_ = 0;  // int x dr since begin()
    // Of the present piece and playing speed.
    std::size_t piece_ = kNoPiece;
    double playing_speed_ = 0;
    bool is_silent_ = true;
    TextureReader::Weights first_weights_{}, last_weights_{};
};

/// The factor with which a stretch fades in and out.
double fade_of(const Stretch& stretch, double time) {
    const double fade = std::min(kFade, (stretch.to - stretch.from) / 4);
    return std::clamp(std::min(time - stretch.from, stretch.to - time) / fade, 0.0, 1.0);
}

}  // namespace

class RollingSource::Implementation {
  public:
    Implementation(std::string name, const sim::Track* moving, const Vec3& position, double radius,
                   const Texture& texture, std::uint64_t seed, std::vector<Stretch> stretches)
        : body(std::move(name)),
          track(moving),
          resting_place(position),
          radius_(radius),
          seed_(seed),
          stretches_(std::move(stretches)),
          rolled_(seed, texture),
          slid_(seed + kSplitMixStep, texture) {}

    const std::string body;
    const sim::Track* const track;
    const Vec3 resting_place;

    [[nodiscard]] bool sounds(double from, double to) const {
        const double first = std::min(from, to);
        const double last = std::max(from, to);
        const auto next = std::partition_point(stretches_.begin(), stretches_.end(),
                                               [&](const Stretch& s) { return s.to <= first; });
        return next != stretches_.end() && next->from <= last;
    }

    [[nodiscard]] double level(double time) {
        const Stretch* stretch = stretch_at(time);
        if (stretch == nullptr) {
            return 0;
        }
        if (stretch->force > 0) {
            return fade_of(*stretch, time) * scraping_pressure(stretch->slip, stretch->force);
        }
        const double rolled = rolling_pressure(rolled_.speed_at(time));
        const double slid = sliding_pressure(slid_.speed_at(time));
        return fade_of(*stretch, time) * std::sqrt(rolled * rolled + slid * slid);
    }

    void add(const PassageBlock& block, std::span<double> pressure) {
        CAROM_ASSERT(pressure.size() == block.scene_time.size());
        if (block.first != next_sample_) {
            begin();
        }
        next_sample_ = block.first + static_cast<std::int64_t>(pressure.size());
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
    /// The stretch with this time, or nullptr. Makes its ways.
    const Stretch* stretch_at(double time) {
        if (present_ < stretches_.size() && is_in(stretches_[present_], time)) {
            return &stretches_[present_];
        }
        const auto next = std::partition_point(stretches_.begin(), stretches_.end(),
                                               [&](const Stretch& s) { return s.to <= time; });
        if (next == stretches_.end() || !is_in(*next, time)) {
            return nullptr;
        }
        present_ = static_cast<std::size_t>(next - stretches_.begin());
        make_ways(*next);
        return &*next;
    }

    static bool is_in(const Stretch& stretch, double time) {
        return stretch.from <= time && time < stretch.to;
    }

    void make_ways(const Stretch& stretch) {
        const std::uint64_t bits = split_mix(seed_ + (present_ + 2) * kSplitMixStep);
        const double offset = kLongestOffset * (1 + unit_number(bits));
        if (stretch.force > 0) {
            Way way;
            const double strength =
                scraping_pressure(stretch.slip, stretch.force) / strength_at(stretch.slip);
            way.add(stretch.from, stretch.to - stretch.from,
                    {stretch.slip, stretch.slip, stretch.slip}, {strength, strength});
            slid_.set_way(std::move(way), offset);
            return;
        }
        BallWays ways =
            ball_ways(*track, radius_, stretch.from, stretch.to,
                      {[&](double speed) { return rolling_pressure(speed) / strength_at(speed); },
                       [&](double slip) { return sliding_pressure(slip) / strength_at(slip); }});
        rolled_.set_way(std::move(ways.rolled), offset);
        slid_.set_way(std::move(ways.slid), offset);
    }

    double strength_at(double speed) const {
        return std::max(rolled_.reader().strength(speed), 1e-3);
    }

    double radius_;
    std::uint64_t seed_;
    std::vector<Stretch> stretches_;
    ReadOut rolled_, slid_;
    std::size_t present_ = static_cast<std::size_t>(-1);  // the stretch whose ways there are
    std::int64_t next_sample_ = 0;
};

RollingSource::RollingSource(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
RollingSource::~RollingSource() = default;
RollingSource::RollingSource(RollingSource&&) noexcept = default;
RollingSource& RollingSource::operator=(RollingSource&&) noexcept = default;

const std::string& RollingSource::body() const {
    return implementation_->body;
}

const sim::Track* RollingSource::track() const {
    return implementation_->track;
}

Vec3 RollingSource::place(double scene_time) const {
    return track() != nullptr ? track()->sample(scene_time).position
                              : implementation_->resting_place;
}

bool RollingSource::sounds(double from, double to) const {
    return implementation_->sounds(from, to);
}

double RollingSource::level(double scene_time) {
    return implementation_->level(scene_time);
}

void RollingSource::add(const PassageBlock& block, std::span<double> pressure) {
    implementation_->add(block, pressure);
}

void RollingSource::begin() {
    implementation_->begin();
}

namespace {

/// What is the same for all stretches of a pair.
struct Pair {
    const SoundBody* body = nullptr;
    std::vector<Stretch> stretches;
};

/// Adds a stretch to those of a pair, which are in order of their beginnings. Where two contacts
/// of one pair overlap, the later one goes on alone.
void add_stretch(std::vector<Stretch>& stretches, const Stretch& stretch) {
    if (!stretches.empty() && stretch.from < stretches.back().to) {
        stretches.back().to = stretch.from;
        if (!(stretches.back().to > stretches.back().from)) {
            stretches.pop_back();
        }
    }
    stretches.push_back(stretch);
}

}  // namespace

std::vector<RollingSource> rolling_sources(const SoundShot& shot) {
    std::vector<RollingSource> sources;
    const auto add = [&](const SoundBody& body, double radius, const Texture& texture,
                         const std::string& other, std::vector<Stretch> stretches) {
        const std::uint64_t seed = Hasher().add(body.name).add(other).finish().low;
        sources.push_back(RollingSource(std::make_unique<RollingSource::Implementation>(
            body.name, shot.timeline->find(body.name), body.position, radius, texture, seed,
            std::move(stretches))));
    };
    std::vector<std::vector<Stretch>> rolling = rolling_stretches(*shot.timeline, shot.bodies);
    for (std::size_t i = 0; i < shot.bodies.size(); ++i) {
        if (!rolling[i].empty()) {
            add(shot.bodies[i], std::get<BallShape>(shot.bodies[i].shape).radius, kCloth, "cloth",
                std::move(rolling[i]));
        }
    }
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, Pair> pairs;
    std::map<std::string_view, const SoundBody*> bodies;
    for (const SoundBody& body : shot.bodies) {
        bodies.emplace(body.name, &body);
    }
    for (const sim::LastingContact& contact : shot.timeline->lasting_contacts) {
        const auto found = bodies.find(contact.a);
        const SoundBody* body = found == bodies.end() ? nullptr : found->second;
        const bool is_rolling = body != nullptr && std::holds_alternative<BallShape>(body->shape) &&
                                (contact.b == "cloth" || contact.b == "floor");
        const bool is_heard = scraping_pressure(contact.slip, contact.normal_force) > 0;
        if (body == nullptr || is_rolling || !is_heard || !(contact.from < contact.to)) {
            continue;
        }
        Pair& pair = pairs[{contact.a, contact.b}];
        if (pair.body == nullptr) {
            pair.body = body;
            order.emplace_back(contact.a, contact.b);
        }
        add_stretch(pair.stretches, {contact.from, contact.to, contact.normal_force, contact.slip});
    }
    for (const auto& names : order) {
        Pair& pair = pairs[names];
        add(*pair.body, 0, is_cloth(names.second) ? kCloth : kSolid, names.second,
            std::move(pair.stretches));
    }
    return sources;
}

}  // namespace carom::sound
