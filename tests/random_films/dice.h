// Random choices, which are the same on all machines for the same seed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <random>
#include <string>

namespace carom::testing {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed * 0x9e3779b97f4a7c15 + 1) {}

    [[nodiscard]] double fraction() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    [[nodiscard]] double between(double low, double high) {
        return low + (high - low) * fraction();
    }
    [[nodiscard]] int below(int count) { return static_cast<int>(fraction() * count); }
    [[nodiscard]] bool chance(double probability) { return fraction() < probability; }
    [[nodiscard]] std::string pick(std::initializer_list<const char*> choices) {
        return *(choices.begin() + below(static_cast<int>(choices.size())));
    }

    /// A number as YAML text.
    [[nodiscard]] std::string number(double low, double high) { return text(between(low, high)); }
    /// A number whose logarithm is uniformly distributed.
    [[nodiscard]] std::string magnitude(double low, double high) {
        return text(low * std::pow(high / low, fraction()));
    }
    [[nodiscard]] std::string vector(double low, double high, const std::string& unit = "") {
        const std::string end = unit.empty() ? "" : " " + unit;
        return "[" + number(low, high) + end + ", " + number(low, high) + end + ", " +
               number(low, high) + end + "]";
    }
    [[nodiscard]] std::string colour() { return chance(0.2) ? number(0, 1) : vector(0, 1); }
    [[nodiscard]] std::string point(double x, double y, double low, double high) {
        return "[" + number(-x, x) + ", " + number(-y, y) + ", " + number(low, high) + "]";
    }

    [[nodiscard]] static std::string text(double value) {
        std::array<char, 32> buffer{};
        std::snprintf(buffer.data(), buffer.size(), "%.5g", value);
        return buffer.data();
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace carom::testing
