#include "sim/scheduler/contact_table.h"

#include <algorithm>
#include <cmath>

#include "sim/impact/ball_impact.h"

namespace carom::sim {
namespace {

ContactCoefficients coefficients_of(const PairContact& pair) {
    const double rolling = pair.rolling_friction.value_or(0);
    return {pair.restitution, pair.friction, rolling, rolling,
            pair.rolling_friction.value_or(kUsualRollingFriction)};
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
    constexpr double kRollingLength = 1.4;  // of a ball, in radii
    set("ball", "cloth",
        {cloth.restitution, cloth.sliding_friction, cloth.rolling_friction,
         cloth.spinning_friction / kRollingLength});
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
