// Which balls the rules of a game put back, and where.
#include "sim/billiards/respotting_rules.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/billiards/ball_names.h"
#include "sim/billiards/free_place.h"
#include "sim/billiards/spots.h"

namespace carom::sim::billiards {
namespace {

constexpr double kRadius = 0.026;

/// The balls of a game and its shots. A ball that falls is not on the table until it is put back.
class Frame {
  public:
    Frame(Game game, TableKind kind, const char* size)
        : table_(*standard_table(kind, size)), referee_(game, table_) {}

    void add(const std::string& name, const Vec2& place) { places_[name] = place; }
    void add_spots(const std::vector<Spot>& spots) {
        for (const Spot& spot : spots) {
            add(spot.name, spot.place);
        }
    }
    [[nodiscard]] const TableMeasures& table() const { return table_; }

    /// The cue ball touches `first` first, and these balls fall into pockets or leave the table.
    std::vector<RespottedBall> play(const std::string& first, const std::set<std::string>& potted,
                                    const std::set<std::string>& off_table = {}) {
        ShotOutcome shot;
        shot.cue_ball = "white";
        shot.first_hit = first;
        shot.potted = potted;
        shot.off_table = off_table;
        for (const auto& [name, place] : places_) {
            if (!down_.contains(name)) {
                shot.on_table.insert(name);
            }
        }
        down_.insert(potted.begin(), potted.end());
        down_.insert(off_table.begin(), off_table.end());
        std::vector<GameBall> balls;
        for (const auto& [name, place] : places_) {
            balls.push_back({name, kRadius, !down_.contains(name), place});
        }
        const std::vector<RespottedBall> put = referee_.after(shot, balls);
        for (const RespottedBall& ball : put) {
            down_.erase(ball.ball);
            places_[ball.ball] = ball.place;
        }
        return put;
    }

    [[nodiscard]] const std::set<std::string>& without_place() const {
        return referee_.without_place();
    }

