#include "render/light/sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/error.h"

namespace carom::render {

namespace {

constexpr int kColumns = 512;
constexpr int kRows = 256;
constexpr double kPi64 = std::numbers::pi;
constexpr double kLumensPerWatt = 179;
constexpr double kLowest = 0.02;  // cosine to the zenith; at the horizon the model has a pole

/// Perez' distribution: coefficients A to E, each linear in turbidity (table in appendix A.2).
struct Perez {
    std::array<std::array<double, 2>, 5> coefficients;

    [[nodiscard]] double operator()(double turbidity, double cos_zenith, double cos_sun) const {
        const auto k = [&](std::size_t i) {
            return coefficients[i][0] * turbidity + coefficients[i][1];
        };
        const double angle = std::acos(std::clamp(cos_sun, -1.0, 1.0));
        return (1 + k(0) * std::exp(k(1) / cos_zenith)) *
               (1 + k(2) * std::exp(k(3) * angle) + k(4) * cos_sun * cos_sun);
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
    return 1000 * ((4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192);
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

}  // namespace

V3f sky_radiance(const Sky& sky, const V3f& direction) {
    const Vec3 sun = sky.sun.normalized();
    const double t = sky.turbidity;
    const double cos_sun_zenith = sun.z;
    const double angle = std::acos(std::clamp(cos_sun_zenith, -1.0, 1.0));
    const double cos_zenith = std::max(static_cast<double>(direction.z), kLowest);
    const double cos_sun = Vec3(direction).dot(sun);
    const auto relative = [&](const Perez& perez) {
        return perez(t, cos_zenith, cos_sun) / perez(t, 1, cos_sun_zenith);
    };
    const double luminance = std::max(0.0, zenith_luminance(t, angle) * relative(kLuminance));
    return from_chromaticity(zenith_value(kZenithX, t, angle) * relative(kX),
                             zenith_value(kZenithY, t, angle) * relative(kY),
                             luminance / kLumensPerWatt);
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
    V3f irradiance(0, 0, 0);
    for (int row = 0; row < kRows; ++row) {
        const double polar = kPi64 * (row + 0.5) / kRows;
        for (int column = 0; column < kColumns; ++column) {
            // The mapping of Environment: the middle column towards +x, columns to its right
            // towards -y.
            const double azimuth = kPi64 - 2 * kPi64 * (column + 0.5) / kColumns;
            const V3f direction(Vec3(std::sin(polar) * std::cos(azimuth),
                                     std::sin(polar) * std::sin(azimuth), std::cos(polar)));
            V3f& pixel = picture.pixels[static_cast<std::size_t>(row) * kColumns +
                                        static_cast<std::size_t>(column)];
            if (row < kRows / 2) {
                pixel = sky_radiance(sky, direction);
                const double area = 2 * kPi64 * kPi64 / (double{kColumns} * kRows);
                irradiance += pixel * static_cast<float>(std::sin(polar) * std::cos(polar) * area);
            } else {
                pixel = V3f(sky.ground) * irradiance * static_cast<float>(1 / kPi64);
            }
        }
    }
    return picture;
}

}  // namespace carom::render
