#include "pipeline/server/byte_range.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

namespace carom::server {

namespace {

std::optional<std::uint64_t> number(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

AskedRange part(std::uint64_t begin, std::uint64_t end, std::uint64_t size) {
    if (begin >= end) {
        return {RangeKind::outside, {0, size}};
    }
    return {RangeKind::part, {begin, end}};
}

}  // namespace

AskedRange asked_range(std::string_view field, std::uint64_t size) {
    const AskedRange whole{RangeKind::whole, {0, size}};
    constexpr std::string_view kUnit = "bytes=";
    if (!field.starts_with(kUnit)) {
        return whole;
    }
    field.remove_prefix(kUnit.size());
    const std::size_t dash = field.find('-');
    if (dash == std::string_view::npos) {
        return whole;
    }
    const std::optional<std::uint64_t> first = number(field.substr(0, dash));
    const std::optional<std::uint64_t> last = number(field.substr(dash + 1));
    if (dash == 0) {  // the last bytes
        return last ? part(size - std::min(*last, size), size, size) : whole;
    }
    const bool is_open = dash + 1 == field.size();
    if (!first || (!last && !is_open) || (last && *last < *first)) {
        return whole;  // not a valid range
    }
    return part(*first, is_open || *last >= size ? size : *last + 1, size);
}

}  // namespace carom::server
