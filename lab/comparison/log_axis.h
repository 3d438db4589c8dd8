// A logarithmic axis of a chart.
#pragma once

#include <string>
#include <vector>

namespace carom::pipeline {

/// Spans whole powers of ten around all values.
class LogAxis {
  public:
    /// Positions of the ends on the page, mm.
    LogAxis(double from, double to) : from_(from), to_(to) {}

    /// Values that are not above 0 are ignored.
    void add(double value);
    [[nodiscard]] double at(double value) const;

    /// Exponents of the ends.
    [[nodiscard]] int lowest() const;
    [[nodiscard]] int highest() const;

  private:
    double from_, to_;
    double least_ = 0, most_ = 0;  // 0: no value yet
};

/// "0.01", "1", "100", "10k", "1M"
[[nodiscard]] std::string power_text(int exponent);

}  // namespace carom::pipeline
