#include "pipeline/job/frame_range.h"

#include <algorithm>
#include <charconv>

#include <fmt/core.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// Reads a number from the front of `text` and removes it there.
bool take_number(std::string_view& text, std::int64_t& value) {
    if (text.empty() || text.front() < '0' || text.front() > '9') {
        return false;
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) {
        return false;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

bool take(std::string_view& text, char letter) {
    if (text.empty() || text.front() != letter) {
        return false;
    }
    text.remove_prefix(1);
    return true;
}

FrameRange::Part parse_part(std::string_view text) {
    const std::string quoted = "'" + std::string(text) + "'";
    FrameRange::Part part;
    bool is_readable = take_number(text, part.first);
    part.last = part.first;
    if (is_readable && take(text, '-')) {
        is_readable = take_number(text, part.last);
        if (is_readable && take(text, 'x')) {
            is_readable = take_number(text, part.step);
        }
    }
    if (!is_readable || !text.empty()) {
        throw Error(quoted +
                    " is not a range of frames; write a frame (12), a range (0-47) or every n-th "
                    "frame of a range (0-47x2)");
    }
    if (part.last < part.first) {
        throw Error("the range of frames " + quoted +
                    " is reversed; write the smaller number first");
    }
    if (part.step < 1) {
        throw Error("the range of frames " + quoted + " has a step of 0; write at least 1");
    }
    return part;
}

}  // namespace

std::int64_t FrameRange::last() const {
    std::int64_t result = -1;
    for (const Part& part : parts) {
        const std::int64_t beyond = (part.last - part.first) % part.step;
        result = std::max(result, part.last - beyond);
    }
    return result;
}

std::vector<std::int64_t> FrameRange::frames(std::int64_t count) const {
    std::vector<Part> wanted = parts;
    if (wanted.empty()) {
        wanted.push_back({0, count - 1, 1});
    }
    std::vector<bool> is_wanted(static_cast<std::size_t>(std::max<std::int64_t>(count, 0)));
    for (const Part& part : wanted) {
        const std::int64_t last = std::min(part.last, count - 1);
        for (std::int64_t number = part.first; number <= last; number += part.step) {
            is_wanted[static_cast<std::size_t>(number)] = true;
            if (part.step > last - number) {
                break;  // the sum would overflow
            }
        }
    }
    std::vector<std::int64_t> numbers;
    for (std::size_t number = 0; number < is_wanted.size(); ++number) {
        if (is_wanted[number]) {
            numbers.push_back(static_cast<std::int64_t>(number));
        }
    }
    return numbers;
}

FrameRange parse_frame_range(std::string_view text) {
    FrameRange range;
    std::string_view rest = text;
    while (true) {
        const std::size_t comma = rest.find(',');
        range.parts.push_back(parse_part(trimmed(rest.substr(0, comma))));
        if (comma == std::string_view::npos) {
            return range;
        }
        rest.remove_prefix(comma + 1);
    }
}

std::vector<std::int64_t> FrameChunk::part_of(const std::vector<std::int64_t>& frames) const {
    const std::ptrdiff_t count = std::ssize(frames);
    const std::ptrdiff_t shorter = count / of, longer_ones = count % of;
    const auto begin_of = [&](std::int64_t chunk) {  // counted from 0
        return frames.begin() + chunk * shorter + std::min(chunk, longer_ones);
    };
    return {begin_of(number - 1), begin_of(number)};
}

FrameChunk parse_frame_chunk(std::string_view text) {
    std::string_view rest = trimmed(text);
    FrameChunk chunk;
    if (!take_number(rest, chunk.number) || !take(rest, '/') || !take_number(rest, chunk.of) ||
        !rest.empty()) {
        throw Error("'" + std::string(text) +
                    "' is not a chunk; write its number and the number of chunks (2/8)");
    }
    if (chunk.of < 1 || chunk.number < 1 || chunk.number > chunk.of) {
        throw Error("there is no chunk '" + std::string(text) +
                    "'; the chunks are numbered from 1/N to N/N");
    }
    return chunk;
}

std::string frames_text(const std::vector<std::int64_t>& frames) {
    std::string text;
    for (std::size_t i = 0; i < frames.size();) {
        std::size_t last = i;
        while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1) {
            ++last;
        }
        text += fmt::format("{}{}", (text.empty() ? "" : ", "), frames[i]);
        if (last > i) {
            text += fmt::format("-{}", frames[last]);
        }
        i = last + 1;
    }
    return text;
}

}  // namespace carom::pipeline
