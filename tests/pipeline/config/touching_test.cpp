// Balls that are placed against a cushion, an object or another ball.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "load.h"

namespace carom::pipeline {
namespace {

constexpr double kRadius = 0.028575;

Vec3 place_of(const Shot& shot, const std::string& name) {
    for (const sim::Body& body : shot.world.bodies) {
        if (body.name == name) {
            return body.pose.position;
        }
    }
    return {};
}

std::string pool(const std::string& balls) {
    return "table: {kind: pool}\nballs: {" + balls + "}\n";
}

std::string problem(const std::string& sections) {
    return first_problem("carom: 1\n" + kCamera + sections);
}

TEST(TouchingCushion, IsOneRadiusFromTheEdgeOfTheField) {
    const Shot shot = load_sections(pool(
        "a: {touching: {cushion: back, along: 0.3 m}}, b: {touching: {cushion: left, along: -20 "
        "cm}}, "
        "c: {touching: {cushion: front, along: -0.5}}, d: {touching: {cushion: right, along: 0}}"));
    EXPECT_LT((place_of(shot, "a") - Vec3(0.3, 0.635 - kRadius, kRadius)).length(), 1e-12);
    EXPECT_LT((place_of(shot, "b") - Vec3(-1.27 + kRadius, -0.2, kRadius)).length(), 1e-12);
    EXPECT_LT((place_of(shot, "c") - Vec3(-0.5, -0.635 + kRadius, kRadius)).length(), 1e-12);
    EXPECT_LT((place_of(shot, "d") - Vec3(1.27 - kRadius, 0, kRadius)).length(), 1e-12);
}

TEST(TouchingCushion, OfAnotherSizeTouchesTheNoseOrTheFaceUnderIt) {
    const Shot shot = load_sections(
        pool("a: {at: [0, 0]}, small: {touching: {cushion: back, along: 0.3}, radius: 24 mm}, "
             "large: {touching: {cushion: back, along: 0.5}, radius: 32 mm}"));
    // The nose is inside of the edge that the usual ball touches.
    const double height = 0.635 * 2 * kRadius;
    const auto reach = [&](double radius) {
        return std::sqrt(radius * radius - std::pow(height - radius, 2));
    };
    const double nose = 0.635 - kRadius + reach(kRadius);
    EXPECT_NEAR(place_of(shot, "large").y, nose - reach(0.032), 1e-12);
    // The face leans back by half a degree more than the usual ball needs to touch the nose.
    const double lean = std::asin(height / kRadius - 1) + 0.5 * std::acos(-1) / 180;
    EXPECT_NEAR(place_of(shot, "small").y,
                nose - (0.024 - (height - 0.024) * std::sin(lean)) / std::cos(lean), 1e-12);
}

TEST(TouchingObject, IsAgainstItsFace) {
    const Shot shot = load_sections(pool("a: {touching: {object: box, direction: 180 deg}}, "
                                         "b: {touching: {object: pin, direction: 90 deg}}, "
                                         "c: {touching: {object: box, direction: 45 deg}}, "
                                         "d: {touching: {ball: a, direction: 180 deg}}") +
                                    "objects:\n"
                                    "  box: {box: [0.2, 0.1, 0.1], at: [0.5, 0.1, 0.05], "
                                    "physics: {kind: fixed}}\n"
                                    "  pin: {cylinder: {radius: 30 mm, height: 0.2}, "
                                    "at: [-0.4, -0.3, 0.1], physics: {kind: fixed}}\n");
    EXPECT_LT((place_of(shot, "a") - Vec3(0.4 - kRadius, 0.1, kRadius)).length(), 1e-9);
    EXPECT_LT((place_of(shot, "b") - Vec3(-0.4, -0.27 + kRadius, kRadius)).length(), 1e-9);
    // On the way at 45 degrees it touches the long face: at the height of its centre from it.
    EXPECT_LT((place_of(shot, "c") - Vec3(0.5 + 0.05 + kRadius, 0.15 + kRadius, kRadius)).length(),
              1e-9);
    EXPECT_LT((place_of(shot, "d") - place_of(shot, "a") - Vec3(-2 * kRadius, 0, 0)).length(),
              1e-9);
}

TEST(Touching, MistakesAreReported) {
    EXPECT_EQ(problem(pool("a: {touching: {cushion: back, along: 0}}")),
              "the cushion has no nose there: it is the place of a pocket, or beyond the end");
    EXPECT_EQ(problem(pool("a: {touching: {cushion: left, along: 0.6}}")),
              "the cushion has no nose there: it is the place of a pocket, or beyond the end");
    EXPECT_EQ(problem("balls: {a: {touching: {cushion: left, along: 0}}}\n"),
              "the shot has no table with cushions");
    EXPECT_EQ(problem(pool("a: {touching: {cushion: top, along: 0}}")),
              "'cushion' must be one of front, right, back and left, not 'top'");
    EXPECT_EQ(problem(pool("a: {touching: {cushion: back}}, b: {at: [0, 0]}")),
              "'cushion' needs the key 'along'");
    EXPECT_EQ(problem(pool("a: {touching: {ball: b}}, b: {at: [0, 0]}")),
              "'ball' needs the key 'direction'");
    EXPECT_EQ(problem(pool("a: {touching: {cushion: back, along: 0.3, direction: 0 deg}}")),
              "'direction' has no meaning without 'ball' or 'object'");
    EXPECT_EQ(problem(pool("a: {touching: {}}")),
              "'touching' of ball 'a' needs one of 'ball', 'object' or 'cushion'");
    EXPECT_EQ(problem(pool("a: {touching: {object: cushion, direction: 0 deg}}")),
              "'cushion' is a part of the table, no object; a side of the table is given by the "
              "key 'cushion'");
    EXPECT_EQ(problem(pool("a: {touching: {object: box, direction: 0 deg}}") +
                      "objects: {box: {box: [0.2, 0.1, 0.1], at: [0.5, 0.1, 0.05]}}\n"),
              "'box' has no physics, so nothing can touch it");
    EXPECT_EQ(problem(pool("a: {touching: {object: box, direction: 0 deg}}") +
                      "objects: {box: {box: [0.2, 0.1, 0.1], at: [0.5, 0.1, 0.5], physics: {kind: "
                      "fixed}}}\n"),
              "'box' has no side there that a ball on the cloth could touch");
}

}  // namespace
}  // namespace carom::pipeline
