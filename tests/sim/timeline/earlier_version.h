// Bakes of another version of the format.
#pragma once

#include <span>
#include <string>

#include "sim/timeline/bake_file.h"

namespace carom::sim::test {

/// A bake's bytes with an earlier version of the format in their header, whose place is not fixed;
/// empty if they are not those of a bake.
[[nodiscard]] inline std::string with_earlier_version(const std::string& bytes) {
    for (std::size_t place = 8; place + 4 < 128 && place < bytes.size(); place += 4) {
        std::string copy = bytes;
        copy[place] = static_cast<char>(copy[place] - 1);
        try {
            (void)decode_bake(std::as_bytes(std::span(copy)), "old");
        } catch (const OtherBakeVersion&) {
            return copy;
        } catch (const Error&) {
            continue;
        }
    }
    return {};
}

}  // namespace carom::sim::test
