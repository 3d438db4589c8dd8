// Strikes that a page asks for by what they shall do, and strikes that are judged.
#include "pipeline/studio/shot_solver.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/solve/outcome_map.h"
#include "pipeline/solve/solver.h"
#include "pipeline/studio/sought_strike.h"
#include "pipeline/studio/strike_judge.h"
#include "sim/bake.h"

namespace carom::studio {
namespace {

namespace solve = pipeline::solve;

struct Baked {
    std::shared_ptr<const pipeline::Shot> shot;
    std::shared_ptr<const sim::Timeline> timeline;
};

constexpr const char* kBalls =
    "carom: 1\n"
    "table: {kind: pool}\n"
    "simulation: {duration: 12 s}\n"
    "balls:\n"
    "  cue: {at: [-0.3, 0]}\n"
    "  one: {at: [0.4, 0.2]}\n"
    "  two: {at: [0.5, -0.3]}\n";

Baked bake_text(const std::string& text) {
    pipeline::LoadResult loaded = pipeline::load_shot_text(text, "shot.yaml", {});
    const auto shot = std::make_shared<const pipeline::Shot>(std::move(loaded.shot.value()));
    return {shot, std::make_shared<const sim::Timeline>(sim::bake(shot->world))};
}

/// The shot with a strike.
Baked with_strike(const std::string& strike) {
    return bake_text(std::string(kBalls) + "events: [{strike: {ball: cue, at: 0.5 s, " + strike +
                     "}}]\n");
}

SolveShot pot_one(std::int64_t q) {
    SolveShot question;
    question.q = q;
    question.v = 1;
    question.struck = "cue";
    question.ball = "one";
    question.pocket = "corner_right_back";
    question.seconds = 60;
    return question;
}

class ShotSolverWork : public testing::Test {
  protected:
    ShotSolverWork()
        : solver_(
              [this](PageId page, const SolutionsHead& head, const std::vector<double>& numbers) {
                  const std::lock_guard lock(mutex_);
                  answers_.push_back({page, head, numbers});
                  wake_.notify_all();
              },
              [this](PageId /*page*/, const ServerMessage& message) {
                  const std::lock_guard lock(mutex_);
                  texts_.push_back(message);
                  wake_.notify_all();
              }) {}

    struct Answer {
        PageId page = 0;
        SolutionsHead head;
        std::vector<double> numbers;
    };

    void show(const Baked& baked) { solver_.set_shot(baked.shot, baked.timeline, 1); }

    Answer wait_for_last(std::int64_t q) {
        std::unique_lock lock(mutex_);
        const auto is_last = [&](const Answer& one) {
            return one.head.q == q && one.head.complete;
        };
        wake_.wait_for(lock, std::chrono::seconds(60),
                       [&] { return std::ranges::any_of(answers_, is_last); });
        const auto found = std::ranges::find_if(answers_, is_last);
        return found != answers_.end() ? *found : throw Error("there was no last answer");
    }

    template <class Message>
    Message wait_for() {
        std::unique_lock lock(mutex_);
        const auto is_it = [](const ServerMessage& one) {
            return std::holds_alternative<Message>(one);
        };
        wake_.wait_for(lock, std::chrono::seconds(60),
                       [&] { return std::ranges::any_of(texts_, is_it); });
        const auto found = std::ranges::find_if(texts_, is_it);
        return found != texts_.end() ? std::get<Message>(*found)
                                     : throw Error("there was no answer");
    }

