#include "render/light/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/elementary.h"
#include "core/error.h"
#include "render/light/light_power.h"

namespace carom::render {

namespace {

constexpr int kColumns = 512;
constexpr int kRows = 256;
constexpr double kPi64 = std::numbers::pi;
constexpr double kLowest = 0.02;  // cosine to the zenith; at the horizon the model has a pole

/// Cosine and angle (rad) between a direction and the sun.
struct FromSun {
    explicit FromSun(double the_cosine)
        : cosine(the_cosine), angle(arccosine(std::clamp(the_cosine, -1.0, 1.0))) {}
    double cosine;
    double angle;
};

/// Perez' distribution: coefficients A to E, each linear in turbidity (table in appendix A.2).
struct Perez {
    std::array<std::array<double, 2>, 5> coefficients;

    /// The first factor, which depends on the height above the horizon.
    [[nodiscard]] double of_height(double turbidity, double cos_zenith) const {
        return 1 + k(0, turbidity) * exponential(k(1, turbidity) / cos_zenith);
    }

    /// The second factor.
    [[nodiscard]] double of_sun(double turbidity, const FromSun& sun) const {
        return 1 + k(2, turbidity) * exponential(k(3, turbidity) * sun.angle) +
               k(4, turbidity) * sun.cosine * sun.cosine;
    }

