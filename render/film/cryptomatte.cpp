#include "render/film/cryptomatte.h"

#include <algorithm>
#include <bit>
#include <set>

#include <fmt/core.h>

#include "core/json_text.h"

namespace carom::render {
namespace {

constexpr std::uint32_t kFirstFactor = 0xcc9e2d51U;
constexpr std::uint32_t kSecondFactor = 0x1b873593U;

std::uint32_t scrambled(std::uint32_t block) {
    return std::rotl(block * kFirstFactor, 15) * kSecondFactor;
}

/// Up to four bytes, the lowest first.
std::uint32_t little_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = bytes.size(); i > 0; --i) {
        value = value << 8U | static_cast<unsigned char>(bytes[i - 1]);
    }
    return value;
}

std::string hex_text(std::uint32_t value) {
    return fmt::format("{:08x}", value);
}

std::string manifest(const std::vector<std::string>& names) {
    std::string text = "{";
    for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
        text += text.size() > 1 ? "," : "";
        text += json_string(name) + ":\"" + hex_text(std::bit_cast<std::uint32_t>(matte_id(name))) +
                '"';
    }
    return text + "}";
}

}  // namespace

std::uint32_t murmur_hash3_32(std::string_view text) {
    std::uint32_t hash = 0;
    std::string_view rest = text;
    for (; rest.size() >= 4; rest.remove_prefix(4)) {
        hash = std::rotl(hash ^ scrambled(little_endian(rest.substr(0, 4))), 13) * 5 + 0xe6546b64U;
    }
    hash ^= scrambled(little_endian(rest));
    hash ^= static_cast<std::uint32_t>(text.size());
    hash = (hash ^ hash >> 16U) * 0x85ebca6bU;
    hash = (hash ^ hash >> 13U) * 0xc2b2ae35U;
    return hash ^ hash >> 16U;
}

float matte_id(std::string_view name) {
    const std::uint32_t hash = murmur_hash3_32(name);
    const std::uint32_t exponent = std::clamp(hash >> 23U & 255U, 1U, 254U);
    return std::bit_cast<float>((hash & 0x807fffffU) | exponent << 23U);
}

MatteRanks ranked(const std::vector<MatteRank>& entries) {
    std::vector<MatteRank> merged;
    for (const MatteRank& one : entries) {
        const auto same = std::find_if(merged.begin(), merged.end(),
                                       [&](const MatteRank& m) { return m.id == one.id; });
        if (same != merged.end()) {
            same->coverage += one.coverage;
        } else {
            merged.push_back(one);
        }
    }
    std::stable_sort(merged.begin(), merged.end(), [](const MatteRank& a, const MatteRank& b) {
        return a.coverage > b.coverage;
    });
    MatteRanks result;
    std::copy_n(merged.begin(), std::min(merged.size(), kMatteRanks), result.begin());
    return result;
}

std::vector<std::string> matte_channels(std::string_view layer) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kMatteRanks / 2; ++i) {
        for (const char* channel : {".R", ".G", ".B", ".A"}) {
            names.push_back(fmt::format("{}0{}{}", layer, i, channel));
        }
    }
    return names;
}

Film::Notes matte_notes(std::string_view layer, const std::vector<std::string>& names) {
    const std::string key = "cryptomatte/" + hex_text(murmur_hash3_32(layer)).substr(0, 7) + "/";
    return {{key + "name", std::string(layer)},
            {key + "hash", "MurmurHash3_32"},
            {key + "conversion", "uint32_to_float32"},
            {key + "manifest", manifest(names)}};
}

}  // namespace carom::render