    void expect_results(const SolutionsHead& head, const solve::SolveResult& result) {
        ASSERT_FALSE(head.solutions.empty());
        std::size_t i = 0;
        for (const solve::Solution& one : result.solutions) {
            if (!one.is_solved) {
                continue;
            }
            ASSERT_LT(i, head.solutions.size());
            EXPECT_EQ(head.solutions[i].route, one.route);
            EXPECT_EQ(head.solutions[i].direction, one.strike.direction);
            EXPECT_EQ(head.solutions[i].speed, one.strike.speed);
            EXPECT_EQ(head.solutions[i].chance, one.chance);
            EXPECT_EQ(head.solutions[i].window, one.window_width());
            ++i;
        }
        EXPECT_EQ(i, head.solutions.size());
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<Answer> answers_;
    std::vector<ServerMessage> texts_;
    ShotSolver solver_;
};

TEST_F(ShotSolverWork, Solutions_AreThoseOfSolveAndHaveTheirPaths) {
    const Baked baked = with_strike("toward: two, speed: 2 m/s");
    show(baked);
    solver_.ask(7, pot_one(1));
    const Answer last = wait_for_last(1);
    const SoughtStrike sought = sought_strike(*baked.shot, *baked.timeline, 0, "");
    const solve::SolveProblem problem = pot_problem(sought, {{"one", "corner_right_back"}});
    expect_results(last.head, solve::solve(sim::Trials(sought.world), problem));
    EXPECT_EQ(last.page, 7U);
    EXPECT_EQ(last.head.v, 1);
    EXPECT_EQ(last.head.message, "");
    for (const ShotSolution& one : last.head.solutions) {
        EXPECT_EQ(one.pocket, "corner_right_back");
    }
    // Of each solution the cue ball's path, which begins where that is struck, and the potted
    // ball's.
    for (int i = 0; i < static_cast<int>(last.head.solutions.size()); ++i) {
        const auto path = [&](const std::string& name) {
            const auto found = std::ranges::find_if(last.head.tracks, [&](const FanTrack& track) {
                return track.run == i && track.name == name;
            });
            EXPECT_NE(found, last.head.tracks.end());
            return &last.numbers[static_cast<std::size_t>(found->first)];
        };
        EXPECT_NEAR(path("cue")[0], 0.5, 1e-9);
        EXPECT_NEAR(path("cue")[1], -0.3, 1e-9);
        EXPECT_NEAR(path("one")[1], 0.4, 1e-9);
    }
}

TEST_F(ShotSolverWork, Place_IsSoughtFromWhatIsKnown) {
    const Baked baked = with_strike("toward: two, speed: 2 m/s");
    show(baked);
    solver_.ask(1, pot_one(1));
    static_cast<void>(wait_for_last(1));
    SolveShot question = pot_one(2);
    question.rest = {0.2, 0.1};
    question.within = 0.2;
    solver_.ask(1, question);
    const Answer last = wait_for_last(2);
    const SoughtStrike sought = sought_strike(*baked.shot, *baked.timeline, 0, "");
    solve::SolveProblem problem = pot_problem(sought, {{"one", "corner_right_back"}});
    problem.wants.emplace_back(solve::RestPlace{"cue", Vec2(0.2, 0.1), 0.2});
    expect_results(last.head, solve::solve(sim::Trials(sought.world), problem));
    for (const ShotSolution& one : last.head.solutions) {
        ASSERT_TRUE(one.rest);
        EXPECT_LE(std::hypot((*one.rest)[0] - 0.2, (*one.rest)[1] - 0.1), 0.2);
    }
}

TEST_F(ShotSolverWork, NewestQuestionOfAPage_IsTheOnlyOne) {
    show(with_strike("toward: two, speed: 2 m/s"));
    for (std::int64_t q = 1; q <= 5; ++q) {
        SolveShot question = pot_one(q);
        question.rest = {0.1 * static_cast<double>(q), 0.1};
        solver_.ask(1, question);
    }
    solver_.ask(2, pot_one(1));  // of another page: it waits
    EXPECT_EQ(wait_for_last(5).page, 1U);
    EXPECT_EQ(wait_for_last(1).page, 2U);
    const std::lock_guard lock(mutex_);
    for (const Answer& one : answers_) {
        EXPECT_TRUE(one.page == 2 || one.head.q == 5 || !one.head.complete) << one.head.q;
    }
}

TEST_F(ShotSolverWork, CancelledQuestion_IsNotAnswered) {
    show(with_strike("toward: two, speed: 2 m/s"));
    solver_.ask(1, pot_one(1));
    solver_.cancel(1);
    {
        const std::lock_guard lock(mutex_);
        answers_.clear();  // it may have begun
    }
    solver_.ask(2, pot_one(2));
    static_cast<void>(wait_for_last(2));
    const std::lock_guard lock(mutex_);
    EXPECT_THAT(answers_, testing::Each(testing::Field(&Answer::page, 2U)));
}

TEST_F(ShotSolverWork, Time_EndsASearchWithWhatItHas) {
    show(with_strike("toward: two, speed: 2 m/s"));
    SolveShot question = pot_one(1);
    question.seconds = 0;
    solver_.ask(1, question);
    const SolutionsHead head = wait_for_last(1).head;
    EXPECT_TRUE(head.solutions.empty());
    EXPECT_EQ(head.message, "No strike that does this was found in 0 s.");
}

TEST_F(ShotSolverWork, QuestionForAVersion_WaitsForItsShot) {
    SolveShot question = pot_one(1);
    question.v = 2;
    solver_.ask(1, question);
    const Baked baked = with_strike("toward: two, speed: 2 m/s");
    solver_.set_shot(baked.shot, baked.timeline, 1);
    solver_.set_shot(baked.shot, baked.timeline, 2);
    EXPECT_EQ(wait_for_last(1).head.v, 2);
}

TEST_F(ShotSolverWork, ShotWithoutStrike_GetsANewOne) {
    show(bake_text(kBalls));
    solver_.ask(1, pot_one(1));
    const SolutionsHead head = wait_for_last(1).head;
    ASSERT_FALSE(head.solutions.empty());
    EXPECT_EQ(head.time, 0.5);
    EXPECT_EQ(head.solve_item, -1);
}

TEST_F(ShotSolverWork, SolveOfTheShot_IsToldByItsNumber) {
    show(bake_text(std::string(kBalls) + "events: [{strike: {ball: cue, at: 0.5 s}}]\n"
                                         "solve: {want: [{potted: two}]}\n"));
    SolveShot question = pot_one(1);
    question.seconds = 0;
    solver_.ask(1, question);
    EXPECT_EQ(wait_for_last(1).head.solve_item, 0);
}

TEST_F(ShotSolverWork, WhatCannotBe_IsExplained) {
    std::string text = kBalls;
    text.replace(text.find("pool"), 4, "carom");
    show(bake_text(text + "events: [{strike: {ball: cue, at: 0.5 s, toward: one, speed: 2}}]\n"));
    SolveShot question = pot_one(1);
    question.pocket = "";
    solver_.ask(1, question);
    const SolutionsHead head = wait_for_last(1).head;
    EXPECT_TRUE(head.solutions.empty());
    EXPECT_THAT(head.message,
                testing::MatchesRegex("No strike was found that does all this, in .*\\."));
}

TEST_F(ShotSolverWork, MissingStrike_Fails) {
    show(with_strike("toward: two, speed: 2 m/s"));
    SolveShot question = pot_one(1);
    question.event = 3;
    solver_.ask(1, question);
    const auto failed = wait_for<Failed>();
    EXPECT_EQ(failed.what, "solve");
    EXPECT_EQ(failed.message, "the shot has no such strike any more");
}

TEST_F(ShotSolverWork, StrikeThatPots_HasAWindowAChanceAndAMap) {
    // Towards the middle of the pocket's mouth, as find_aims finds it.
    const Baked baked = with_strike("pot: one, in: corner_right_back, speed: 2 m/s");
    show(baked);
    solver_.ask(1, Judge{1, 1, 0, true, {}});
    const auto judged = wait_for<Judged>();
    ASSERT_EQ(judged.pots.size(), 1U);
    EXPECT_EQ(judged.pots[0].ball, "one");
    EXPECT_EQ(judged.pots[0].pocket, "corner_right_back");
    EXPECT_LT(judged.window[0], judged.direction);
    EXPECT_GT(judged.window[1], judged.direction);
    const SoughtStrike sought = sought_strike(*baked.shot, *baked.timeline, 0, "");
    solve::Solver same(std::make_shared<const sim::Trials>(sought.world),
                       pot_problem(sought, judged.pots));
    const solve::Solution solution = same.judge(sought.strike());
    EXPECT_EQ(judged.chance, solution.chance);
    EXPECT_EQ(judged.window[1] - judged.window[0], solution.window_width());

    const auto map = wait_for<StrikeMap>();
    EXPECT_EQ(map.cells.size(), static_cast<std::size_t>(map.columns * map.rows));
    EXPECT_THAT(map.cells, testing::HasSubstr("w"));
    EXPECT_LT(map.directions[0], judged.window[0]);
    EXPECT_GT(map.directions[1], judged.window[1]);
}

TEST_F(ShotSolverWork, StrikeThatPotsNothing_HasOnlyTheMapOfTheBallThatItHits) {
    show(with_strike("toward: one, speed: 1.2 m/s"));
    solver_.ask(1, Judge{1, 1, 0, true, std::array<double, 2>{-0.5, -0.3}});
    EXPECT_TRUE(wait_for<Judged>().pots.empty());
    const auto map = wait_for<StrikeMap>();
    ASSERT_EQ(map.pots.size(), 1U);
    EXPECT_EQ(map.pots[0].ball, "one");
    EXPECT_EQ(map.pots[0].pocket, "");
    EXPECT_EQ(map.directions[0], -0.5);
    EXPECT_EQ(map.directions[1], -0.3);
}

// Otherwise the page, which waits for an answer, would not ask again about the same shot.
TEST(StrikeJudge, OutOfTime_AnswersThatNothingIsKnown) {
    const Baked baked = with_strike("pot: one, in: corner_right_back, speed: 2 m/s");
    const SoughtStrike sought = sought_strike(*baked.shot, *baked.timeline, 0, "");
    const Judge question{7, 1, 0, true, {}};
    std::stop_source out_of_time;
    out_of_time.request_stop();
    std::vector<ServerMessage> told;
    EXPECT_THROW(judge_strike({std::make_shared<const sim::Trials>(sought.world), sought,
                               *baked.timeline, question, 1},
                              out_of_time.get_token(),
                              [&](const ServerMessage& message) { told.push_back(message); }),
                 Stopped);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(std::get<Judged>(told[0]).q, 7);
    EXPECT_EQ(std::get<Judged>(told[0]).v, 1);
    EXPECT_TRUE(std::get<Judged>(told[0]).pots.empty());
}

}  // namespace
}  // namespace carom::studio
