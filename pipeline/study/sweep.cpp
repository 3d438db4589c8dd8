#include "pipeline/study/sweep.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/json_text.h"
#include "pipeline/export/csv_text.h"

namespace carom::pipeline::study {

namespace {

bool has_samples(const Sweep& sweep) {
    return std::ranges::any_of(sweep.keys, &VariedKey::is_sampled);
}

std::vector<VariedValue> values_of(const Sweep& sweep, const std::vector<VariedPoint>& points) {
    std::vector<VariedValue> values;
    for (std::size_t i = 0; i < points.size(); ++i) {
        values.push_back({sweep.keys[i].key, points[i].text});
    }
    return values;
}

/// Whether all variants have the world of the shot, but for its events.
bool varies_events_alone(const Sweep& sweep) {
    return std::ranges::all_of(sweep.keys,
                               [](const VariedKey& key) { return is_in_events(key.key); });
}

/// What comes of a variant of a sweep.
struct Measured {
    bool is_finished = false;
    bool is_too_long = false;  // it takes too many steps, and has no values
    std::vector<Value> values;
    std::string warning;  // the first of the simulation; empty: none
};

/// Simulates variants of a sweep and measures them.
class Player {
  public:
    Player(const Sweep& sweep, const ShotVariants& variants, std::stop_token stop)
        : sweep_(sweep), variants_(variants) {
        limits_.max_steps = kMostSteps;
        limits_.stop = std::move(stop);
        limits_.keeps_motion = std::ranges::any_of(sweep.measures, &Measure::needs_motion);
        if (varies_events_alone(sweep)) {
            shared_.emplace(variants.own_world());
        }
    }

    [[nodiscard]] Measured play(const std::vector<VariedPoint>& points) const {
        const std::vector<VariedValue> values = values_of(sweep_, points);
        if (shared_) {
            return measured(*shared_, std::move(*variants_.events(values).events));
        }
        const sim::Trials own(std::move(*variants_.world(values).world));
        return measured(own, own.world().events);
    }

  private:
    [[nodiscard]] Measured measured(const sim::Trials& trials,
                                    std::vector<sim::ForceEvent> events) const {
        const std::optional<sim::Outcome> outcome = trials.run(std::move(events), limits_);
        Measured result;
        result.is_finished = true;
        if (!outcome) {
            result.is_too_long = true;
            return result;
        }
        const measures::Played played{trials.world(), trials.names(), *outcome};
        for (const Measure& measure : sweep_.measures) {
            result.values.push_back(measure.value(played));
        }
        if (!outcome->warnings.empty()) {
            result.warning = outcome->warnings.front().sentence;
        }
        return result;
    }

