// The contact law of a world, looked up by material numbers instead of names.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "core/vectors.h"
#include "sim/contact_law.h"

namespace carom::sim {

/// The materials that every world knows. Other materials named in ContactLaw::pairs get the numbers
/// above these.
enum class MaterialId : std::uint32_t {
    other,  // any material that the law does not name
    ball,
    cloth,
    cushion,
    floor,
    pocket,
    rail,
};

/// Coefficients of a pair of materials in contact.
struct ContactCoefficients {
    double restitution = 0;
    double friction = 0;
    /// Resistances of balls to rolling and to turning about the normal: moment / normal force, as a
    /// fraction of MovingBody::rolling_length.
    double rolling = 0;
    double torsional = 0;
    double solid_rolling = 0;  // both, of other bodies
};

class ContactTable {
  public:
    explicit ContactTable(const ContactLaw& law);

    [[nodiscard]] MaterialId id_of(const std::string& material) const;

    /// The coefficients of two materials, in either order. A ball follows the billiard laws on the
    /// cloth, a ball or a cushion; all other pairs follow the law of the pair.
    [[nodiscard]] const ContactCoefficients& between(MaterialId a, MaterialId b) const;

  private:
    void set(const std::string& a, const std::string& b, const ContactCoefficients& numbers);

    std::map<std::string, MaterialId> ids_;
    std::map<std::pair<MaterialId, MaterialId>, ContactCoefficients> pairs_;
    ContactCoefficients otherwise_;
};

/// Whether a surface of this material and normal is a pocket's lining (ball_impact.h).
[[nodiscard]] bool is_lining(MaterialId material, const Vec3& normal);

}  // namespace carom::sim
