// The contact law of a world, looked up by numbers that stand for the materials' names.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "core/vectors.h"
#include "sim/contact_law.h"

namespace carom::sim {

/// Those that have laws of their own in every world. Other materials that ContactLaw::pairs names
/// have the numbers above these.
enum class MaterialId : std::uint32_t {
    other,  // every material that the law does not name
    ball,
    cloth,
    cushion,
    floor,
    pocket,
    rail,
};

/// What a pair of materials in contact has in common.
struct ContactNumbers {
    double restitution = 0;
    double friction = 0;
    double rolling_lever = 0;   // as a fraction of the ball's radius
    double spinning_lever = 0;  // likewise
};

class ContactTable {
  public:
    explicit ContactTable(const ContactLaw& law);

    [[nodiscard]] MaterialId id_of(const std::string& material) const;

    /// For two materials in either order. A ball with the cloth, a ball or a cushion follows the
    /// billiard laws, all others follow the law of their pair.
    [[nodiscard]] const ContactNumbers& between(MaterialId a, MaterialId b) const;

  private:
    void set(const std::string& a, const std::string& b, const ContactNumbers& numbers);

    std::map<std::string, MaterialId> ids_;
    std::map<std::pair<MaterialId, MaterialId>, ContactNumbers> pairs_;
    ContactNumbers otherwise_;
};

/// Whether a ball that touches this material there touches a pocket's lining (ball_impact.h).
[[nodiscard]] bool is_lining(MaterialId material, const Vec3& normal);

}  // namespace carom::sim
