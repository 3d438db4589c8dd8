#include "render/geometry/refracted_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary_float.h"
#include "core/vectors.h"

namespace carom::render {
namespace {

constexpr double kPi64 = std::numbers::pi;
constexpr int kNodes = 16;  // between which the angle's extrema are sought
constexpr int kSteps = 60;  // at most, towards a root; about eight are taken
constexpr double kExact = 1e-12;

/// Cosine and sine of an angle, as a complex number of length 1.
struct Turn {
    double cosine = 1;
    double sine = 0;

    friend Turn operator*(const Turn& a, const Turn& b) {
        return {a.cosine * b.cosine - a.sine * b.sine, a.cosine * b.sine + a.sine * b.cosine};
    }
    [[nodiscard]] Turn back() const { return {cosine, -sine}; }
};

/// The angle in [0, pi/2] with this sine.
Turn with_sine(double sine) {
    return {std::sqrt(1 - sine * sine), sine};
}

/// The angle between the points as a function of the distance at which a path passes the centre, in
/// units of the radius.
struct SweptAngle {
    double from_a, from_b, index;  // distances from the centre, in radii

    [[nodiscard]] double value(double b) const {
        const Turn bent = with_sine(b).back() * with_sine(b / index);
        const Turn rest = with_sine(b / from_a) * with_sine(b / from_b) * bent * bent;
        return kPi64 - fast_arctangent2(rest.sine, rest.cosine);
    }
    [[nodiscard]] double slope(double b) const {
        const auto part = [&](double size) { return 1 / std::sqrt(size * size - b * b); };
        return 2 * (part(1) - part(index)) - part(from_a) - part(from_b);
    }
};

/// Where `function` has a root between `low` and `high`, at which it has the values `at_low` and
/// `at_high` of different signs: false position with halved values (the Illinois method; Dowell and
/// Jarratt 1971, "A modified regula falsi method for computing the root of an equation").
template <class Function>
double root_between(double low, double high, double at_low, double at_high,
                    const Function& function) {
    int kept = 0;  // which end stayed: -1 low, 1 high
    for (int i = 0; i < kSteps && std::abs(high - low) > kExact; ++i) {
        const double middle = (low * at_high - high * at_low) / (at_high - at_low);
        const double value = function(middle);
        if (std::abs(value) < kExact) {
            return middle;
        }
        if ((value < 0) == (at_low < 0)) {
            low = middle;
            at_low = value;
            at_high *= kept == 1 ? 0.5 : 1;
            kept = 1;
        } else {
            high = middle;
            at_high = value;
            at_low *= kept == -1 ? 0.5 : 1;
            kept = -1;
        }
    }
    return 0.5 * (low + high);
}

class Finder {
  public:
    Finder(const V3f& a, const V3f& b, const V3f& centre, float radius, float index)
        : centre_(centre),
          radius_(static_cast<double>(radius)),
          a_(Vec3(a) - centre_),
          b_(Vec3(b) - centre_),
          swept_{a_.length() / radius_, b_.length() / radius_, static_cast<double>(index)} {}

    [[nodiscard]] RefractedPaths find() {
        if (!(swept_.from_a > 1 && swept_.from_b > 1)) {
            return {};
        }
        axis_ = a_.normalized();
        const Vec3 beside = b_ - axis_ * b_.dot(axis_);
        sine_ = beside.length() / b_.length();
        const Vec3 any =
            std::abs(axis_.x) < 0.6 ? axis_.cross(Vec3(1, 0, 0)) : axis_.cross(Vec3(0, 1, 0));
        across_ = sine_ > 1e-12 ? beside.normalized() : any.normalized();
        const double angle = fast_arctangent2(sine_, b_.dot(axis_) / b_.length());
        // Between neighbouring bounds the angle is monotonic. They are denser towards the rim,
        // where it has a root's slope.
        double last = 0;
        double slope = swept_.slope(0);
        double value = swept_.value(0);
        for (int i = 1; i <= kNodes; ++i) {
            const double fraction = static_cast<double>(i) / kNodes;
            const double next = std::min(fraction * (2 - fraction), 1 - 1e-9);
            const double next_slope = swept_.slope(next);
            if ((slope < 0) != (next_slope < 0)) {
                const double extremum = root_between(last, next, slope, next_slope,
                                                     [&](double b) { return swept_.slope(b); });
                const double at_extremum = swept_.value(extremum);
                add_roots(last, extremum, value, at_extremum, angle);
                last = extremum;
                value = at_extremum;
            }
            const double next_value = swept_.value(next);
            add_roots(last, next, value, next_value, angle);
            last = next;
            slope = next_slope;
            value = next_value;
        }
        return found_;
    }

  private:
    /// Of paths that pass the centre at distances between `low` and `high`, where the angle has
    /// these values: between the points, or on the other side.
    void add_roots(double low, double high, double at_low, double at_high, double angle) {
        add_root(low, high, at_low - angle, at_high - angle, angle, 1);
        const double other = 2 * kPi64 - angle;
        add_root(low, high, at_low - other, at_high - other, other, -1);
    }
    void add_root(double low, double high, double at_low, double at_high, double target,
                  double side) {
        if ((at_low < 0) == (at_high < 0) || found_.count == RefractedPaths::kMost) {
            return;
        }
        add(root_between(low, high, at_low, at_high,
                         [&](double b) { return swept_.value(b) - target; }),
            side);
    }

    void add(double b, double side) {
        const Turn at_a = with_sine(b / swept_.from_a);
        const Turn incidence = with_sine(b);
        const Turn refraction = with_sine(b / swept_.index);
        const double cos_b = with_sine(b / swept_.from_b).cosine;
        const auto place = [&](const Turn& turn) {
            return Vec3(axis_ * turn.cosine + across_ * (side * turn.sine));
        };
        const Turn at_entry = incidence * at_a.back();
        const Turn at_exit = at_entry * Turn{-1, 0} * refraction.back() * refraction.back();
        RefractedPath& path = found_.at[static_cast<std::size_t>(found_.count)];
        path.entry = V3f(centre_ + radius_ * place(at_entry));
        path.exit = V3f(centre_ + radius_ * place(at_exit));
        path.direction = V3f(across_ * (side * at_a.sine) - axis_ * at_a.cosine);
        path.from = static_cast<float>(radius_ * (swept_.from_a * at_a.cosine - incidence.cosine));
        path.inside = static_cast<float>(radius_ * 2 * refraction.cosine);
        path.to = static_cast<float>(radius_ * (swept_.from_b * cos_b - incidence.cosine));
        path.cosine = static_cast<float>(incidence.cosine);
        // b over the sine of the angle between the points has a limit on the axis.
        const double slope = std::abs(swept_.slope(b));
        const double ratio = sine_ > 1e-9 ? b / sine_ : 1 / std::max(slope, 1e-12);
        const double size = radius_ * swept_.from_a * swept_.from_b;
        path.spread = static_cast<float>(
            ratio / (size * size * std::max(slope, 1e-12) * at_a.cosine * cos_b));
        if (path.from > 0 && path.to > 0 && path.cosine > 0) {
            found_.count += 1;
        }
    }

    Vec3 centre_;
    double radius_;
    Vec3 a_, b_;  // from the centre
    SweptAngle swept_;
    Vec3 axis_, across_;  // unit: towards a, and perpendicular to it on the side of b
    double sine_ = 0;     // of the angle between the points
    RefractedPaths found_;
};

}  // namespace

RefractedPaths refracted_paths(const V3f& a, const V3f& b, const V3f& centre, float radius,
                               float index) {
    return Finder(a, b, centre, radius, index).find();
}

}  // namespace carom::render
