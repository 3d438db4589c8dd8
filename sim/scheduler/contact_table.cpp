#include "sim/scheduler/contact_table.h"

#include <algorithm>
#include <cmath>

#include "sim/impact/ball_impact.h"

namespace carom::sim {
namespace {

// A ball that rolls without slip decelerates at mu_r g if the resisting moment is 7/5 mu_r R N.
constexpr double kRollingArm = 1.4;

ContactCoefficients coefficients_of(const PairContact& pair) {
    const double lever = kRollingArm * pair.rolling_friction;
    return {pair.restitution, pair.friction, lever, lever};
}

}  // namespace

ContactTable::ContactTable(const ContactLaw& law)
    : ids_{{"ball", MaterialId::ball},       {"cloth", MaterialId::cloth},
           {"cushion", MaterialId::cushion}, {"floor", MaterialId::floor},
           {"pocket", MaterialId::pocket},   {"rail", MaterialId::rail}},
      otherwise_(coefficients_of(law.otherwise)) {
    for (const auto& [name, id] : ids_) {
        set("ball", name, coefficients_of(law.between("ball", name)));
    }
    for (const auto& [names, pair] : law.pairs) {
        for (const std::string& name : {names.first, names.second}) {
            ids_.emplace(name, static_cast<MaterialId>(ids_.size() + 1));
        }
        set(names.first, names.second, coefficients_of(pair));
    }
    const BallCloth& cloth = law.ball_cloth;
    set("ball", "cloth",
        {cloth.restitution, cloth.sliding_friction, kRollingArm * cloth.rolling_friction,
         cloth.spinning_friction});
    // Impacts use the friction at their own slip; balls in lasting contact slip slowly.
    set("ball", "ball", {law.ball_ball.restitution, ball_friction(law.ball_ball, 0), 0, 0});
    set("ball", "cushion", {law.ball_cushion.restitution, law.ball_cushion.friction, 0, 0});
}

MaterialId ContactTable::id_of(const std::string& material) const {
    const auto found = ids_.find(material);
    return found != ids_.end() ? found->second : MaterialId::other;
}

const ContactCoefficients& ContactTable::between(MaterialId a, MaterialId b) const {
    const auto found = pairs_.find(std::minmax({a, b}));
    return found != pairs_.end() ? found->second : otherwise_;
}

void ContactTable::set(const std::string& a, const std::string& b,
                       const ContactCoefficients& numbers) {
    pairs_[std::minmax({id_of(a), id_of(b)})] = numbers;
}

bool is_lining(MaterialId material, const Vec3& normal) {
    constexpr double kSteep = 0.3;
    return material == MaterialId::pocket && std::abs(normal.z) < kSteep;
}

}  // namespace carom::sim
