#include "pipeline/picture/colours.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/elementary.h"

namespace carom::pipeline {
namespace {

double encode(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * power(c, 1 / 2.4) - 0.055;
}

double decode(double encoded) {
    const double c = std::clamp(encoded, 0.0, 1.0);
    return c <= 0.04045 ? c / 12.92 : power((c + 0.055) / 1.055, 2.4);
}

// Okabe and Ito, "Color Universal Design", 2008, and lighter ones of the same hues: the lightness
// of those that would be near a cloth's is raised.
constexpr std::uint32_t kYellow = 0xf0e442;
constexpr std::uint32_t kSky = 0x6fc4f5;
constexpr std::uint32_t kOrange = 0xf2a32c;
constexpr std::uint32_t kPurple = 0xe59ac4;
constexpr std::uint32_t kVermilion = 0xf0703a;
constexpr std::uint32_t kWhite = 0xffffff;
constexpr std::uint32_t kDark = 0x0d1013;

}  // namespace

Vec3 encoded_srgb(const Vec3& linear) {
    return {encode(linear.x), encode(linear.y), encode(linear.z)};
}

Vec3 decoded_srgb(const Vec3& encoded) {
    return {decode(encoded.x), decode(encoded.y), decode(encoded.z)};
}

Vec3 srgb_colour(std::uint32_t rgb) {
    return decoded_srgb(
        {((rgb >> 16) & 0xff) / 255.0, ((rgb >> 8) & 0xff) / 255.0, (rgb & 0xff) / 255.0});
}

Vec3 path_colour(std::size_t index) {
    constexpr std::array<std::uint32_t, 6> kColours{kYellow, kSky,    kVermilion,
                                                    kWhite,  kPurple, kOrange};
    return srgb_colour(kColours[index % kColours.size()]);
}

Vec3 aim_colour() {
    return srgb_colour(kWhite);
}
Vec3 tangent_colour() {
    return srgb_colour(kPurple);
}
Vec3 velocity_colour() {
    return srgb_colour(kOrange);
}
Vec3 spin_colour() {
    return srgb_colour(kSky);
}
Vec3 angle_colour() {
    return srgb_colour(kWhite);
}
Vec3 zone_colour() {
    return srgb_colour(kSky);
}
Vec3 text_colour() {
    return srgb_colour(kWhite);
}
Vec3 casing_colour() {
    return srgb_colour(kDark);
}

}  // namespace carom::pipeline