  private:
    TableMeasures table_;
    RespottingRules referee_;
    std::map<std::string, Vec2> places_;
    std::set<std::string> down_;
};

/// "black on black" or "black on nothing": what was put where.
std::vector<std::string> names(const std::vector<RespottedBall>& put) {
    std::vector<std::string> texts;
    for (const RespottedBall& ball : put) {
        texts.push_back(ball.ball + " on " + (ball.spot.empty() ? "no spot" : ball.spot));
    }
    return texts;
}

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Frame snooker_frame(int reds) {
    Frame frame(Game::snooker, TableKind::snooker, "12 ft");
    frame.add_spots(snooker_spots(frame.table()));
    frame.add("white", {-1.3, 0.1});
    for (int i = 1; i <= reds; ++i) {
        frame.add("red_" + std::to_string(i), {0.5, 0.08 * i});
    }
    return frame;
}

TEST(Snooker, ColoursComeBackWhileThereAreReds_RedsDoNot) {
    Frame frame = snooker_frame(2);
    EXPECT_THAT(names(frame.play("red_1", {"red_1"})), IsEmpty());
    EXPECT_THAT(names(frame.play("black", {"black"})), ElementsAre("black on black"));
    EXPECT_THAT(names(frame.play("red_2", {"red_2"})), IsEmpty());
    // The colour that follows the last red comes back, too.
    EXPECT_THAT(names(frame.play("pink", {"pink"})), ElementsAre("pink on pink"));
}

TEST(Snooker, InTheEnding_TheLowestColourStaysDown) {
    Frame frame = snooker_frame(0);
    EXPECT_THAT(names(frame.play("yellow", {"yellow"})), IsEmpty());
    EXPECT_THAT(names(frame.play("green", {"green"})), IsEmpty());
    // Brown is the ball on: another colour, a wrong first ball, a second ball or the cue ball that
    // falls are fouls.
    EXPECT_THAT(names(frame.play("black", {"black"})), ElementsAre("black on black"));
    EXPECT_THAT(names(frame.play("blue", {"brown"})), ElementsAre("brown on brown"));
    EXPECT_THAT(names(frame.play("brown", {"blue", "brown"})),
                ElementsAre("blue on blue", "brown on brown"));
    EXPECT_THAT(names(frame.play("brown", {"brown", "white"})),
                ElementsAre("brown on brown", "white on no spot"));
    EXPECT_THAT(names(frame.play("brown", {}, {"brown"})), ElementsAre("brown on brown"));
    EXPECT_THAT(names(frame.play("brown", {"brown"})), IsEmpty());
}

TEST(Snooker, AfterTheLastRedWithTheCueBall_TheEndingBegins) {
    Frame frame = snooker_frame(1);
    EXPECT_THAT(names(frame.play("red_1", {"red_1", "white"})), ElementsAre("white on no spot"));
    EXPECT_THAT(names(frame.play("yellow", {"yellow"})), IsEmpty());
}

TEST(Snooker, OccupiedSpot_TheHighestFreeOneIsTaken) {
    Frame frame = snooker_frame(1);
    frame.add("red_9", *find_spot(snooker_spots(frame.table()), "black"));
    // Pink goes to its own spot first, then black to the highest one that is left.
    EXPECT_THAT(names(frame.play("black", {"black", "pink", "green"})),
                ElementsAre("pink on pink", "green on green", "black on no spot"));
    frame.play("blue", {"blue"});
    Frame other = snooker_frame(1);
    other.add("red_9", *find_spot(snooker_spots(other.table()), "black"));
    other.play("red_1", {"red_1"});
    other.add("blue", {-0.4, 0.2});
    EXPECT_THAT(names(other.play("black", {"black"})), ElementsAre("black on blue"));
}

TEST(Snooker, AllSpotsOccupied_ThePlaceIsNearestTowardsTheTopCushion) {
    Frame frame = snooker_frame(1);
    const Vec2 black = *find_spot(snooker_spots(frame.table()), "black");
    frame.add("red_9", black);
    const std::vector<RespottedBall> put = frame.play("black", {"black"});
    ASSERT_EQ(put.size(), 1U);
    EXPECT_NEAR(put[0].place.x, black.x + 2 * kRadius + FreePlaces::kApart, 1e-7);
    EXPECT_EQ(put[0].place.y, 0);
}

TEST(Snooker, CueBallInHand_LiesInTheD) {
    Frame frame = snooker_frame(1);
    const Vec2 yellow = *find_spot(snooker_spots(frame.table()), "yellow");
    std::vector<RespottedBall> put = frame.play("red_1", {"white"});
    ASSERT_THAT(names(put), ElementsAre("white on no spot"));
    EXPECT_EQ(put[0].place, Vec2(yellow.x, 0.5 * yellow.y));
    frame.add("red_5", {yellow.x, 0.5 * yellow.y});
    put = frame.play("red_1", {"white"});
    EXPECT_EQ(put[0].place, Vec2(yellow.x, -0.5 * yellow.y));
    frame.add("red_6", {yellow.x, -0.5 * yellow.y});
    put = frame.play("red_1", {"white"});
    EXPECT_EQ(put[0].place.y, 0.5 * yellow.y);
    EXPECT_NEAR(put[0].place.x, yellow.x - 2 * kRadius - FreePlaces::kApart, 1e-7);
}

Frame pool_frame(Game game) {
    Frame frame(game, TableKind::pool, "9 ft");
    frame.add("white", {-0.9, 0.1});
    for (int number = 1; number <= (game == Game::nine_ball ? 9 : 15); ++number) {
        frame.add(kPoolBalls.at(static_cast<std::size_t>(number)), {0.1 * number - 0.8, 0.4});
    }
    return frame;
}

TEST(NineBall, TheNineComesBackOnAFoul) {
    Frame frame = pool_frame(Game::nine_ball);
    EXPECT_THAT(names(frame.play("one", {"three"})), IsEmpty());
    EXPECT_THAT(names(frame.play("two", {"nine"})), ElementsAre("nine on foot"));
    EXPECT_THAT(names(frame.play("one", {}, {"nine"})), ElementsAre("nine on foot"));
    EXPECT_THAT(names(frame.play("one", {"nine", "white"})),
                ElementsAre("nine on foot", "white on head"));
    EXPECT_THAT(names(frame.play("one", {"one"})), IsEmpty());
    EXPECT_THAT(names(frame.play("two", {"nine"})), IsEmpty());  // it has won
}

TEST(NineBall, OccupiedFootSpot_TheNineLiesBehindIt) {
    Frame frame = pool_frame(Game::nine_ball);
    frame.add("four", {0.635, 0});
    const std::vector<RespottedBall> put = frame.play("two", {"nine"});
    ASSERT_EQ(put.size(), 1U);
    EXPECT_NEAR(put[0].place.x, 0.635 + 2 * kRadius + FreePlaces::kApart, 1e-7);
}

TEST(EightBall, OnlyAnEightOfTheBreakComesBack) {
    Frame frame = pool_frame(Game::eight_ball);
    EXPECT_THAT(names(frame.play("one", {"eight", "two"})), ElementsAre("eight on foot"));
    EXPECT_THAT(names(frame.play("one", {"eight", "white"})), ElementsAre("white on head"));
}

TEST(Carom, BallsThatLeftTheTable_GoToTheSpotsOfTheirPlayers) {
    const auto new_frame = [] {
        Frame frame(Game::carom, TableKind::carom, "10 ft");
        frame.add("white", {-1, 0.3});
        frame.add("yellow", {-1, -0.3});
        frame.add("red", {1, 0.3});
        return frame;
    };
    // White was struck, so yellow plays next.
    EXPECT_THAT(names(new_frame().play("red", {}, {"red", "white", "yellow"})),
                ElementsAre("red on foot", "white on centre", "yellow on head"));
    Frame frame = new_frame();
    frame.add("yellow", {0.71, 0});  // on the spot of red: red goes to the spot of yellow
    EXPECT_THAT(names(frame.play("red", {}, {"red"})), ElementsAre("red on head"));
    frame.add("white", {0.71, 0});
    frame.add("yellow", {0, 0});  // on the spots of red and white
    EXPECT_THAT(names(frame.play("red", {}, {"red"})), ElementsAre("red on head"));
}

TEST(RespottingRules, WithoutAFreePlace_TriesAgainAfterTheNextShot) {
    Frame frame = pool_frame(Game::nine_ball);
    for (int i = 0; i < 60; ++i) {
        frame.add("wall_" + std::to_string(i), {-1.25 + 0.0425 * i, 0});
    }
    EXPECT_THAT(frame.play("two", {"nine"}), IsEmpty());
    EXPECT_THAT(frame.without_place(), ElementsAre("nine"));
    frame.add("wall_44", {0.6, 0.5});
    frame.add("wall_45", {0.6, 0.5});
    EXPECT_THAT(names(frame.play("one", {})), ElementsAre("nine on foot"));
    EXPECT_THAT(frame.without_place(), IsEmpty());
}

}  // namespace
}  // namespace carom::sim::billiards
