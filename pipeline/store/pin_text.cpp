#include "pipeline/store/pin_text.h"

#include <charconv>
#include <span>
#include <sstream>
#include <string_view>

#include <fmt/core.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file_reader.h"
#include "pipeline/store/cache_entry.h"

namespace carom::pipeline {
namespace {

constexpr std::string_view kOwner = "owner ";
constexpr std::string_view kFolder = "folder ";
constexpr std::string_view kBytes = "bytes ";

std::uint64_t parse_number(std::string_view digits) {
    std::uint64_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

}  // namespace

std::string bytes_line(std::uint64_t bytes_each) {
    return fmt::format("{}{:020}\n", kBytes, bytes_each);
}

// The bytes are last of the three, so that the first ones are there when the file is changed.
std::string text_of(const PinText& pin) {
    std::string text = fmt::format("{}{}\n", kOwner, pin.owner);
    if (!pin.folder.empty()) {
        text += fmt::format("{}{}\n", kFolder, pin.folder);
    }
    text += bytes_line(pin.bytes_each);
    for (const Hash128& key : pin.keys) {
        text += key.to_string() + "\n";
    }
    return text;
}

PinText parse_pin(const std::string& text) {
    PinText pin;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with(kOwner)) {
            pin.owner = line.substr(kOwner.size());
        } else if (line.starts_with(kFolder)) {
            pin.folder = line.substr(kFolder.size());
        } else if (line.starts_with(kBytes)) {
            pin.bytes_each = parse_number(std::string_view(line).substr(kBytes.size()));
        } else if (const std::optional<Hash128> key = parse_key(line)) {
            pin.keys.push_back(*key);
        }
    }
    return pin;
}

std::optional<PinText> read_pin(const std::string& path) {
    try {
        FileReader file(path);
        std::string text(file.size().value_or(0), '\0');
        text.resize(file.read(std::as_writable_bytes(std::span(text))));
        return parse_pin(text);
    } catch (const Error&) {
        if (::access(path.c_str(), F_OK) != 0) {
            return std::nullopt;  // removed meanwhile
        }
        throw;
    }
}

}  // namespace carom::pipeline