    [[nodiscard]] double k(std::size_t i, double turbidity) const {
        return coefficients[i][0] * turbidity + coefficients[i][1];
    }
};

constexpr Perez kLuminance{{{{0.1787, -1.4630},
                             {-0.3554, 0.4275},
                             {-0.0227, 5.3251},
                             {0.1206, -2.5771},
                             {-0.0670, 0.3703}}}};
constexpr Perez kX{{{{-0.0193, -0.2592},
                     {-0.0665, 0.0008},
                     {-0.0004, 0.2125},
                     {-0.0641, -0.8989},
                     {-0.0033, 0.0452}}}};
constexpr Perez kY{{{{-0.0167, -0.2608},
                     {-0.0950, 0.0092},
                     {-0.0079, 0.2102},
                     {-0.0441, -1.6537},
                     {-0.0109, 0.0529}}}};

/// Rows: T^2, T, 1; columns: the sun's zenith angle to the powers 3, 2, 1, 0.
using Zenith = std::array<std::array<double, 4>, 3>;
constexpr Zenith kZenithX{{{0.00166, -0.00375, 0.00209, 0},
                           {-0.02903, 0.06377, -0.03202, 0.00394},
                           {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr Zenith kZenithY{{{0.00275, -0.00610, 0.00317, 0},
                           {-0.04214, 0.08970, -0.04153, 0.00516},
                           {0.15346, -0.26756, 0.06670, 0.26688}}};

double zenith_value(const Zenith& table, double turbidity, double angle) {
    double sum = 0;
    for (const auto& row : table) {
        sum = sum * turbidity + ((row[0] * angle + row[1]) * angle + row[2]) * angle + row[3];
    }
    return sum;
}

/// cd/m^2
double zenith_luminance(double turbidity, double angle) {
    const double chi = (4.0 / 9 - turbidity / 120) * (kPi64 - 2 * angle);
    return 1000 * ((4.0453 * turbidity - 4.9710) * tangent(chi) - 0.2155 * turbidity + 2.4192);
}

/// Linear Rec.709 of a chromaticity and luminance (IEC 61966-2-1, from XYZ).
V3f from_chromaticity(double x, double y, double luminance) {
    const double big_x = x / y * luminance;
    const double big_z = (1 - x - y) / y * luminance;
    const auto channel = [&](double a, double b, double c) {
        return static_cast<float>(std::max(0.0, a * big_x + b * luminance + c * big_z));
    };
    return {channel(3.2406, -1.5372, -0.4986), channel(-0.9689, 1.8758, 0.0415),
            channel(0.0557, -0.2040, 1.0570)};
}

/// The sky of a given sun and turbidity.
class Model {
  public:
    explicit Model(const Sky& sky) : sun_(sky.sun.normalized()), turbidity_(sky.turbidity) {
        const FromSun zenith(sun_.z);
        for (std::size_t i = 0; i < kDistributions.size(); ++i) {
            at_zenith_[i] = kDistributions[i].of_height(turbidity_, 1) *
                            kDistributions[i].of_sun(turbidity_, zenith);
        }
        zenith_luminance_ = zenith_luminance(turbidity_, zenith.angle);
        zenith_x_ = zenith_value(kZenithX, turbidity_, zenith.angle);
        zenith_y_ = zenith_value(kZenithY, turbidity_, zenith.angle);
    }

    /// What all directions of one height share.
    using Height = std::array<double, 3>;
    [[nodiscard]] Height height(const V3f& direction) const {
        const double cos_zenith = std::max(static_cast<double>(direction.z), kLowest);
        Height factors{};
        for (std::size_t i = 0; i < factors.size(); ++i) {
            factors[i] = kDistributions[i].of_height(turbidity_, cos_zenith) / at_zenith_[i];
        }
        return factors;
    }

    [[nodiscard]] V3f radiance(const V3f& direction, const Height& height) const {
        const FromSun sun(Vec3(direction).dot(sun_));
        const auto relative = [&](std::size_t i) {
            return height[i] * kDistributions[i].of_sun(turbidity_, sun);
        };
        const double luminance = std::max(0.0, zenith_luminance_ * relative(0));
        return from_chromaticity(zenith_x_ * relative(1), zenith_y_ * relative(2),
                                 luminance / kLumensPerWatt);
    }

  private:
    static constexpr std::array<Perez, 3> kDistributions{kLuminance, kX, kY};
    Vec3 sun_;
    double turbidity_;
    std::array<double, 3> at_zenith_{};
    double zenith_luminance_ = 0;  // cd/m^2
    double zenith_x_ = 0;
    double zenith_y_ = 0;
};

}  // namespace

V3f environment_radiance(const Sky& sky, const V3f& direction) {
    const Model model(sky);
    return model.radiance(direction, model.height(direction));
}

LinearImage sky_picture(const Sky& sky) {
    if (!(sky.sun.length() > 0) || !(sky.sun.normalized().z > 1e-3)) {
        throw Error("the sky's sun is not above the horizon");
    }
    if (!(sky.turbidity >= 2 && sky.turbidity <= 10)) {
        throw Error("the sky's turbidity is not between 2 and 10");
    }
    LinearImage picture;
    picture.width = kColumns;
    picture.height = kRows;
    picture.pixels.resize(std::size_t{kColumns} * kRows);
    // The mapping of Environment: the middle column towards +x, columns to its right towards -y.
    std::vector<SinCos> around;
    around.reserve(kColumns);
    for (int column = 0; column < kColumns; ++column) {
        around.push_back(sin_cos(kPi64 - 2 * kPi64 * (column + 0.5) / kColumns));
    }
    const Model model(sky);
    V3f irradiance(0, 0, 0);
    V3f* pixel = picture.pixels.data();
    for (int row = 0; row < kRows; ++row) {
        const SinCos from_top = sin_cos(kPi64 * (row + 0.5) / kRows);
        const Model::Height height = model.height(V3f(Vec3(0, 0, from_top.cos)));
        const double area = 2 * kPi64 * kPi64 / (double{kColumns} * kRows);
        for (const SinCos& column : around) {
            if (row < kRows / 2) {
                const Vec3 direction(from_top.sin * column.cos, from_top.sin * column.sin,
                                     from_top.cos);
                *pixel = model.radiance(V3f(direction), height);
                irradiance += *pixel * static_cast<float>(from_top.sin * from_top.cos * area);
            } else {
                *pixel = V3f(sky.ground) * irradiance * static_cast<float>(1 / kPi64);
            }
            ++pixel;
        }
    }
    return picture;
}

}  // namespace carom::render
