#include "sim/contact_law.h"

#include <algorithm>

namespace carom::sim {
namespace {

/// A ball and the surroundings of a table. No values are published; these were chosen so that a
/// ball stops dead in a lined pocket, rebounds from a wooden rail about as from the slate, and
/// rolls some metres on a floor.
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

BallCushion usual_cushion(CushionModel model) {
    // Rolling snooker balls keep 0.925 - 0.085 (v - 1.9) of their speed above 1.9 m/s (Mathavan et
    // al. 2010, Fig. 7a); this fall gives that. Faster balls were not measured; with the least
    // value a ball of 9 m/s makes 4.5 lengths of a pool table, and makers of cushions ask for four.
    const RestitutionFall fall{1.9, 0.09, 0.7};
    switch (model) {
        case CushionModel::mirror:
            return {model, 0.85, 0};
        case CushionModel::han2005:
            break;
        case CushionModel::mathavan2010:
            // Their section 4: the best fit to rolling snooker balls below 1.5 m/s.
            return {model, 0.98, 0.14, fall};
    }
    return {CushionModel::han2005, 0.85, 0.2, fall};
}

double restitution_at(const BallCushion& law, double speed) {
    const RestitutionFall& fall = law.fall;
    const double fallen = law.restitution - fall.slope * std::max(speed - fall.above, 0.0);
    return std::max(fallen, std::min(fall.least, law.restitution));
}

const PairContact& ContactLaw::between(const std::string& a, const std::string& b) const {
    const std::string& first = a <= b ? a : b;
    const std::string& second = a <= b ? b : a;
    const auto found = pairs.find({first, second});
    if (found != pairs.end()) {
        return found->second;
    }
    const PairContact* law = built_in(first, second);
    return law != nullptr ? *law : otherwise;
}

}  // namespace carom::sim
