// Converts sizes of caches between bytes and text.
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/store/cache_maintenance.h"

namespace carom::pipeline {
namespace {

constexpr std::uint64_t kDefaultLimit = 20'000'000'000;

constexpr std::array<std::pair<std::string_view, double>, 5> kUnits{
    {{"TB", 1e12}, {"GB", 1e9}, {"MB", 1e6}, {"kB", 1e3}, {"B", 1}}};

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) {
        text.remove_prefix(1);
    }
    while (text.ends_with(' ')) {
        text.remove_suffix(1);
    }
    return text;
}

[[noreturn]] void throw_not_a_size(std::string_view text) {
    throw Error("'" + std::string(text) +
                "' is not a size; write a number with its unit, such as 500 MB or 20 GB, or none");
}

}  // namespace

std::uint64_t parse_cache_size(std::string_view text) {
    std::string_view rest = trimmed(text);
    if (rest == "none") {
        return kNoLimit;
    }
    double unit = 0;
    for (const auto& [name, value] : kUnits) {
        if (rest.ends_with(name)) {
            rest.remove_suffix(name.size());
            unit = value;
            break;
        }
    }
    const std::string number(trimmed(rest));
    // Only digits and a point are allowed: strtod would also accept "inf", "0x1" and signs.
    if (number.empty() || number.find_first_not_of("0123456789.") != std::string::npos ||
        (unit == 0 && number != "0")) {
        throw_not_a_size(text);
    }
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end) * unit;
    if (*end != '\0' || value > 1e18) {
        throw_not_a_size(text);
    }
    return static_cast<std::uint64_t>(std::llround(value));
}

std::string size_text(std::uint64_t bytes) {
    if (bytes == kNoLimit) {
        return "no limit";
    }
    const auto value = static_cast<double>(bytes);
    for (const auto& [name, unit] : kUnits) {
        if (value >= 0.9995 * unit) {  // a smaller unit would round up to 1000
            return unit == 1 ? fmt::format("{:.0f} {}", value, name)
                             : fmt::format("{:.3g} {}", value / unit, name);
        }
    }
    return "0 B";
}

std::uint64_t cache_size_limit(const std::string& given) {
    if (!given.empty()) {
        return parse_cache_size(given);
    }
    const char* environment = std::getenv("CAROM_CACHE_SIZE");
    if (environment != nullptr && *environment != '\0') {
        try {
            return parse_cache_size(environment);
        } catch (const Error& error) {
            throw Error(std::string("CAROM_CACHE_SIZE: ") + error.what());
        }
    }
    return kDefaultLimit;
}

}  // namespace carom::pipeline
