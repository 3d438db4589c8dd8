// A shot with one damaged character means the same as before, or an error or a warning points to
// the damage. CAROM_DAMAGED_SHOTS is the number of damages, CAROM_FIRST_DAMAGED_SHOT the first
// shot.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/folders.h"
#include "tests/pipeline/config/damage/damage.h"
#include "tests/pipeline/config/damage/difference.h"
#include "tests/pipeline/config/damage/random_shot.h"
#include "tests/pipeline/config/damage/survivors.h"

namespace carom::testing {
namespace {

using pipeline::LoadResult;
using pipeline::Problem;

constexpr int kDamagesPerShot = 25;

int setting(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::atoi(text) : otherwise;
}

LoadResult load(const std::string& text) {
    return pipeline::load_shot_text(text, "/nowhere/shot.yaml");
}

std::string reported(const LoadResult& result) {
    std::string text;
    for (const Problem& problem : result.problems) {
        text += format(problem);
    }
    return text;
}

/// "ball_1" of the line "  ball_1: {at: ...".
std::string key_of(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" -");
    const std::size_t colon = line.find(':');
    return first < colon && colon != std::string::npos ? line.substr(first, colon - first) : "";
}

/// The texts in front of the colons of a line, without quotes: "ball_1" and "at" of
/// "  ball_1: {at: ...". They are its keys, and more where a colon stands in a text.
std::set<std::string> keys_of(const std::string& line) {
    std::set<std::string> keys;
    for (std::size_t colon = line.find(':'); colon != std::string::npos;
         colon = line.find(':', colon + 1)) {
        const std::string before = line.substr(0, colon);
        const bool is_quoted = before.ends_with('\'') || before.ends_with('"');
        const std::string text = before.substr(0, before.size() - (is_quoted ? 1 : 0));
        keys.insert(text.substr(text.find_last_of(" {,'\"") + 1));
    }
    keys.erase("");
    return keys;
}

/// Whether the message refers to a name that the damage removed ("there is no ball 'ball_1'") or
/// suggests the name that it created ("did you mean 'ball-_1'?"). A missing name is reported where
/// it is used.
bool refers_to_name(const Problem& problem, const Damage& damage) {
    const std::string& suggested = problem.suggestion;
    const std::set<std::string> new_keys = keys_of(damage.new_line);
    const auto is_missing = [&](const std::string& key) {
        return !new_keys.contains(key) &&
               problem.message.find("'" + key + "'") != std::string::npos;
    };
    return std::ranges::any_of(keys_of(damage.old_line), is_missing) ||
           (!suggested.empty() && damage.new_line.find(suggested) != std::string::npos &&
            damage.old_line.find(suggested) == std::string::npos);
}

/// Whether the message is that the damaged ball or object overlaps another or a rail. The problem
/// points to the name of one of them, of two balls the later one.
bool names_overlapping(const Problem& problem, const Damage& damage) {
    const auto is_named = [&](const std::string& line) {
        const std::string name = key_of(line);
        return !name.empty() && problem.message.find("'" + name + "'") != std::string::npos;
    };
    const bool is_overlap = problem.message.find(" overlap by ") != std::string::npos ||
                            problem.message.find(" overlaps ") != std::string::npos;
    return is_overlap &&
           (is_named(damage.old_line) || std::ranges::any_of(damage.enclosing, is_named));
}

/// Whether one of the problems points into the damaged construct or names something in it.
bool is_reported(const LoadResult& result, const Damage& damage) {
    for (const Problem& problem : result.problems) {
        const int line = problem.place.line;
        if ((line >= damage.first_line && line <= damage.last_line) ||
            refers_to_name(problem, damage) || names_overlapping(problem, damage)) {
            return true;
        }
    }
    return false;
}

struct Tally {
    int at_line = 0;
    int in_construct = 0;
    int same = 0;
    std::map<std::string, int> survivors;
};

std::string listed(const std::vector<Difference>& differences) {
    std::string text;
    for (const Difference& difference : differences) {
        text +=
            difference.path + ": '" + difference.before + "' became '" + difference.after + "'\n";
    }
    return text;
}

/// Checks a shot without a problem that points to the damage: it must mean the same, or the damage
/// must be of a known kind of survivor.
void check_meaning(const LoadResult& intact, const LoadResult& result, const Damage& damage,
                   Tally& tally) {
    const std::vector<Difference> found = differences(intact, result);
    if (found.empty()) {
        ++tally.same;
        return;
    }
    const std::string kind = survivor_kind(found, damage);
    ++tally.survivors[kind];
    EXPECT_NE(kind, "") << "nothing points to the damage: " << listed(found) << reported(result)
                        << damage.text;
}

void check(const LoadResult& intact, const Damage& damage, Tally& tally) {
    SCOPED_TRACE(damage.what + " in line " + std::to_string(damage.line) + ":\n" + damage.new_line);
    const LoadResult result = load(damage.text);
    if (is_reported(result, damage) || (!result.shot && joins_comment(damage))) {
        Damage exact = damage;
        exact.first_line = exact.last_line = damage.line;
        ++(is_reported(result, exact) ? tally.at_line : tally.in_construct);
    } else if (result.shot) {
        check_meaning(intact, result, damage, tally);
    } else {
        ADD_FAILURE() << "no error points to the damage:\n" << reported(result) << damage.text;
    }
}

TEST(DamagedShots, AreReportedOrMeanTheSame) {
    const int first = setting("CAROM_FIRST_DAMAGED_SHOT", 1);
    const int count = setting("CAROM_DAMAGED_SHOTS", 300);
    const int most_failures = setting("CAROM_MOST_FAILURES", 1);
    Tally tally;
    int failures = 0;
    for (int shot = 0; shot * kDamagesPerShot < count && failures < most_failures; ++shot) {
        SCOPED_TRACE("CAROM_FIRST_DAMAGED_SHOT=" + std::to_string(first + shot));
        Dice dice(static_cast<std::uint64_t>(first + shot));
        const std::string text = write_yaml(random_shot(dice), dice);
        const LoadResult intact = load(text);
        ASSERT_EQ(reported(intact), "") << text;
        for (int i = 0; i < kDamagesPerShot && failures < most_failures; ++i) {
            const Damage one = damage(text, dice);
            const int before = ::testing::UnitTest::GetInstance()
                                   ->current_test_info()
                                   ->result()
                                   ->total_part_count();
            check(intact, one, tally);
            failures += ::testing::UnitTest::GetInstance()
                                    ->current_test_info()
                                    ->result()
                                    ->total_part_count() > before
                            ? 1
                            : 0;
        }
    }
    std::printf("%d reported at the line, %d within the construct, %d the same\n", tally.at_line,
                tally.in_construct, tally.same);
    for (const auto& [kind, number] : tally.survivors) {
        std::printf("%d %s\n", number, kind.empty() ? "NOT FOUND" : kind.c_str());
    }
    EXPECT_GT(tally.at_line, 4 * tally.in_construct);
}

TEST(DamagedShots, EverySurvivorHasAReason) {
    std::ifstream file(CAROM_SOURCE_DIR "/tests/pipeline/config/damage/survivors.txt");
    std::set<std::string> reasoned;
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (!line.starts_with("#") && colon != std::string::npos) {
            reasoned.insert(line.substr(0, colon));
        }
    }
    const std::vector<std::string> known = survivor_kinds();
    EXPECT_EQ(reasoned, std::set<std::string>(known.begin(), known.end()));
}

}  // namespace
}  // namespace carom::testing
