#include "pipeline/cli/terminal/duration_text.h"

#include <array>
#include <cmath>

#include <fmt/core.h>

namespace carom::cli {

namespace {

std::string two_units(long long large, const char* large_unit, long long small,
                      const char* small_unit) {
    return fmt::format("{} {} {:02} {}", large, large_unit, small, small_unit);
}

}  // namespace

std::string duration_text(double seconds) {
    constexpr double kThousandYears = 3.2e10;
    if (!(seconds >= 0 && seconds < kThousandYears)) {
        return "?";
    }
    const long long whole = std::llround(seconds);
    if (whole < 60) {
        return fmt::format("{} s", whole);
    }
    if (whole < 3600) {
        return two_units(whole / 60, "min", whole % 60, "s");
    }
    const long long minutes = std::llround(seconds / 60);
    if (minutes < 24LL * 60) {
        return two_units(minutes / 60, "h", minutes % 60, "min");
    }
    const long long hours = std::llround(seconds / 3600);
    return two_units(hours / 24, "d", hours % 24, "h");
}

std::string rate_text(double value, const std::string& unit) {
    struct Prefix {
        double factor;
        const char* letter;
    };
    constexpr std::array kPrefixes{Prefix{1e9, "G"}, Prefix{1e6, "M"}, Prefix{1e3, "k"}};
    const char* letter = "";
    for (const Prefix& prefix : kPrefixes) {
        // 0.9995 and more would be rounded to 1000 with the smaller prefix
        if (value >= 0.9995 * prefix.factor) {
            value /= prefix.factor;
            letter = prefix.letter;
            break;
        }
    }
    const int decimals = value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
    return fmt::format("{:.{}f} {}{}", value, decimals, letter, unit);
}

}  // namespace carom::cli
