#include "pipeline/study/sweep.h"

#include <charconv>
#include <sstream>
#include <stop_token>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/study/plot_data.h"
#include "pipeline/study/sweep_plot.h"
#include "sim/bake.h"
#include "tests/folders.h"

namespace carom::pipeline::study {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kShot = CAROM_SOURCE_DIR "/examples/bank_shot.yaml";

class Swept : public ::testing::Test {
  public:
    Swept() : variants(kShot, {}, "--vary") {}

    [[nodiscard]] Sweep sweep(const std::vector<std::string>& vary,
                              const std::vector<std::string>& measures) const {
        Sweep sweep;
        for (const std::string& text : vary) {
            sweep.keys.push_back(std::get<VariedKey>(
                parse_varied(text, [&](const std::string& key) { return variants.text_of(key); })));
        }
        for (const std::string& text : measures) {
            sweep.measures.push_back(
                std::get<Measure>(measures::parse_measure(text, variants.own_world())));
        }
        return sweep;
    }

    ShotVariants variants;
};

TEST_F(Swept, Table_IsTheSameWithAnyThreadsAndHasTheEventsOfBakes) {
    const Sweep of = sweep(
        {"events[0].strike.speed=2..5 m/s:0.5", "physics.ball_cushion.model=mathavan2010,han2005"},
        {"time:cushion,cue", "potted:nine", "pocket:nine", "distance:cue"});
    const SweepTable one = run_sweep(of, variants, {.threads = 1});
    const SweepTable two = run_sweep(of, variants, {.threads = 2});
    EXPECT_EQ(one.rows, two.rows);
    ASSERT_EQ(one.rows.size(), 14U);
    const SweepPoints points(of);
    for (std::size_t i = 0; i < one.rows.size(); ++i) {
        std::vector<std::string> overrides;
        for (std::size_t k = 0; k < of.keys.size(); ++k) {
            overrides.push_back(of.keys[k].key + "=" + points.at(i)[k].text);
        }
        const LoadResult loaded = load_shot(kShot, {.overrides = overrides});
        const sim::Timeline timeline = sim::bake(loaded.shot->world);
        const auto cushion = std::ranges::find_if(timeline.events, [](const sim::Event& event) {
            return event.a == "cue" && event.b == "cushion";
        });
        EXPECT_EQ(one.rows[i][2], Value(cushion->time));
    }
}

TEST_F(Swept, Points_ChangeTheFirstKeySlowestAndRepeatTheSamples) {
    Sweep of = sweep({"events[0].strike.speed=2..3 m/s:1", "events[0].strike.direction~0.3 deg",
                      "physics.cushions=lively,dead"},
                     {});
    of.samples = 3;
    const SweepPoints points(of);
    ASSERT_EQ(points.count(), 12U);
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < 12; ++i) {
        const std::vector<VariedPoint> at = points.at(i);
        rows.push_back(at[0].text + " " + at[2].text);
        EXPECT_EQ(at[1].text, points.at(i % 3)[1].text);
    }
    EXPECT_THAT(rows, ElementsAre("2 m/s lively", "2 m/s lively", "2 m/s lively", "2 m/s dead",
                                  "2 m/s dead", "2 m/s dead", "3 m/s lively", "3 m/s lively",
                                  "3 m/s lively", "3 m/s dead", "3 m/s dead", "3 m/s dead"));
    EXPECT_NE(points.at(0)[1].text, points.at(1)[1].text);
}