    const Sweep& sweep_;
    const ShotVariants& variants_;
    sim::TrialLimits limits_;
    std::optional<sim::Trials> shared_;
};

void add_row(const std::vector<VariedPoint>& points, Measured measured, SweepTable& table) {
    std::vector<Value>& row = table.rows.emplace_back();
    for (const VariedPoint& point : points) {
        row.push_back(point.number ? Value(*point.number) : Value(point.text));
    }
    std::ranges::move(measured.values, std::back_inserter(row));
    table.unfinished += measured.is_too_long ? 1 : 0;
    row.resize(table.columns.size());
    if (!measured.warning.empty() && table.warned++ == 0) {
        table.first_warning = std::move(measured.warning);
    }
}

}  // namespace

SweepPoints::SweepPoints(const Sweep& sweep) : sweep_(&sweep), count_(variant_count(sweep)) {
    std::vector<const VariedKey*> sampled;
    for (const VariedKey& key : sweep.keys) {
        if (key.is_sampled()) {
            sampled.push_back(&key);
        }
    }
    if (sampled.empty()) {
        return;
    }
    for (const std::vector<double>& point :
         sample_points(sweep.sampling, sweep.samples, sampled.size(), sweep.seed)) {
        std::vector<VariedPoint>& sample = samples_.emplace_back();
        for (std::size_t d = 0; d < sampled.size(); ++d) {
            sample.push_back(sampled[d]->at(point[d]));
        }
    }
}

std::vector<VariedPoint> SweepPoints::at(std::size_t index) const {
    std::size_t rest = index;
    const std::vector<VariedPoint>* sample = nullptr;
    if (!samples_.empty()) {
        sample = &samples_[rest % samples_.size()];
        rest /= samples_.size();
    }
    std::vector<VariedPoint> points(sweep_->keys.size());
    std::size_t next_sampled = sample != nullptr ? sample->size() : 0;
    for (std::size_t i = points.size(); i-- > 0;) {
        const VariedKey& key = sweep_->keys[i];
        if (key.is_sampled()) {
            points[i] = (*sample)[--next_sampled];
        } else {
            points[i] = key.points[rest % key.points.size()];
            rest /= key.points.size();
        }
    }
    return points;
}

std::size_t variant_count(const Sweep& sweep) {
    constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
    std::size_t count = has_samples(sweep) ? sweep.samples : 1;
    for (const VariedKey& key : sweep.keys) {
        if (!key.is_sampled()) {
            count = count > kMost / key.points.size() ? kMost : count * key.points.size();
        }
    }
    return count;
}

std::vector<Problem> find_problems(const Sweep& sweep, const ShotVariants& variants,
                                   const PartsWork& work) {
    const SweepPoints points(sweep);
    const bool is_quick = varies_events_alone(sweep);
    std::mutex mutex;
    std::map<std::size_t, std::vector<Problem>> found;
    do_parts(
        points.count(),
        [&](std::size_t i) {
            const std::vector<VariedValue> values = values_of(sweep, points.at(i));
            std::vector<Problem> problems =
                is_quick ? variants.events(values).problems : variants.world(values).problems;
            if (has_errors(problems)) {
                const std::lock_guard lock(mutex);
                found.emplace(i, std::move(problems));
            }
        },
        work);
    // A value that is wrong in one variant is so in many, and each says it in its own numbers.
    std::vector<Problem> all;
    std::set<std::tuple<std::string, int, int, std::string>> places;
    for (auto& [index, problems] : found) {
        for (Problem& problem : problems) {
            const SourcePlace& place = problem.place;
            if (problem.severity == Severity::error &&
                places.emplace(place.file, place.line, place.column, problem.key_path).second) {
                all.push_back(std::move(problem));
            }
        }
    }
    return all;
}

SweepTable run_sweep(const Sweep& sweep, const ShotVariants& variants, const PartsWork& work) {
    const SweepPoints points(sweep);
    const Player player(sweep, variants, work.context.stop);
    std::vector<Measured> measured(points.count());
    try {
        do_parts(
            points.count(), [&](std::size_t i) { measured[i] = player.play(points.at(i)); }, work);
    } catch (const Stopped&) {
        if (std::ranges::none_of(measured, &Measured::is_finished)) {
            throw;
        }
    }
    SweepTable table;
    table.variants = points.count();
    for (const VariedKey& key : sweep.keys) {
        table.columns.push_back({key.title(), false});
    }
    for (const Measure& measure : sweep.measures) {
        table.columns.push_back({measure.title(), true});
    }
    for (std::size_t i = 0; i < measured.size(); ++i) {
        if (measured[i].is_finished) {
            add_row(points.at(i), std::move(measured[i]), table);
        }
    }
    return table;
}

std::string csv_of(const SweepTable& table) {
    CsvText csv;
    for (const SweepColumn& column : table.columns) {
        csv.add(column.title);
    }
    csv.end_row();
    for (const std::vector<Value>& row : table.rows) {
        for (const Value& value : row) {
            if (const auto* number = std::get_if<double>(&value)) {
                csv.add(*number);
            } else {
                const auto* text = std::get_if<std::string>(&value);
                csv.add(text != nullptr ? std::string_view(*text) : std::string_view());
            }
        }
        csv.end_row();
    }
    return csv.finish();
}

std::string json_lines_of(const SweepTable& table) {
    std::string lines;
    for (const std::vector<Value>& row : table.rows) {
        JsonMembers members;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string& title = table.columns[i].title;
            if (const auto* text = std::get_if<std::string>(&row[i])) {
                members.add(title, *text);
            } else {
                const auto* number = std::get_if<double>(&row[i]);
                members.add(title,
                            number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN());
            }
        }
        lines += members.object() + "\n";
    }
    return lines;
}

}  // namespace carom::pipeline::study
