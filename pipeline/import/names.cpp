#include "pipeline/import/names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/core.h>
#include <iconv.h>

#include "pipeline/config/text.h"

namespace carom::pipeline::scene_text {

namespace {

constexpr std::size_t kLongestName = 48;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_allowed(char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

bool is_valid(const std::string& name) {
    static const std::set<std::string> kReserved{"all", "auto", "none", "true", "false", "null"};
    return !name.empty() && name.size() <= kLongestName && (is_letter(name[0]) || name[0] == '_') &&
           kReserved.count(name) == 0 && std::all_of(name.begin(), name.end(), is_allowed);
}

// The letters from U+00C0 to U+017F (Latin-1 Supplement and Latin Extended-A), sixteen in a row.
constexpr char32_t kFirstLatin = 0xC0;
constexpr std::array<const char*, 192> kPlainLatin{
    "A", "A", "A",  "A",  "A", "A", "AE", "C", "E", "E", "E", "E", "I", "I", "I",  "I",   //
    "D", "N", "O",  "O",  "O", "O", "O",  "x", "O", "U", "U", "U", "U", "Y", "Th", "ss",  //
    "a", "a", "a",  "a",  "a", "a", "ae", "c", "e", "e", "e", "e", "i", "i", "i",  "i",   //
    "d", "n", "o",  "o",  "o", "o", "o",  "_", "o", "u", "u", "u", "u", "y", "th", "y",   //
    "A", "a", "A",  "a",  "A", "a", "C",  "c", "C", "c", "C", "c", "C", "c", "D",  "d",   //
    "D", "d", "E",  "e",  "E", "e", "E",  "e", "E", "e", "E", "e", "G", "g", "G",  "g",   //
    "G", "g", "G",  "g",  "H", "h", "H",  "h", "I", "i", "I", "i", "I", "i", "I",  "i",   //
    "I", "i", "IJ", "ij", "J", "j", "K",  "k", "k", "L", "l", "L", "l", "L", "l",  "L",   //
    "l", "L", "l",  "N",  "n", "N", "n",  "N", "n", "n", "N", "n", "O", "o", "O",  "o",   //
    "O", "o", "OE", "oe", "R", "r", "R",  "r", "R", "r", "S", "s", "S", "s", "S",  "s",   //
    "S", "s", "T",  "t",  "T", "t", "T",  "t", "U", "u", "U", "u", "U", "u", "U",  "u",   //
    "U", "u", "U",  "u",  "W", "w", "Y",  "y", "Y", "Z", "z", "Z", "z", "Z", "z",  "s",
};

/// The bytes of the UTF-8 character that begins with `first`.
std::size_t character_bytes(unsigned char first) {
    return first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

bool is_combining_accent(char32_t letter) {
    return letter >= 0x300 && letter < 0x370;
}

class Decoder {
  public:
    Decoder() : handle_(iconv_open("UTF-8", "WINDOWS-1250")) {}
    ~Decoder() {
        if (is_open()) {
            iconv_close(handle_);
        }
    }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    /// A question mark for a byte without a meaning.
    [[nodiscard]] std::string operator()(char byte) const {
        std::array<char, 4> made{};
        char* in = &byte;
        char* out = made.data();
        std::size_t in_left = 1;
        std::size_t out_left = made.size();
        if (!is_open() || iconv(handle_, &in, &in_left, &out, &out_left) != 0) {
            return "?";
        }
        return std::string(made.data(), made.size() - out_left);
    }

  private:
    [[nodiscard]] bool is_open() const { return reinterpret_cast<std::intptr_t>(handle_) != -1; }
    iconv_t handle_;
};

}  // namespace

std::string as_utf8(const std::string& text, bool& was_decoded) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    std::string given =
        text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
    std::replace(given.begin(), given.end(), '\0', '?');
    was_decoded = config::find_invalid_utf8(given) != std::string_view::npos;
    if (!was_decoded) {
        return given;
    }
    const Decoder decoded;
    std::string all;
    for (const char byte : given) {
        if (static_cast<unsigned char>(byte) < 0x80) {
            all += byte;
        } else {
            all += decoded(byte);
        }
    }
    return all;
}

std::string without_accents(const std::string& name) {
    std::string plain;
    for (std::size_t at = 0; at < name.size();) {
        const auto first = static_cast<unsigned char>(name[at]);
        const std::size_t bytes = character_bytes(first);
        char32_t letter = first;
        if (bytes == 2 && at + 1 < name.size()) {
            letter = (first & 0x1FU) << 6U | (static_cast<unsigned char>(name[at + 1]) & 0x3FU);
        }
        if (bytes == 2 && letter >= kFirstLatin && letter < kFirstLatin + kPlainLatin.size()) {
            plain += kPlainLatin[letter - kFirstLatin];
        } else if (bytes != 2 || !is_combining_accent(letter)) {
            plain += name.substr(at, bytes);
        }
        at += bytes;
    }
    return plain;
}

Names::Names(const std::vector<std::string>& given) {
    for (const std::string& name : given) {
        if (is_valid(name)) {
            kept_.insert(name);
            taken_.insert(name);
        }
    }
}

std::string Names::claim(const std::string& name) {
    if (kept_.erase(name) == 1) {
        return name;
    }
    std::string made;
    const std::string plain = without_accents(name);
    for (std::size_t at = 0; at < plain.size() && made.size() < kLongestName;) {
        made += is_allowed(plain[at]) ? plain[at] : '_';
        at += character_bytes(static_cast<unsigned char>(plain[at]));
    }
    if (!is_valid(made)) {
        made = "n_" + made;
    }
    std::string free = made;
    while (!taken_.insert(free).second) {
        int& number = latest_[made];
        number = number == 0 ? 2 : number + 1;
        free = fmt::format("{}_{}", made, number);
    }
    return free;
}

}  // namespace carom::pipeline::scene_text