TEST_F(Swept, Csv_ReadsBackAsTheSameNumbers) {
    const Sweep of = sweep({"events[0].strike.speed=2..4 m/s:0.1"},
                           {"speed_after:contact,nine,cue", "pocket:nine", "time:cushion,nine,9"});
    const SweepTable table = run_sweep(of, variants);
    const std::string csv = csv_of(table);
    EXPECT_THAT(csv, ::testing::StartsWith(
                         "events[0].strike.speed [m/s],\"speed_after:contact,nine,cue [m/s]\","
                         "pocket:nine,\"time:cushion,nine,9 [s]\"\n"));
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    for (const std::vector<Value>& row : table.rows) {
        ASSERT_TRUE(std::getline(lines, line));
        std::istringstream cells(line + ",end");
        for (const Value& value : row) {
            std::string cell;
            std::getline(cells, cell, ',');
            if (const auto* number = std::get_if<double>(&value)) {
                double read = 0;
                std::from_chars(cell.data(), cell.data() + cell.size(), read);
                EXPECT_EQ(read, *number);
            } else {
                const auto* text = std::get_if<std::string>(&value);
                EXPECT_EQ(cell, text != nullptr ? *text : "");
            }
        }
    }
    EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(Swept, JsonLines_HaveTitlesAsNamesAndNullForNothing) {
    const Sweep of =
        sweep({"events[0].strike.speed=2..3 m/s:1"}, {"cushions:cue,nine", "pocket:nine"});
    EXPECT_EQ(json_lines_of(run_sweep(of, variants)),
              "{\"events[0].strike.speed [m/s]\":2,\"cushions:cue,nine\":0,\"pocket:nine\":null}\n"
              "{\"events[0].strike.speed [m/s]\":3,\"cushions:cue,nine\":0,\"pocket:nine\":"
              "\"corner_left_front\"}\n");
}

TEST_F(Swept, Problems_AreFoundInAllVariantsAndSaidOnce) {
    const Sweep of =
        sweep({"events[0].strike.speed=-2..3 m/s:1", "balls.nine.at=[0.3, 0.1],[0.55, -0.35]"},
              {"potted:nine"});
    std::vector<std::string> messages;
    for (const Problem& problem : find_problems(of, variants)) {
        messages.push_back(problem.message);
    }
    EXPECT_THAT(messages,
                ElementsAre("'speed' must be more than 0 m/s and at most 100 m/s, not '-2 m/s'",
                            HasSubstr("'nine' and 'cue' overlap by ")));
    EXPECT_THAT(find_problems(sweep({"events[0].strike.speed=2..3 m/s:1"}, {}), variants),
                IsEmpty());
}

TEST_F(Swept, Stop_KeepsTheVariantsThatAreFinished) {
    const Sweep of = sweep({"events[0].strike.speed=1..6 m/s:0.01"}, {"potted:nine"});
    std::stop_source stop;
    int seen = 0;
    const ProgressCallback progress = [&](double) {
        if (++seen == 20) {
            stop.request_stop();
        }
    };
    const SweepTable table =
        run_sweep(of, variants, {.threads = 2, .context = {progress, stop.get_token()}});
    EXPECT_EQ(table.variants, 501U);
    EXPECT_GE(table.rows.size(), 20U);
    EXPECT_LE(table.rows.size(), 22U);
    EXPECT_THROW((void)run_sweep(of, variants, {.context = {{}, stop.get_token()}}), Stopped);
}

TEST_F(Swept, Samples_AveragesAreThoseOfTheTable) {
    Sweep of = sweep({"events[0].strike.speed=2..3 m/s:1", "events[0].strike.direction~0.3 deg"},
                     {"potted:nine"});
    of.samples = 16;
    const SweepTable table = run_sweep(of, variants);
    const std::vector<PlotSeries> series = plot_series(of, table);
    ASSERT_EQ(series.size(), 1U);
    ASSERT_EQ(series[0].cells[0].size(), 2U);
    double sum = 0;
    for (std::size_t i = 16; i < 32; ++i) {
        sum += std::get<double>(table.rows[i][2]);
    }
    const PlotCell& cell = series[0].cells[0].at({3, 0});
    const double mean = sum / 16;
    EXPECT_DOUBLE_EQ(*cell.mean(), mean);
    EXPECT_NEAR(*cell.standard_error(), std::sqrt(mean * (1 - mean) / 15), 1e-12);
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

TEST_F(Swept, Plot_HasALineForEachWordAndAMapOverTwoKeys) {
    const Sweep lines = sweep(
        {"events[0].strike.speed=2..5 m/s:1", "physics.ball_cushion.model=mathavan2010,han2005"},
        {"rebound_angle:cue"});
    const std::string drawing =
        sweep_plot_svg(lines, run_sweep(lines, variants), "bank <shot>", PlanPage::light);
    EXPECT_THAT(drawing, HasSubstr("bank &lt;shot&gt;"));
    EXPECT_THAT(drawing, HasSubstr(">mathavan2010</text>"));
    EXPECT_THAT(drawing, HasSubstr(">events[0].strike.speed, m/s</text>"));
    EXPECT_THAT(drawing, HasSubstr(">rebound_angle:cue, deg</text>"));
    EXPECT_EQ(count(drawing, "<circle"), 8);
    const Sweep map =
        sweep({"events[0].strike.speed=2..5 m/s:1", "events[0].strike.direction=116..118 deg:0.5"},
              {"rebound_angle:cue", "pocket:nine"});
    const std::string mapped = sweep_plot_svg(map, run_sweep(map, variants), "m", PlanPage::light);
    EXPECT_THAT(mapped, HasSubstr(">corner_left_front</text>"));
    EXPECT_THAT(mapped, HasSubstr(">none</text>"));
    EXPECT_THAT(mapped, HasSubstr(">events[0].strike.direction, deg</text>"));
    EXPECT_THAT(mapped, Not(HasSubstr("nan")));
}

TEST_F(Swept, Plot_OfTooManyOrNoNumbersCannotBeDrawn) {
    EXPECT_EQ(plot_problem(sweep({"events[0].strike.speed=2..5 m/s:1"}, {})), "");
    EXPECT_EQ(plot_problem(sweep({"physics.cushions=lively,dead"}, {})),
              "no varied key has numbers, over which lines could be drawn");
    EXPECT_EQ(
        plot_problem(sweep({"events[0].strike.speed=2..5 m/s:1", "physics.gravity[2]=-9..-8:1",
                            "events[0].strike.elevation=1..2 deg:1"},
                           {})),
        "a drawing has one or two keys of numbers as axes; this sweep has 3");
}

}  // namespace
}  // namespace carom::pipeline::study
