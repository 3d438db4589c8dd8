// A key of a shot whose value differs from variant to variant.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/config/measures/text_problem.h"

namespace carom::pipeline::study {

using measures::TextProblem;

/// A value of a varied key.
struct VariedPoint {
    std::string text;              // as in the shot: "1.5 m/s"
    std::optional<double> number;  // 1.5; empty: a word or a list
};

struct VariedKey {
    std::string key;   // as in --set: "events[0].strike.speed"
    std::string unit;  // of its numbers; empty: none
    /// Listed values, of which every combination with those of other keys is wanted; empty: it is
    /// sampled.
    std::vector<VariedPoint> points;
    bool is_normal = false;  // sampled: normally distributed, else evenly from `low` to `high`
    double low = 0, high = 0;
    double mean = 0, deviation = 0;

    [[nodiscard]] bool is_sampled() const { return points.empty(); }
    /// Whether all values are numbers.
    [[nodiscard]] bool is_numeric() const;
    /// The value at a coordinate of a sampled point, in (0, 1).
    [[nodiscard]] VariedPoint at(double coordinate) const;
    /// "events[0].strike.speed [m/s]"
    [[nodiscard]] std::string title() const;
};

/// The text of a value of the shot; empty if it has none.
using TextOfKey = std::function<std::optional<std::string>(const std::string& key)>;

/// One of
///   KEY=LOW..HIGH UNIT:STEP   a range in steps
///   KEY=LOW..HIGH UNIT        a range that is sampled
///   KEY=VALUE,VALUE,...       a list
///   KEY~ERROR UNIT            the shot's value with a normal error, sampled
///   KEY=VALUE~ERROR UNIT      another value with one
[[nodiscard]] std::variant<VariedKey, TextProblem> parse_varied(const std::string& text,
                                                                const TextOfKey& text_of);

}  // namespace carom::pipeline::study
