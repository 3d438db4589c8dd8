#include "pipeline/import/import_track.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include <fmt/core.h>

#include "core/error.h"
#include "core/limits.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"
#include "pipeline/import/conversion.h"
#include "pipeline/import/track_table.h"
#include "pipeline/shot/keyed_motion.h"
#include "sim/timeline/rotation.h"

namespace carom::pipeline {

namespace {

using scene_text::yaml;

constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr std::size_t kMostKeys = 1000;  // of a motion
// Up to this angle the end orientation determines a turn.
constexpr double kUnambiguousTurn = 0.9 * std::numbers::pi;
constexpr double kFarthestTurn = 200 * std::numbers::pi;  // between two keys
constexpr double kGap = 1e-6;  // s, between the two keys of a velocity jump

Quat about(const Vec3& axis, double angle) {
    return sim::rotation_from_vector(angle * axis);
}

Quat orientation_of(const TrackRow& row) {
    if (row.angles) {
        const Vec3& a = *row.angles;
        return about({0, 0, 1}, a.z) * about({0, 1, 0}, a.y) * about({1, 0, 0}, a.x);
    }
    return row.rotate.value_or(Quat());
}

/// The rotation vector nearest to `expected` that differs from `remainder` by full turns.
Vec3 with_full_turns(const Vec3& remainder, const Vec3& expected) {
    const double angle = remainder.length();
    const Vec3 axis = angle > 1e-9                           ? remainder / angle
                      : expected.length() > std::numbers::pi ? expected.normalized()
                                                             : Vec3(0, 0, 1);
    const double rounds = std::round((expected.dot(axis) - angle) / (2 * std::numbers::pi));
    return remainder + 2 * std::numbers::pi * rounds * axis;
}

/// The rotation vector from one row to the next, world axes. It includes full turns if angular
/// velocities or a single changing angle show them; otherwise it is the shorter rotation.
Vec3 turn_between(const TrackRow& from, const TrackRow& to, config::ProblemList& problems) {
    const Vec3 remainder = sim::rotation_vector(orientation_of(to) * ~orientation_of(from));
    if (from.spin && to.spin) {
        return with_full_turns(remainder, (to.time - from.time) * (*from.spin + *to.spin) / 2);
    }
    if (!from.angles) {
        return remainder;
    }
    const Vec3 change = *to.angles - *from.angles;
    if (std::max({std::abs(change.x), std::abs(change.y), std::abs(change.z)}) <=
        std::numbers::pi) {
        return remainder;
    }
    // Each angle rotates about its own axis, which the later rotations have turned.
    const Vec3& a = *from.angles;
    if (change.x == 0 && change.y == 0) {
        return {0, 0, change.z};
    }
    if (change.x == 0 && change.z == 0) {
        return change.y * about({0, 0, 1}, a.z).rotateVector(Vec3(0, 1, 0));
    }
    if (change.y == 0 && change.z == 0) {
        return change.x *
               (about({0, 0, 1}, a.z) * about({0, 1, 0}, a.y)).rotateVector(Vec3(1, 0, 0));
    }
    problems.error(to.place,
                   "the object turns by more than 180 degrees since the previous row, and about "
                   "more than one axis: add rows in between");
    return remainder;
}

class Motion {
  public:
    Motion(std::vector<TrackRow> rows, const ImportTrackOptions& options,
           config::ProblemList& problems)
        : rows_(std::move(rows)), options_(options) {
        turns_.emplace_back(0, 0, 0);
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            if (rows_[i].time == rows_[i - 1].time) {
                rows_[i].time += kGap;  // the key after the jump
            }
            turns_.push_back(turn_between(rows_[i - 1], rows_[i], problems));
            if (turns_.back().length() > kFarthestTurn) {
                problems.error(rows_[i].place,
                               "the object makes more than 100 turns since the previous row: add "
                               "rows in between");
            }
        }
        has_turns_ = rows_.front().rotate || rows_.front().angles;
        choose_first();
        if (problems.has_error()) {
            return;
        }
        try {
            refine(problems);
        } catch (const Error& error) {  // too many turns for a track
            problems.error(rows_.front().place, error.what());
        }
    }

