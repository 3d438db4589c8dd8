#include "pipeline/shot/ball_set.h"

#include <algorithm>
#include <array>

namespace carom::pipeline {

namespace {

using render::BallTexture;

// Linear albedos of glossy phenolic resin, chosen by eye against photographs of lit sets.
const Vec3 kWhite{0.82, 0.79, 0.70};
const Vec3 kYellow{0.82, 0.50, 0.03};
const Vec3 kRed{0.52, 0.018, 0.015};

constexpr std::array<std::string_view, 15> kPoolNames{
    "one",  "two", "three",  "four",   "five",     "six",      "seven",  "eight",
    "nine", "ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen"};

const std::array<Vec3, 8> kPoolColours{kYellow,                     // 1 and 9
                                       Vec3(0.012, 0.055, 0.330),   // 2 and 10: blue
                                       kRed,                        // 3 and 11
                                       Vec3(0.095, 0.016, 0.170),   // 4 and 12: purple
                                       Vec3(0.760, 0.170, 0.014),   // 5 and 13: orange
                                       Vec3(0.008, 0.150, 0.060),   // 6 and 14: green
                                       Vec3(0.190, 0.020, 0.018),   // 7 and 15: maroon
                                       Vec3(0.011, 0.011, 0.012)};  // 8: black

BallTexture plain(const Vec3& colour) {
    BallTexture texture;
    texture.colour = colour;
    return texture;
}

BallTexture pool_texture(std::string_view name) {
    const auto* const found = std::find(kPoolNames.begin(), kPoolNames.end(), name);
    if (found == kPoolNames.end()) {
        BallTexture texture = plain(kWhite);
        texture.spots = name == "cue" ? 6 : 0;  // the spots make its spin visible
        return texture;
    }
    const auto index = static_cast<std::size_t>(found - kPoolNames.begin());
    BallTexture texture = plain(kPoolColours[index % 8]);
    texture.number = static_cast<int>(index) + 1;
    texture.striped = index >= 8;
    return texture;
}

BallTexture snooker_texture(std::string_view name) {
    struct Known {
        std::string_view name;
        Vec3 colour;
    };
    static const std::array<Known, 6> known{{{"yellow", kYellow},
                                             {"green", Vec3(0.008, 0.170, 0.060)},
                                             {"brown", Vec3(0.150, 0.045, 0.016)},
                                             {"blue", Vec3(0.012, 0.085, 0.400)},
                                             {"pink", Vec3(0.760, 0.230, 0.260)},
                                             {"black", Vec3(0.011, 0.011, 0.012)}}};
    if (name == "red" || name.starts_with("red_")) {
        return plain(kRed);
    }
    for (const Known& ball : known) {
        if (ball.name == name) {
            return plain(ball.colour);
        }
    }
    return plain(kWhite);
}

BallTexture carom_texture(std::string_view name) {
    if (name == "red") {
        return plain(kRed);
    }
    return plain(name == "yellow" ? kYellow : kWhite);
}

}  // namespace

BallMeasures ball_measures(BallSet set) {
    switch (set) {
        case BallSet::pool:
            // WPA, Tournament Table & Equipment Specifications: 2 1/4 in, 5.5 to 6 oz.
            return {0.028575, 0.170097};
        case BallSet::snooker:
            // WPBSA, Rules of Snooker, section 1, rule 2: 52.5 mm +- 0.05 mm, all equally heavy
            // within 3 g. The mass is ours, rounded; Mathavan, Jackson & Parkin 2010 calculate with
            // 140.6 g.
            return {0.02625, 0.140};
        case BallSet::carom:
            // UMB, World Rules of Carom Billiard, article 12: 61 to 61.5 mm, 205 to 220 g.
            return {0.03075, 0.210};
    }
    return {};
}

BallTexture ball_texture(BallSet set, std::string_view name) {
    switch (set) {
        case BallSet::pool:
            return pool_texture(name);
        case BallSet::snooker:
            return snooker_texture(name);
        case BallSet::carom:
            return carom_texture(name);
    }
    return {};
}

}  // namespace carom::pipeline
