#include "sound/source/defaults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace carom::sound {
namespace {

struct NamedMaterial {
    std::string_view name;
    Material material;
};

constexpr Material kPhenolic{5.84e9, 0.34, 0.02, 0.95};
constexpr Material kPlastic{9e9, 0.35, 0.03, 0.6};
constexpr Material kHardwood{11e9, 0.3, 0.01, 0.5};

constexpr std::array<NamedMaterial, 10> kMaterials{{
    {"ball", kPhenolic},
    {"phenolic", kPhenolic},
    {"tile", kPlastic},
    {"plastic", kPlastic},
    {"wood", kHardwood},
    {"hardwood", kHardwood},
    {"steel", {206e9, 0.29, 0.001, 0.9}},
    {"glass", {70e9, 0.22, 0.002, 0.9}},
    {"slate", {70e9, 0.2, 0.017, 0.6}},
    {"ivory", {9e9, 0.3, 0.02, 0.9}},
}};

constexpr double kCushionStiffness = 55e3;  // N/m

}  // namespace

Material default_material(std::string_view name) {
    const auto* found = std::ranges::find(kMaterials, name, &NamedMaterial::name);
    return found == kMaterials.end() ? kHardwood : found->material;
}

Resonators default_resonators(double ball_mass) {
    Resonators resonators;
    resonators.cushion = {std::numbers::pi * std::sqrt(ball_mass / kCushionStiffness),
                          0,
                          1,
                          0.85,
                          {{140, 5, 0.30},
                           {255, 7, 0.45},
                           {430, 8, 0.45},
                           {720, 9, 0.30},
                           {1150, 10, 0.20},
                           {1900, 10, 0.10}}};
    resonators.bed = {1e-3,
                      -0.2,
                      1,
                      0.5,
                      {{113, 10, 0.35},
                       {190, 12, 0.45},
                       {310, 14, 0.40},
                       {520, 16, 0.35},
                       {840, 18, 0.25},
                       {1350, 20, 0.15}}};
    // The reference is the ball's speed after the strike, which is its impulse over its mass.
    resonators.stick = {1.3e-3,
                        -0.1,
                        3,
                        0,
                        {{1430, 22, 0.25}, {2860, 28, 0.20}, {4290, 32, 0.12}, {310, 12, 0.10}}};
    resonators.pocket = {
        3.5e-3, 0, 1, 0.15, {{110, 2.5, 0.5}, {210, 3, 0.6}, {380, 4, 0.4}, {900, 4, 0.15}}};
    resonators.wood = {0.8e-3, 0, 1, 0.5, resonators.cushion.modes};
    resonators.box_on_cloth = {0.9e-3, 0, 1, 0.3, resonators.bed.modes};
    return resonators;
}

}  // namespace carom::sound
