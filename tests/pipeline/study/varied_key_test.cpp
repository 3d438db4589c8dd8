#include "pipeline/study/varied_key.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/normal.h"
#include "pipeline/study/sampling.h"

namespace carom::pipeline::study {
namespace {

using ::testing::ElementsAre;

/// The shot gives a speed and a word.
std::optional<std::string> text_of(const std::string& key) {
    if (key == "a.speed") {
        return "3.2 m/s";
    }
    return key == "a.model" ? std::optional<std::string>("han2005") : std::nullopt;
}

VariedKey varied(const std::string& text) {
    const auto parsed = parse_varied(text, text_of);
    if (const auto* problem = std::get_if<TextProblem>(&parsed)) {
        ADD_FAILURE() << problem->sentence;
        return {};
    }
    return std::get<VariedKey>(parsed);
}

std::vector<std::string> texts(const VariedKey& key) {
    std::vector<std::string> all;
    for (const VariedPoint& point : key.points) {
        all.push_back(point.text);
    }
    return all;
}

TEST(VariedKey_OfSteps, HasRoundNumbersWithTheUnit) {
    const VariedKey key = varied("events[0].strike.speed=1..2 m/s:0.25");
    EXPECT_EQ(key.key, "events[0].strike.speed");
    EXPECT_EQ(key.title(), "events[0].strike.speed [m/s]");
    EXPECT_THAT(texts(key), ElementsAre("1 m/s", "1.25 m/s", "1.5 m/s", "1.75 m/s", "2 m/s"));
    EXPECT_EQ(key.points[1].number, 1.25);
    EXPECT_FALSE(key.is_sampled());
    EXPECT_TRUE(key.is_numeric());
    EXPECT_THAT(texts(varied("a=0.1..0.45:0.1")), ElementsAre("0.1", "0.2", "0.3", "0.4"));
    EXPECT_THAT(texts(varied("a = -1 deg .. +1 deg : 1")), ElementsAre("-1 deg", "0 deg", "1 deg"));
    EXPECT_THAT(texts(varied("a=0..2 m:50 cm")),
                ElementsAre("0 m", "0.5 m", "1 m", "1.5 m", "2 m"));
}

TEST(VariedKey_OfAList, HasWordsOrNumbersOfOneUnit) {
    const VariedKey words = varied("a.model=mathavan2010, han2005");
    EXPECT_THAT(texts(words), ElementsAre("mathavan2010", "han2005"));
    EXPECT_FALSE(words.is_numeric());
    const VariedKey numbers = varied("a=1 m/s,4 m/s");
    EXPECT_EQ(numbers.unit, "m/s");
    EXPECT_TRUE(numbers.is_numeric());
    EXPECT_FALSE(varied("a=1 m/s,4 km/h").is_numeric());
    EXPECT_FALSE(varied("a=1,none").is_numeric());
    EXPECT_THAT(texts(varied("tip=[0, 0],{x: [1, 2], y: 3}")),
                ElementsAre("[0, 0]", "{x: [1, 2], y: 3}"));
    EXPECT_THAT(texts(varied("file=../a.obj,~/b.obj")), ElementsAre("../a.obj", "~/b.obj"));
}

TEST(VariedKey_ThatIsSampled, FollowsItsDistribution) {
    const VariedKey range = varied("a=2..4 m/s");
    EXPECT_TRUE(range.is_sampled());
    EXPECT_EQ(range.at(0.25).text, "2.5 m/s");
    const VariedKey own = varied("a.speed~10 cm/s");
    EXPECT_EQ(own.title(), "a.speed [m/s]");
    EXPECT_EQ(own.at(0.5).text, "3.2 m/s");
    EXPECT_NEAR(*own.at(0.975).number, 3.2 + 0.1 * normal_quantile(0.975), 1e-12);
    const VariedKey other = varied("a.speed=5 m/s~0.5");
    EXPECT_EQ(other.at(0.5).text, "5 m/s");
    EXPECT_LT(*other.at(0.1).number, 5 - 0.5);
}

TEST(VariedKeys_ThatCannotBeRead, SayWhyAndWhere) {
    const auto expect = [](const std::string& text, const std::string& sentence, std::size_t offset,
                           std::size_t length) {
        const auto parsed = parse_varied(text, text_of);
        const auto* problem = std::get_if<TextProblem>(&parsed);
        ASSERT_NE(problem, nullptr) << text;
        EXPECT_EQ(problem->sentence, sentence);
        EXPECT_EQ(problem->offset, offset) << text;
        EXPECT_EQ(problem->length, length) << text;
    };
    expect("speed",
           "'speed' is not of the form KEY=LOW..HIGH:STEP, KEY=VALUE,VALUE or KEY~ERROR, as in "
           "'events[0].strike.speed=1..8 m/s:0.5'",
           0, 5);
    expect("a=3..3 m/s", "the range is empty: both ends are 3 m/s", 2, 8);
    expect("a=8..1 m/s:0.5", "the range begins above its end; write 1..8 m/s", 2, 8);
    expect("a=1..8:0", "the step must be above 0", 7, 1);
    expect("a=1..8:-1", "the step must be above 0", 7, 2);
    expect("a=1..8 m/s:10", "the step is larger than the range of 7 m/s", 11, 2);
    expect("a=1..8:1e-9", "the range has more than 1000000 such steps", 7, 4);
    expect("a=1 m..8 m/s:1", "'1 m' is a length, where a speed in m/s is needed", 2, 3);
    expect("a=1..8 m/s:1 kg", "'1 kg' is a mass, where a speed in m/s is needed", 11, 4);
    expect("a=1..", "a number is missing here", 5, 1);
    expect("a=1..x", "'x' is not a number", 5, 1);
    expect("a=",
           "the values are missing: write 1..8 m/s:0.5, a list such as 1,2,4, or an error "
           "such as ~0.1",
           2, 1);
    expect("a=han2005",
           "this is a single value, which --set gives; write a range such as 1..8 m/s:0.5, a list "
           "such as 1,2,4, or an error such as ~0.1",
           2, 7);
    expect("a=1,,2", "a value is missing here", 4, 1);
    expect("a=1,2,1", "'1' is in the list twice", 6, 1);
    expect("b.speed~0.1",
           "the shot gives no single value to 'b.speed', around which there could be an error; "
           "write KEY=VALUE~ERROR",
           0, 7);
    expect("a.model~0.1", "'a.model' is 'han2005' in the shot, which is not a number with an error",
           0, 7);
    expect("a.speed~0 m/s", "the error must be above 0; it is the standard deviation", 8, 5);
    expect("a.speed~1 deg", "'1 deg' is an angle, where a speed in m/s is needed", 8, 5);
}

}  // namespace
}  // namespace carom::pipeline::study
