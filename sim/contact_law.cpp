#include "sim/contact_law.h"

namespace carom::sim {

const PairContact& ContactLaw::between(const std::string& a, const std::string& b) const {
    const auto found = pairs.find(a <= b ? std::pair(a, b) : std::pair(b, a));
    return found != pairs.end() ? found->second : otherwise;
}

}  // namespace carom::sim