    [[nodiscard]] const std::vector<MotionKey>& keys() const { return keys_; }
    [[nodiscard]] bool has_turns() const { return has_turns_; }

  private:
    /// Keeps the first and the last row, and both rows of each velocity jump.
    void choose_first() {
        is_kept_.assign(rows_.size(), options_.error == 0);
        is_kept_.front() = is_kept_.back() = true;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            if (rows_[i].time - rows_[i - 1].time <= kGap * 1.5) {
                is_kept_[i] = is_kept_[i - 1] = true;
            }
        }
    }

    /// Adds the row of largest error in every interval between keys, until all rows are within the
    /// error.
    void refine(config::ProblemList& problems) {
        bool is_met = false;
        while (!is_met) {
            make_keys();
            if (keys_.size() > kMostKeys) {
                problems.error(
                    rows_.front().place,
                    fmt::format("the motion needs more than {} keys to follow all rows within "
                                "{} mm: allow a larger --error, or give fewer rows",
                                kMostKeys, config::show(1000 * options_.error)));
                return;
            }
            const sim::Track track = keyed_track("track", {keys_, options_.is_linear});
            is_met = true;
            std::size_t begin = 0;
            for (std::size_t end = 1; end < rows_.size(); ++end) {
                if (is_kept_[end]) {
                    is_met = !keep_worst(track, begin, end) && is_met;
                    begin = end;
                }
            }
        }
    }

    /// Keeps the row of largest error between two kept rows. Returns false if all rows are within
    /// the error.
    bool keep_worst(const sim::Track& track, std::size_t begin, std::size_t end) {
        double worst = 1;
        std::size_t at = 0;
        for (std::size_t i = begin + 1; i < end; ++i) {
            const MotionState state = track.sample(rows_[i].time);
            double fraction = (state.position - rows_[i].position).length() / options_.error;
            if (has_turns_) {
                const double angle =
                    sim::angle_between(state.orientation, orientation_of(rows_[i]));
                fraction = std::max(fraction, angle / options_.turn_error);
            }
            if (fraction > worst) {
                worst = fraction;
                at = i;
            }
        }
        if (at == 0 && is_ambiguous(begin, end)) {
            at = (begin + end) / 2;
        }
        if (at != 0 && at != begin) {
            is_kept_[at] = true;
            return true;
        }
        return false;
    }

    /// The sum of all turns from row to row, if they have a common axis.
    [[nodiscard]] std::optional<Vec3> whole_turn(std::size_t begin, std::size_t end) const {
        Vec3 sum(0, 0, 0);
        for (std::size_t i = begin + 1; i <= end; ++i) {
            if (sum.cross(turns_[i]).length() > 1e-7 * sum.length() * turns_[i].length() + 1e-12) {
                return std::nullopt;
            }
            sum += turns_[i];
        }
        return sum;
    }

    [[nodiscard]] double turned(std::size_t begin, std::size_t end) const {
        double sum = 0;
        for (std::size_t i = begin + 1; i <= end; ++i) {
            sum += turns_[i].length();
        }
        return sum;
    }

    /// Whether the turn is larger than a key may have, or large and not about one axis, so that
    /// neither the end orientation nor a single rotation describes it.
    [[nodiscard]] bool is_ambiguous(std::size_t begin, std::size_t end) const {
        const double angle = turned(begin, end);
        return end > begin + 1 &&
               (angle > kFarthestTurn || (angle > kUnambiguousTurn && !whole_turn(begin, end)));
    }

