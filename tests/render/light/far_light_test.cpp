#include "render/light/far_light.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::render {
namespace {

constexpr std::size_t kDirections = std::size_t{FarLight::kColumns} * FarLight::kColumns / 2;

FarRegion region() {
    FarRegion region;
    region.low = Vec3(-1, -1, -1);
    region.high = Vec3(1, 1, 0);
    region.distance = 2;
    region.cell = 0.25;
    region.cell_growth = 0.1;
    return region;
}

/// On an object's wall at x = 4, with the light of a function of y and z.
template <class Light>
FarLight wall(std::uint32_t object, const Light& light) {
    const FarGrid grid(region());
    std::vector<FarLight::Cell> cells;
    const int level = grid.level(3.0F);
    const float side = grid.side(level);
    for (int z = -20; z < 20; ++z) {
        for (int y = -20; y < 20; ++y) {
            const V3f centre(4, (static_cast<float>(y) + 0.5F) * side,
                             (static_cast<float>(z) + 0.5F) * side);
            const Imath::V3i place = grid.place(centre, level);
            cells.push_back(
                {FarGrid::key(object, 1, level, place), SharedExponent(light(centre.y, centre.z))});
        }
    }
    return {region(), std::move(cells), std::vector<SharedExponent>(kDirections)};
}

TEST(FarGrid, Distance_IsThatFromTheBox) {
    const FarGrid grid(region());
    EXPECT_EQ(grid.distance(V3f(0.5F, 0, -0.5F)), 0);
    EXPECT_FLOAT_EQ(grid.distance(V3f(4, 0, 0)), 3);
    EXPECT_FLOAT_EQ(grid.distance(V3f(4, 5, 0)), 5);
    EXPECT_FALSE(grid.is_far(V3f(2.9F, 0, 0)));
    EXPECT_TRUE(grid.is_far(V3f(3.1F, 0, 0)));
}

/// The box ends at x = 3: from 2.6 m on, ever more paths take surfaces as far.
TEST(FarGrid, SurfacesBecomeFarOverABand) {
    const FarGrid grid(region());
    for (const float y : {0.0F, 2.0F}) {
        EXPECT_FALSE(grid.counts_as_far(V3f(2.59F, y, 0), 1));
        EXPECT_FALSE(grid.counts_as_far(V3f(2.8F, y, 0), 0.49F));
        EXPECT_TRUE(grid.counts_as_far(V3f(2.8F, y, 0), 0.51F));
        EXPECT_TRUE(grid.counts_as_far(V3f(3.01F, y, 0), 0));
    }
    EXPECT_FALSE(grid.counts_as_far(V3f(0, 0, 1.99F), 1)) << "not above the table";
}

TEST(FarGrid, WayOut_EndsAtTheNearBox) {
    const FarGrid grid(region());
    EXPECT_FLOAT_EQ(grid.way_out(V3f(0, 0, 0), V3f(1, 0, 0)), 3);
    EXPECT_FLOAT_EQ(grid.way_out(V3f(0, 0, 0), V3f(0, 0, -1)), 3);
    EXPECT_FLOAT_EQ(grid.way_out(V3f(-5, 0, 0), V3f(1, 0, 0)), 8);
    EXPECT_EQ(grid.way_out(V3f(-5, 0, 0), V3f(-1, 0, 0)), 0);
    EXPECT_EQ(grid.way_out(V3f(-5, 0, 0), V3f(0, 1, 0)), 0);
}

/// Sides of 1/4 m up to 5 m, of 1/2 m up to 10 m ...
TEST(FarGrid, Level_GrowsWithTheDistance) {
    const FarGrid grid(region());
    EXPECT_EQ(grid.level(3.0F), 0);
    EXPECT_EQ(grid.level(4.9F), 0);
    EXPECT_EQ(grid.level(5.1F), 1);
    EXPECT_EQ(grid.level(10.1F), 2);
    EXPECT_EQ(grid.level(1e6F), FarGrid::kMostLevel);
    EXPECT_FLOAT_EQ(grid.side(2), 1);
}

TEST(FarGrid, Neighbours_AreTheKeysOfThePlacesBeside) {
    const Imath::V3i place(-3, 0, 17);
    const std::uint64_t key = FarGrid::key(7, 4, 2, place);
    EXPECT_EQ(FarGrid::object_of(key), 7U);
    for (int axis = 0; axis < 3; ++axis) {
        Imath::V3i step(0, 0, 0);
        step[axis] = axis == 1 ? -1 : 1;
        EXPECT_EQ(FarGrid::neighbour(key, step.x, step.y, step.z),
                  FarGrid::key(7, 4, 2, place + step));
    }
}

TEST(FarGrid, Face_IsTheAxisThatTheNormalIsNearest) {
    EXPECT_EQ(FarGrid::face(V3f(0.8F, 0.1F, -0.5F)), 0);
    EXPECT_EQ(FarGrid::face(V3f(-0.8F, 0.1F, -0.5F)), 1);
    EXPECT_EQ(FarGrid::face(V3f(0.1F, 0.8F, -0.5F)), 2);
    EXPECT_EQ(FarGrid::face(V3f(0.1F, 0.2F, -0.9F)), 5);
}

TEST(FarLight, Wall_IsInterpolated) {
    const FarLight light = wall(3, [](float y, float z) { return V3f(8 + y, 8 + z, 8 + y - z); });
    for (const V3f& at : {V3f(4, 0.3F, 0.9F), V3f(4, -1.77F, 0.01F), V3f(4, 2, -2)}) {
        const V3f found = light.irradiance(3, at, V3f(-1, 0, 0));
        EXPECT_NEAR(found.x, 8 + at.y, 0.03);
        EXPECT_NEAR(found.y, 8 + at.z, 0.03);
        EXPECT_NEAR(found.z, 8 + at.y - at.z, 0.03);
    }
}

/// Of a place without cells, the mean of its object, and of an object without cells that of all.
TEST(FarLight, PlacesWithoutCells_HaveTheMean) {
    const FarLight light = wall(3, [](float y, float) { return V3f(y > 0 ? 3.0F : 1.0F); });
    EXPECT_NEAR(light.irradiance(3, V3f(4, 0, 0), V3f(0, 0, 1)).x, 2, 0.01);
    EXPECT_NEAR(light.irradiance(2, V3f(4, 0, 0), V3f(-1, 0, 0)).x, 2, 0.01);
    EXPECT_NEAR(light.irradiance(9, V3f(4, 0, 0), V3f(-1, 0, 0)).x, 2, 0.01);
}

/// A hole in a wall has the light of its rim, however bright the rest of the wall is.
TEST(FarLight, Holes_HaveTheLightAroundThem) {
    const FarLight whole = wall(
        3, [](float y, float z) { return V3f(std::abs(y) < 2 && std::abs(z) < 2 ? 1.0F : 50.0F); });
    const FarGrid grid(region());
    std::vector<FarLight::Cell> cells = whole.cells();
    std::erase_if(cells, [&](const FarLight::Cell& cell) {
        for (int z = -2; z <= 2; ++z) {
            for (int y = -2; y <= 2; ++y) {
                const V3f at(4, 0.1F + 0.25F * static_cast<float>(y),
                             0.1F + 0.25F * static_cast<float>(z));
                if (cell.key == FarGrid::key(3, 1, 0, grid.place(at, 0))) {
                    return true;
                }
            }
        }
        return false;
    });
    EXPECT_EQ(cells.size(), whole.cells().size() - 25);
    const FarLight holed(region(), cells, std::vector<SharedExponent>(kDirections));
    EXPECT_EQ(holed.irradiance(3, V3f(4, 0.1F, 0.1F), V3f(-1, 0, 0)), V3f(1));
}

/// Between two faces the light of both counts.
TEST(FarLight, SlantedSurfaces_MixTheFaces) {
    const FarGrid grid(region());
    const Imath::V3i place = grid.place(V3f(4.1F, 0.1F, 0.1F), 0);
    const FarLight light(region(),
                         {{FarGrid::key(0, 0, 0, place), SharedExponent(V3f(1))},
                          {FarGrid::key(0, 2, 0, place), SharedExponent(V3f(3))}},
                         std::vector<SharedExponent>(kDirections));
    const V3f at(4.1F, 0.1F, 0.1F);
    EXPECT_NEAR(light.irradiance(0, at, V3f(1, 0, 0)).x, 1, 0.01);
    EXPECT_NEAR(light.irradiance(0, at, V3f(0, 1, 0)).x, 3, 0.01);
    EXPECT_NEAR(light.irradiance(0, at, V3f(1, 1, 0).normalized()).x, 2, 0.01);
}

TEST(FarLightFile, Light_IsReadAsItWasWritten) {
    const FarLight light = wall(3, [](float y, float z) { return V3f(8 + y, 8 + z, 0.125F); });
    const std::string bytes = encoded(light, "inputs");
    EXPECT_LT(bytes.size(), 8 * light.cells().size() + 4 * kDirections);
    const auto read = decoded(bytes, "inputs", region());
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(read->cells(), light.cells());
    for (std::size_t i = 0; i < kDirections; ++i) {
        ASSERT_EQ(read->panorama()[i].bits(), light.panorama()[i].bits());
    }
}

TEST(FarLightFile, OtherInputsAndDamage_GiveNothing) {
    const FarLight light = wall(0, [](float, float) { return V3f(1); });
    const std::string bytes = encoded(light, "inputs");
    EXPECT_EQ(decoded(bytes, "others", region()), nullptr);
    EXPECT_EQ(decoded("", "inputs", region()), nullptr);
    for (const std::size_t cut : {std::size_t{5}, bytes.size() / 2, bytes.size() - 1}) {
        EXPECT_EQ(decoded(std::string_view(bytes).substr(0, cut), "inputs", region()), nullptr);
    }
    for (const std::size_t place : {std::size_t{3}, std::size_t{30}, bytes.size() / 2}) {
        std::string damaged = bytes;
        damaged[place] = static_cast<char>(damaged[place] ^ 4);
        EXPECT_EQ(decoded(damaged, "inputs", region()), nullptr) << place;
    }
}

}  // namespace
}  // namespace carom::render
