// What the file of a pin says.
//   owner TEXT       for people: "process 123 on n7", "farm job film-0a1b2c-1"
//   folder PATH      optional, relative to the cache: the pin counts only while this folder exists
//   bytes NUMBER     what each file that does not exist yet is expected to take
//   KEY              a file that the job needs; any number of lines
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/hash.h"

namespace carom::pipeline {

struct PinText {
    std::string owner;
    std::string folder;            // empty: none
    std::uint64_t bytes_each = 0;  // 0: not known, nothing is reserved
    std::vector<Hash128> keys;
};

/// As text. The line with the bytes has the same length for every number.
[[nodiscard]] std::string text_of(const PinText& pin);

/// The line with the bytes, which is the same text wherever it stands.
[[nodiscard]] std::string bytes_line(std::uint64_t bytes_each);

/// Lines that are not understood are ignored.
[[nodiscard]] PinText parse_pin(const std::string& text);

/// The pin in a file; empty if there is no such file. Throws Error if it cannot be read.
[[nodiscard]] std::optional<PinText> read_pin(const std::string& path);

}  // namespace carom::pipeline
