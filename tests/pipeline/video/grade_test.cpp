#include "pipeline/video/grade.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "pipeline/video/hdr_view.h"
#include "pipeline/video/view_transform.h"

namespace carom::pipeline {
namespace {

using Colour = Grade::Colour;

/// ACEScct by its own definition (AMPAS S-2016-001, section 4.4.1).
double cct(double light) {
    return light <= 0.0078125 ? 10.5402377416545 * light + 0.0729055341958355
                              : (std::log2(light) + 9.72) / 17.52;
}
double light_of(double code) {
    return code <= 0.155251141552511 ? std::max(0.0, (code - 0.0729055341958355) / 10.5402377416545)
                                     : std::exp2(code * 17.52 - 9.72);
}

void expect_near(const Colour& found, const std::array<double, 3>& expected) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(static_cast<double>(found[i]), expected[i], 3e-4 * expected[i] + 2e-6) << i;
    }
}

TEST(Grade, NothingGiven_ChangesNothing) {
    EXPECT_TRUE(is_neutral({}));
    const Grade grade({});
    for (float light = 1e-6F; light < 60000; light *= 1.37F) {
        const double exact = static_cast<double>(light);
        expect_near(grade({light, 0.5F * light, 2 * light > 65504 ? light : 2 * light}),
                    {exact, 0.5 * exact, 2 * exact > 65504 ? exact : 2 * exact});
    }
}

TEST(Grade, SlopeOffsetAndPower_AreThoseOfTheFormula) {
    GradeSettings settings;
    settings.slope = {1.1, 0.9, 1};
    settings.offset = {-0.02, 0.03, 0};
    settings.power = {1, 1.2, 0.8};
    EXPECT_FALSE(is_neutral(settings));
    const Grade grade(settings);
    for (const double light : {0.001, 0.0078, 0.05, 0.18, 1.0, 7.3, 100.0}) {
        const auto x = static_cast<float>(light);
        expect_near(grade({x, x, x}), {light_of(1.1 * cct(light) - 0.02),
                                       light_of(std::pow(0.9 * cct(light) + 0.03, 1.2)),
                                       light_of(std::pow(cct(light), 0.8))});
    }
}

TEST(Grade, WhiteBalance_MakesItsLightWhite) {
    // Black bodies in linear Rec.709 of luminance 1, from their chromaticities (x, y) after Kim et
    // al. 2002: 2856 K is the CIE's illuminant A at (0.4476, 0.4074).
    const auto light_of_xy = [](double x, double y) {
        const double X = x / y, Z = (1 - x - y) / y;
        return Colour{static_cast<float>(3.2409699 * X - 1.5373832 - 0.4986108 * Z),
                      static_cast<float>(-0.9692436 * X + 1.8759675 + 0.0415551 * Z),
                      static_cast<float>(0.0556301 * X - 0.2039770 + 1.0569715 * Z)};
    };
    GradeSettings settings;
    settings.white_balance = 2856;
    EXPECT_FALSE(is_neutral(settings));
    const Colour white = Grade(settings)(light_of_xy(0.4476, 0.4074));
    for (const float channel : white) {
        EXPECT_NEAR(channel, 1, 0.02);
    }
    // Daylight is blue then, and the other way round.
    const Colour day = Grade(settings)({1, 1, 1});
    EXPECT_GT(day[2], 1.8F * day[0]);
    settings.white_balance = 12000;
    const Colour warm = Grade(settings)({1, 1, 1});
    EXPECT_GT(warm[0], 1.2F * warm[2]);
    // D65 is near the black body of 6,500 K, and a little greener.
    settings.white_balance = 6500;
    const Colour same = Grade(settings)({0.3F, 0.5F, 0.2F});
    EXPECT_NEAR(same[0], 0.3F, 0.02F);
    EXPECT_NEAR(same[1], 0.5F, 0.02F);
    EXPECT_NEAR(same[2], 0.2F, 0.02F);
}

TEST(Grade, OffsetOfAStop_DoublesTheLight) {
    GradeSettings settings;
    settings.offset = Vec3(1 / 17.52);
    expect_near(Grade(settings)({0.18F, 1, 4}), {0.36, 2, 8});
}

TEST(Grade, NoSaturation_LeavesGrey) {
    GradeSettings settings;
    settings.saturation = 0;
    const double code = 0.2126 * cct(0.4) + 0.7152 * cct(0.1) + 0.0722 * cct(0.02);
    const double grey = light_of(code);
    expect_near(Grade(settings)({0.4F, 0.1F, 0.02F}), {grey, grey, grey});
    expect_near(Grade(settings)({0.3F, 0.3F, 0.3F}), {0.3, 0.3, 0.3});
}

TEST(Grade, NumbersThatAreNotLight_AreBlackOrTheBrightest) {
    const Grade grade({});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const Colour found = grade({nan, -1, infinity});
    EXPECT_NEAR(found[0], 0, 1e-7);
    EXPECT_NEAR(found[1], 0, 1e-7);
    EXPECT_NEAR(found[2], 65504, 20);
}

/// A stop by the grade is a stop by the exposure, whatever the view.
TEST(Grade, IsAppliedBeforeEveryView) {
    render::Film film;
    film.width = film.height = 1;
    film.rgba = {0.3F, 0.1F, 0.05F, 1};
    OutputSettings exposed;
    exposed.exposure = 1;
    OutputSettings graded;
    graded.grade.offset = Vec3(1 / 17.52);
    for (const ViewTransform view :
         {ViewTransform::srgb, ViewTransform::filmic, ViewTransform::agx, ViewTransform::raw}) {
        exposed.view = graded.view = view;
        const auto by_exposure = DisplayView(exposed).to_16(film, 0);
        const auto by_grade = DisplayView(graded).to_16(film, 0);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(by_exposure[i], by_grade[i], 20);
        }
    }
    exposed.hdr10 = graded.hdr10 = Hdr10Settings{};
    const auto by_exposure = to_hdr10(film, exposed, 0);
    const auto by_grade = to_hdr10(film, graded, 0);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(by_exposure[i], by_grade[i], 20);
    }
}

}  // namespace
}  // namespace carom::pipeline
