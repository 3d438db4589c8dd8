#include "core/fields.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/field_hasher.h"
#include "tests/core/field_changes.h"

namespace carom {
namespace {

struct Colour {
    Vec3 value{1, 1, 1};
    bool is_linear = false;
};

constexpr auto fields_of(Describes<Colour>) {
    return fields<Colour>(field("value", &Colour::value), field("is_linear", &Colour::is_linear));
}

struct Lamp {
    std::string name;
    std::string image;
    std::string room;
    std::optional<double> bound;
    std::optional<double> unbound;
    std::variant<Colour, double> light;
    std::vector<int> numbers;
};

constexpr auto fields_of(Describes<Lamp>) {
    return fields<Lamp>(unhashed("name", &Lamp::name, "nobody sees it"),
                        file_field("image", &Lamp::image),
                        hashed_elsewhere("room", &Lamp::room, "by its user"),
                        field_if_given("bound", &Lamp::bound, "numbers say whether"),
                        field("unbound", &Lamp::unbound), field("light", &Lamp::light),
                        field("numbers", &Lamp::numbers));
}

Hash128 hash_of(const Lamp& lamp) {
    return FieldHasher().add_value(lamp).finish();
}

TEST(Fields, MembersAreCounted) {
    static_assert(detail::has_members<Lamp, 7>());
    static_assert(!detail::has_members<Lamp, 6>());
    static_assert(!detail::has_members<Lamp, 8>());
    static_assert(kFieldCount<Lamp> == 7);
    constexpr auto light = field("light", &Lamp::light);
    static_assert(!detail::have_different_members(light, field("room", &Lamp::room), light));
    static_assert(detail::have_different_members(light, field("room", &Lamp::room)));
}

TEST(Fields, Visit_SeesNamesAndValuesInOrder) {
    const Colour colour{{0, 0.5, 1}, true};
    std::vector<std::string_view> names;
    for_each_field(colour, [&](const auto& field, const auto& value) {
        names.push_back(field.name);
        if constexpr (std::is_same_v<decltype(value), const bool&>) {
            EXPECT_TRUE(value);
        }
    });
    EXPECT_EQ(names, (std::vector<std::string_view>{"value", "is_linear"}));
}

TEST(FieldHasher, HashedFields_ChangeTheHash) {
    const std::string file = testing::TempDir() + "carom_fields_test";
    std::ofstream(file) << "a picture";
    Lamp lamp{"desk", "", "study", {}, 2, Colour{}, {1, 2}};
    // The lamp, its image, `bound` twice, `unbound` twice, four numbers of the colour, the other
    // alternative twice, an added number and a changed first number.
    EXPECT_EQ(carom::test::expect_changes_count(
                  lamp, [&] { return hash_of(lamp); }, file),
              1U + 1 + 2 + 2 + 4 + 2 + 2);
    const Hash128 hash = hash_of(lamp);
    lamp.name = "wall";
    lamp.room = "hall";
    EXPECT_EQ(hash_of(lamp), hash);
    std::remove(file.c_str());
}

TEST(FieldHasher, Hash_EqualsThatOfExplicitCalls) {
    const Lamp lamp{"desk", "", "study", 3, {}, 0.5, {1, 2}};
    Hasher by_hand;
    by_hand.add(false).add(3.0).add(false).add(std::uint64_t{1}).add(0.5);
    by_hand.add(std::uint64_t{2}).add(1).add(2);
    EXPECT_EQ(hash_of(lamp), by_hand.finish());
}

}  // namespace
}  // namespace carom
