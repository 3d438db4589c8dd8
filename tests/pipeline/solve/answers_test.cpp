#include "pipeline/solve/answers.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/pipeline/solve/solve_layouts.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline::solve {
namespace {

namespace fs = std::filesystem;

/// A pot whose way is sought quickly: the speed and the tip are given.
SolveQuestion quick_question() {
    Layout layout = make_layouts()[20];
    layout.problem.finds_speed = layout.problem.finds_tip = false;
    std::get<sim::Strike>(layout.world.events[0].action).speed = 2.5;
    return {layout.world, layout.problem};
}

AnswerWork work_in(const std::string& folder) {
    AnswerWork work;
    work.folder.path = folder;
    return work;
}

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void expect_equal(const SolveResult& a, const SolveResult& b) {
    EXPECT_EQ(a.simulations, b.simulations);
    EXPECT_EQ(a.is_complete, b.is_complete);
    ASSERT_EQ(a.solutions.size(), b.solutions.size());
    for (std::size_t i = 0; i < a.solutions.size(); ++i) {
        EXPECT_EQ(a.solutions[i].route, b.solutions[i].route);
        EXPECT_EQ(a.solutions[i].ball, b.solutions[i].ball);
        EXPECT_EQ(a.solutions[i].is_solved, b.solutions[i].is_solved);
        EXPECT_EQ(a.solutions[i].miss, b.solutions[i].miss);
        EXPECT_EQ(a.solutions[i].window, b.solutions[i].window);
        EXPECT_EQ(a.solutions[i].chance, b.solutions[i].chance);
        EXPECT_EQ(a.solutions[i].chance_error, b.solutions[i].chance_error);
        EXPECT_EQ(a.solutions[i].rest, b.solutions[i].rest);
        EXPECT_EQ(a.solutions[i].strike.direction, b.solutions[i].strike.direction);
        EXPECT_EQ(a.solutions[i].strike.speed, b.solutions[i].strike.speed);
        EXPECT_EQ(a.solutions[i].strike.tip, b.solutions[i].strike.tip);
        EXPECT_EQ(a.solutions[i].strike.elevation, b.solutions[i].strike.elevation);
    }
}

TEST(AnswersTest, FolderAnswersTheSameQuestionAgain) {
    const carom::testing::ScratchFolder folder;
    const SolveQuestion question = quick_question();
    const AnswerWork kept = work_in(folder.path("new/answers"));
    const SolveResult first = answer(question, kept);
    EXPECT_TRUE(first.solutions.front().is_solved);
    const std::string file = kept.folder.path + "/" + hash_of(question).to_string() + ".answer";
    const std::string text = content(file);
    EXPECT_EQ(text, answer_text(first));
    expect_equal(answer(question, kept), first);
    // It is really that of the file.
    SolveResult other = first;
    other.simulations = 1;
    std::ofstream(file, std::ios::binary) << answer_text(other);
    std::size_t found = 0;
    AnswerWork again = kept;
    again.found = [&](std::size_t event, const Solution&) { found += event == 0 ? 1 : 0; };
    expect_equal(answer(question, again), other);
    EXPECT_EQ(found, static_cast<std::size_t>(
                         std::ranges::count_if(first.solutions, &Solution::is_solved)));

    std::ofstream(file, std::ios::binary) << text.substr(0, text.size() / 2);
    expect_equal(answer(question, kept), first);
    EXPECT_EQ(content(file), text);
}

TEST(AnswersTest, ReadOnlyFolder_StaysAsItIs) {
    const carom::testing::ScratchFolder folder;
    const SolveQuestion question = quick_question();
    AnswerWork work = work_in(folder.path("answers"));
    work.folder.is_read_only = true;
    const SolveResult result = answer(question, work);
    EXPECT_TRUE(result.solutions.front().is_solved);
    EXPECT_FALSE(fs::exists(folder.path("answers")));
}

TEST(AnswersTest, StoppedSearch_IsNotKept) {
    const carom::testing::ScratchFolder folder;
    std::stop_source stop;
    stop.request_stop();
    AnswerWork work = work_in(folder.path("answers"));
    work.parts.context.stop = stop.get_token();
    const SolveResult result = answer(quick_question(), work);
    EXPECT_FALSE(result.is_complete);
    EXPECT_FALSE(fs::exists(folder.path("answers")));
}

TEST(AnswersTest, DamagedText_IsNoAnswer) {
    const SolveQuestion question = quick_question();
    const SolveResult result = answer(question, {});
    const std::string text = answer_text(result);
    const std::optional<SolveResult> parsed = parse_answer(text, question);
    ASSERT_TRUE(parsed);
    expect_equal(*parsed, result);
    for (std::size_t i = 0; i < text.size(); i += 7) {
        std::string damaged = text;
        damaged[i] = damaged[i] == '1' ? '2' : '1';
        EXPECT_FALSE(parse_answer(damaged, question)) << i;
        EXPECT_FALSE(parse_answer(text.substr(0, i), question)) << i;
    }
    EXPECT_FALSE(parse_answer(text + "1", question));
}

TEST(QuestionTest, HashDependsOnAllThatIsAsked) {
    const SolveQuestion question = quick_question();
    std::set<std::string> hashes{hash_of(question).to_string()};
    const auto add = [&](auto change) {
        SolveQuestion other = question;
        change(other);
        EXPECT_TRUE(hashes.insert(hash_of(other).to_string()).second);
    };
    add([](SolveQuestion& q) { q.world.bodies[1].pose.position.x += 0.001; });
    add([](SolveQuestion& q) { q.problem.finds_tip = true; });
    add([](SolveQuestion& q) { q.problem.player.speed *= 2; });
    add([](SolveQuestion& q) { q.problem.prefer.push_back(Preference::slow); });
    add([](SolveQuestion& q) { q.problem.wants.emplace_back(RestPlace{"cue", {0, 0}, 0.1}); });
    add([](SolveQuestion& q) { q.problem.wants.emplace_back(RestPlace{"cue", {0, 0}, 0.2}); });
    const auto measured = [&](const std::string& measure, double low, double high) {
        add([&](SolveQuestion& q) {
            MeasuredRange range;
            range.measure = measure;
            range.low = low;
            range.high = high;
            q.problem.wants.emplace_back(range);
        });
    };
    measured("cushions:cue", 1, 2);
    measured("cushions:one", 1, 2);
    measured("cushions:cue", 0, 2);
    measured("cushions:cue", 1, 3);
}

}  // namespace
}  // namespace carom::pipeline::solve