    void make_keys() {
        keys_.clear();
        std::size_t last = 0;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (!is_kept_[i]) {
                continue;
            }
            MotionKey key;
            key.time = rows_[i].time;
            key.position = rows_[i].position;
            if (!options_.is_linear) {
                key.velocity = rows_[i].velocity;
            }
            if (has_turns_ && i > 0 && turned(last, i) > kUnambiguousTurn) {
                key.turn = whole_turn(last, i);
            }
            if (has_turns_ && !key.turn) {
                key.rotate = orientation_of(rows_[i]);
            }
            keys_.push_back(key);
            last = i;
        }
    }

    std::vector<TrackRow> rows_;
    ImportTrackOptions options_;
    std::vector<Vec3> turns_;  // from the previous row
    std::vector<bool> is_kept_;
    std::vector<MotionKey> keys_;
    bool has_turns_ = false;
};

/// "{axis: [0, 0, 1], angle: 1.5}"
std::string turn_text(const Vec3& turn) {
    const double angle = turn.length();
    const Vec3 axis = angle > 0 ? turn / angle : Vec3(0, 0, 1);
    return "{axis: " + yaml(axis) + ", angle: " + yaml(angle) + " rad}";
}

std::string motion_text(const std::vector<MotionKey>& keys, bool is_linear,
                        const std::string& indent) {
    std::ostringstream out;
    out << indent << "motion:\n";
    if (is_linear) {
        out << indent << "  easing: linear\n";
    }
    out << indent << "  keys:\n";
    for (const MotionKey& key : keys) {
        out << indent << "    - {at: " << config::show(key.time)
            << ", position: " << yaml(*key.position);
        if (key.turn) {
            out << ", turn: " << turn_text(*key.turn);
        } else if (key.rotate) {
            out << ", rotate: " << turn_text(sim::rotation_vector(*key.rotate));
        }
        if (key.velocity) {
            out << ", velocity: " << yaml(*key.velocity);
        }
        out << "}\n";
    }
    return out.str();
}

std::string whole_text(const std::string& table, const ImportTrackOptions& options,
                       const std::vector<MotionKey>& keys, std::size_t rows) {
    std::string from = std::filesystem::path(table).filename().string();
    std::ranges::replace_if(
        from, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    std::string text = fmt::format(
        "# Made by carom import-track from {}: {} keys for {} rows{}.\n", from, keys.size(), rows,
        (keys.size() < rows
             ? ", with errors of at most " + config::show(1000 * options.error) + " mm"
             : std::string()));
    if (options.name.empty()) {
        return text +
               "# Insert this below an object of a shot, with the indentation of its other "
               "keys.\n" +
               motion_text(keys, options.is_linear, "");
    }
    return text + "# Include this file in a shot whose 'objects' describe the look of '" +
           options.name + "'.\ncarom: 1\nobjects:\n  " + options.name + ":\n" +
           motion_text(keys, options.is_linear, "    ");
}

}  // namespace

ImportTrackResult import_track(const std::string& text, const std::string& name,
                               const ImportTrackOptions& options) {
    config::SourceSet sources;
    config::ProblemList problems(sources);
    const int source = sources.add({name, ".", text});
    ImportTrackResult result;
    std::vector<TrackRow> rows = read_track_table(sources, source, options.object, problems);
    if (!problems.has_error()) {
        result.rows = rows.size();
        const Motion motion(std::move(rows), options, problems);
        result.keys = motion.keys().size();
        if (!problems.has_error()) {
            result.yaml = whole_text(name, options, motion.keys(), result.rows);
        }
    }
    result.problems = problems.take();
    return result;
}

ImportTrackResult import_track_file(const std::string& path, const ImportTrackOptions& options) {
    std::string text;
    const bool is_read = config::read_text_file(path, input_limit(kMostBytes), text);
    if (is_read && config::find_invalid_utf8(text) == std::string::npos) {
        return import_track(text, path, options);
    }
    ImportTrackResult result;
    result.problems.push_back({Severity::error,
                               {path, 0, 0, 1},
                               {},
                               "this file " + (is_read ? "is not text in UTF-8" : text),
                               {}});
    return result;
}

}  // namespace carom::pipeline
