#include "core/limits.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

#include <fmt/core.h>

namespace carom {
namespace {

constexpr double kMaxScale = 1000;

double read_scale() {
    const char* given = std::getenv("CAROM_LIMITS");
    const std::string_view text = given != nullptr ? given : "";
    double scale = 1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), scale);
    const bool is_read = error == std::errc() && end == text.data() + text.size();
    return is_read && scale >= 1 && scale <= kMaxScale ? scale : 1;
}

}  // namespace

std::size_t input_limit(std::size_t usual) {
    static const double scale = read_scale();
    return static_cast<std::size_t>(static_cast<double>(usual) * scale);
}

std::string beyond_limit(std::size_t limit, const std::string& what) {
    return fmt::format("more than {} {}{}", limit, what, how_to_raise_limits());
}

const char* how_to_raise_limits() {
    return "; CAROM_LIMITS=2 in the environment doubles all such limits";
}

}  // namespace carom
