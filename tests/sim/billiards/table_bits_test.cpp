// What balls meet of a table is pinned bit for bit: drawing a table differently must not change it,
// because bakes depend on it.
#include <bit>
#include <map>

#include <gtest/gtest.h>

#include "core/hash.h"
#include "mesh_helpers.h"

namespace carom::sim::billiards {
namespace {

class Bits {
  public:
    void add(double value) { hasher_.add(std::bit_cast<std::uint64_t>(value)); }
    void add(const Vec2& v) { add(v.x), add(v.y); }
    void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
    void add(const Surface& surface) {
        hasher_.add(surface.name);
        for (const Vec3& vertex : surface.vertices) {
            add(vertex);
        }
        for (const auto& triangle : surface.triangles) {
            for (const std::uint32_t corner : triangle) {
                hasher_.add(std::uint64_t{corner});
            }
        }
    }
    [[nodiscard]] std::string text() { return hasher_.finish().to_string(); }

  private:
    Hasher hasher_;
};

std::string bits_of(const TableGeometry& geometry) {
    Bits bits;
    for (const CushionFace& face : geometry.faces) {
        bits.add(face.from), bits.add(face.to), bits.add(face.normal);
    }
    for (const CushionCorner& corner : geometry.corners) {
        bits.add(corner.centre), bits.add(corner.radius);
    }
    for (const Pocket& pocket : geometry.pockets) {
        bits.add(pocket.centre), bits.add(pocket.radius), bits.add(pocket.drop);
    }
    for (const Surface& surface : geometry.surfaces) {
        bits.add(surface);
    }
    return bits.text();
}

TEST(TableBits, WhatBallsMeet_IsPinned) {
    const std::map<std::string, std::string> pinned{
        {"pool_9ft", "aecd9a3c5a2d4bfc2c118f8783501f6f"},
        {"pool_8ft", "de4ad596b2eed2cb91e59789b5acce7c"},
        {"pool_7ft", "dae8ab1f866f30b7cb5649395f6250d2"},
        {"snooker_12ft", "e99650ce2a7a1a38283da1b3f45df2ba"},
        {"carom_10ft", "72ed2ccb5fd04e35ea970b5e71d26bce"}};
    for (const test::NamedTable& table : test::kTables) {
        EXPECT_EQ(bits_of(build_table(*standard_table(table.kind, table.size), table.ball_radius)),
                  pinned.at(table.name))
            << table.name;
    }
}

}  // namespace
}  // namespace carom::sim::billiards
