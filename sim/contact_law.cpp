#include "sim/contact_law.h"

namespace carom::sim {
namespace {

/// A ball with what surrounds a table. Nobody has published these; they were chosen so that a ball
/// falls dead in a lined pocket, rebounds from a wooden rail about as from the slate, and rolls
/// some metres on a floor.
const PairContact* built_in(const std::string& a, const std::string& b) {
    static const std::map<std::pair<std::string, std::string>, PairContact> laws{
        {{"ball", "floor"}, {0.6, 0.3, 0.015}},
        {{"ball", "pocket"}, {0.15, 0.6, 0.03}},
        {{"ball", "rail"}, {0.5, 0.3, 0.01}},
    };
    const auto found = laws.find({a, b});
    return found != laws.end() ? &found->second : nullptr;
}

}  // namespace

const PairContact& ContactLaw::between(const std::string& a, const std::string& b) const {
    const std::string& first = a <= b ? a : b;
    const std::string& second = a <= b ? b : a;
    const auto found = pairs.find({first, second});
    if (found != pairs.end())
        return found->second;
    const PairContact* law = built_in(first, second);
    return law != nullptr ? *law : otherwise;
}

}  // namespace carom::sim
