#include "sim/scheduler/impact_group.h"

#include <algorithm>

namespace carom::sim {
namespace {

/// Of phenolic resin: often quoted, by which method is not known (docs/sound.md).
constexpr double kModulus = 5.84e9;  // Pa
constexpr double kPoisson = 0.34;
constexpr double kReducedModulus = kModulus / (2 * (1 - kPoisson * kPoisson));

ContactStiffness stiffness_of(const MovingBody& a, const MovingBody& b) {
    return ball_stiffness(a.radius * b.radius / (a.radius + b.radius));
}

class GroupFinder {
  public:
    GroupFinder(std::span<const MovingBody> balls, double time, const EventPredictor& predictor,
                const StaticEnvironment& environment)
        : balls_(balls), time_(time), predictor_(predictor), environment_(environment) {
        group_.indices.reserve(4);
        group_.balls.reserve(4);
        near_.reserve(16);
    }

    ImpactGroup find(std::uint32_t first, std::uint32_t second) {
        add(first);
        add(second);
        const RigidBody& a = group_.balls[0];
        const RigidBody& b = group_.balls[1];
        const double approach = group_.approach();
        if (approach <= kMinLoggedSpeed) {
            return std::move(group_);
        }
        const double mass = a.mass * b.mass / (a.mass + b.mass);
        // Until they part, each changes its speed by less than this.
        const double change = 3 * approach * mass / std::min(a.mass, b.mass);
        speed_ = std::max(length(a.state.velocity), length(b.state.velocity)) + change;
        const double duration =
            contact_time(stiffness_of(balls_[first], balls_[second]), mass, approach);
        add_near(0, duration);
        add_near(1, duration);
        if (group_.indices.size() > 2) {
            // With more balls it takes longer.
            reach_time_ = 3 * duration;
            for (std::size_t i = 0; i < group_.balls.size(); ++i) {
                add_near(i, reach_time_);
            }
            add_contacts();
        }
        return std::move(group_);
    }

  private:
    /// Without the orientation, which costs most and is not needed.
    [[nodiscard]] RigidBody body(std::uint32_t index) const {
        const MovingBody& ball = balls_[index];
        RigidBody body = RigidBody::ball(ball.mass, ball.radius);
        body.state.position = ball.segment.position_at(time_);
        body.state.velocity = ball.segment.velocity_at(time_);
        body.state.angular_velocity = ball.segment.angular_velocity_at(time_);
        return body;
    }

    void add(std::uint32_t index) {
        group_.indices.push_back(index);
        group_.balls.push_back(body(index));
    }

    [[nodiscard]] double gap(const RigidBody& a, const Vec3& centre, double radius) const {
        return length(a.state.position - centre) - a.radius - radius;
    }

    /// Adds the balls that member `i` can reach within `duration`.
    void add_near(std::size_t i, double duration) {
        predictor_.find_near(group_.indices[i], near_);
        for (const std::uint32_t other : near_) {
            const MovingBody& ball = balls_[other];
            if (ball.is_gone() || contains(other)) {
                continue;
            }
            const double closing = speed_ + length(ball.segment.velocity_at(time_));
            if (gap(group_.balls[i], ball.segment.position_at(time_), ball.radius) <=
                closing * duration) {
                add(other);
            }
        }
    }

    [[nodiscard]] bool contains(std::uint32_t index) const {
        return std::find(group_.indices.begin(), group_.indices.end(), index) !=
               group_.indices.end();
    }

    void add_contacts() {
        for (std::size_t k = 1; k < group_.balls.size(); ++k) {
            for (std::size_t i = 0; i < k; ++i) {
                const RigidBody& a = group_.balls[i];
                const RigidBody& b = group_.balls[k];
                const double apart = gap(a, b.state.position, b.radius);
                if (k == 1 || apart <= 2 * speed_ * reach_time_) {
                    group_.contacts.push_back(contact(i, k));
                    group_.contacts.back().gap = k == 1 ? 0 : std::max(apart - kPolish, 0.0);
                }
            }
        }
    }

    [[nodiscard]] GroupContact contact(std::size_t i, std::size_t k) const {
        const MovingBody& a = balls_[group_.indices[i]];
        const MovingBody& b = balls_[group_.indices[k]];
        const Vec3 normal = unit(group_.balls[i].state.position - group_.balls[k].state.position);
        GroupContact contact;
        static_cast<TouchingPair&>(contact) = touching_pair(environment_, a, b, normal);
        contact.first = i;
        contact.second = k;
        contact.first_arm = normal * -a.radius;
        contact.second_arm = normal * b.radius;
        contact.are_spheres = true;
        contact.stiffness = stiffness_of(a, b);
        contact.restitution = pair_law(environment_, a, b, 0).restitution;
        return contact;
    }

    std::span<const MovingBody> balls_;
    double time_;
    const EventPredictor& predictor_;
    const StaticEnvironment& environment_;
    ImpactGroup group_;
    double speed_ = 0;       // of any ball of the group, at most, m/s
    double reach_time_ = 0;  // s
    std::vector<std::uint32_t> near_;
};

}  // namespace

TouchingPair touching_pair(const StaticEnvironment& environment, const MovingBody& a,
                           const MovingBody& b, const Vec3& normal) {
    TouchingPair pair;
    pair.normal = normal;
    const bool has_own = named_law(environment, a, b) != nullptr;
    if (has_own || a.material != MaterialId::ball || b.material != MaterialId::ball) {
        pair.friction = pair_law(environment, a, b, 0).friction;
    }
    pair.is_level =
        !environment.law.hop && a.ground != SupportPlane::none && b.ground != SupportPlane::none;
    return pair;
}

ContactStiffness ball_stiffness(double reduced_radius) {
    return hertz_stiffness(kReducedModulus, reduced_radius);
}

const PairContact* named_law(const StaticEnvironment& environment, const MovingBody& a,
                             const MovingBody& b) {
    const auto& pairs = environment.law.pairs;
    const auto found = pairs.empty() ? pairs.end() : pairs.find(std::minmax(a.name(), b.name()));
    return found != pairs.end() ? &found->second : nullptr;
}

ContactCoefficients pair_law(const StaticEnvironment& environment, const MovingBody& a,
                             const MovingBody& b, double slip_speed) {
    if (const PairContact* named = named_law(environment, a, b)) {
        return {named->restitution, named->friction, 0, 0};
    }
    ContactCoefficients law = environment.contacts.between(a.material, b.material);
    if (a.material == MaterialId::ball && b.material == MaterialId::ball) {
        law.friction = ball_friction(environment.law.ball_ball, slip_speed);
    }
    return law;
}

ImpactGroup find_impact_group(std::span<const MovingBody> balls, std::uint32_t first,
                              std::uint32_t second, double time, const EventPredictor& predictor,
                              const StaticEnvironment& environment) {
    return GroupFinder(balls, time, predictor, environment).find(first, second);
}

}  // namespace carom::sim
