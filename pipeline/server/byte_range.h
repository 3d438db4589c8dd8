// Byte ranges of a resource (RFC 9110, section 14).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace carom::server {

/// The bytes from `begin` up to, but without, `end`.
struct ByteRange {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
};

enum class RangeKind {
    whole,    // no range is asked, or one in a form that a server may ignore
    part,     // `range` is not empty
    outside,  // no byte of the resource is in the range: 416
};

struct AskedRange {
    RangeKind kind = RangeKind::whole;
    ByteRange range;  // the whole resource unless `kind` is `part`
};

/// The meaning of the field Range ("bytes=0-99", "bytes=100-", "bytes=-100") for a resource of this
/// size. Several ranges at once are ignored, as the standard allows.
[[nodiscard]] AskedRange asked_range(std::string_view field, std::uint64_t size);

}  // namespace carom::server
