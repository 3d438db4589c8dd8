#include <cstddef>
#include <span>
#include <utility>

#include "core/hash.h"
#include "render/light/far_light.h"

namespace carom::render {
namespace {

// The inputs' number, the cells and the panorama, and the hash of all that. Numbers
// are little endian or in groups of seven bits, the lowest first, with a bit more if another group
// follows; keys are differences from the key before.
constexpr std::string_view kBeginning = "carom far light 2\n";

class Writer {
  public:
    void text(std::string_view text) {
        number(text.size());
        bytes_ += text;
    }
    void number(std::uint64_t value) {
        for (; value >= 0x80; value >>= 7) {
            bytes_ += static_cast<char>(value | 0x80);
        }
        bytes_ += static_cast<char>(value);
    }
    void word(std::uint32_t word) {
        for (int byte = 0; byte < 4; ++byte) {
            bytes_ += static_cast<char>(word >> 8 * byte);
        }
    }
    std::string take() { return std::move(bytes_); }

  private:
    std::string bytes_{kBeginning};
};

class Reader {
  public:
    explicit Reader(std::string_view bytes) : left_(bytes) {}

    std::uint64_t number() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            const std::uint64_t group = byte();
            value |= (group & 0x7f) << shift;
            if (group < 0x80) {
                break;
            }
        }
        return value;
    }
    std::uint32_t word() {
        std::uint32_t word = 0;
        for (int i = 0; i < 4; ++i) {
            word |= static_cast<std::uint32_t>(byte()) << 8 * i;
        }
        return word;
    }
    std::string_view text() {
        const std::string_view text = left_.substr(0, number());
        left_.remove_prefix(text.size());
        return text;
    }

  private:
    /// 0 beyond the end.
    std::uint8_t byte() {
        if (left_.empty()) {
            return 0;
        }
        const auto byte = static_cast<std::uint8_t>(left_.front());
        left_.remove_prefix(1);
        return byte;
    }
    std::string_view left_;
};

std::string checksum(std::string_view bytes) {
    return hash_bytes(std::as_bytes(std::span(bytes))).to_string();
}

}  // namespace

std::string encoded(const FarLight& light, std::string_view inputs) {
    Writer out;
    out.text(inputs);
    out.number(light.cells().size());
    std::uint64_t last = 0;
    for (const FarLight::Cell& cell : light.cells()) {
        out.number(cell.key - std::exchange(last, cell.key));
    }
    for (const FarLight::Cell& cell : light.cells()) {
        out.word(cell.irradiance.bits());
    }
    for (const SharedExponent& pixel : light.panorama()) {
        out.word(pixel.bits());
    }
    std::string bytes = out.take();
    return bytes + checksum(bytes);
}

std::shared_ptr<const FarLight> decoded(std::string_view bytes, std::string_view inputs,
                                        const FarRegion& region) {
    const std::size_t size_of_sum = checksum({}).size();
    if (!bytes.starts_with(kBeginning) || bytes.size() < kBeginning.size() + size_of_sum) {
        return nullptr;
    }
    const std::string_view contents = bytes.substr(0, bytes.size() - size_of_sum);
    if (checksum(contents) != bytes.substr(contents.size())) {
        return nullptr;
    }
    Reader in(contents.substr(kBeginning.size()));
    if (in.text() != inputs) {
        return nullptr;
    }
    std::vector<FarLight::Cell> cells(in.number());
    std::uint64_t key = 0;
    for (FarLight::Cell& cell : cells) {
        cell.key = key += in.number();
    }
    for (FarLight::Cell& cell : cells) {
        cell.irradiance = SharedExponent::of_bits(in.word());
    }
    std::vector<SharedExponent> panorama(std::size_t{FarLight::kColumns} * FarLight::kColumns / 2);
    for (SharedExponent& pixel : panorama) {
        pixel = SharedExponent::of_bits(in.word());
    }
    return std::make_shared<const FarLight>(region, std::move(cells), std::move(panorama));
}

}  // namespace carom::render
