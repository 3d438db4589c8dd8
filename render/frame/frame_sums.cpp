#include "render/frame/frame_sums.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "render/frame/frame_sums_data.h"

namespace carom::render {
namespace {

constexpr std::array<char, 8> kMagic{'c', 'a', 'r', 'o', 'm', 's', 'u', '4'};
constexpr std::size_t kPiece = std::size_t{1} << 20;  // bytes

/// Calls `visit` for each value of a pixel except its lists.
template <class Visit, class Pixel>
requires std::is_same_v<std::remove_const_t<Pixel>, PixelSums>
void for_each_value(Visit& visit, Pixel& pixel) {
    visit(pixel.radiance);
    visit(pixel.normal);
    visit(pixel.albedo);
    visit(pixel.coverage);
    visit(pixel.luminance);
    visit(pixel.luminance2);
    visit(pixel.samples);
    visit(pixel.half_radiance[0]);
    visit(pixel.half_radiance[1]);
}

/// Collects small values into pieces.
class Writer {
  public:
    explicit Writer(const FrameSums::Sink& sink) : sink_(sink) { buffer_.reserve(kPiece); }

    void operator()(const Vec3& value) { (*this)(std::array{value.x, value.y, value.z}); }
    void operator()(const V3f& value) { (*this)(std::array{value.x, value.y, value.z}); }
    template <class Value>
    void operator()(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        const auto bytes = std::as_bytes(std::span(&value, 1));
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
        if (buffer_.size() >= kPiece) {
            flush();
        }
    }

    template <class Value>
    void list(const std::vector<Value>& values) {
        (*this)(std::uint64_t{values.size()});
        for (const Value& value : values) {
            (*this)(value);
        }
    }

    /// What the halves saw, if it is for the denoiser.
    void halves(const std::array<PixelFeatures, 2>& values) {
        const bool are_used = values != std::array<PixelFeatures, 2>{};
        (*this)(static_cast<std::uint8_t>(are_used));
        if (are_used) {
            (*this)(values);
        }
    }

    void flush() {
        if (!buffer_.empty()) {
            sink_(buffer_);
        }
        buffer_.clear();
    }

  private:
    const FrameSums::Sink& sink_;
    std::vector<std::byte> buffer_;
};

/// After the first value that is not there, nothing more is read.
class Reader {
  public:
    explicit Reader(const FrameSums::Source& source) : source_(source) {}

    [[nodiscard]] bool is_good() const { return is_good_; }

    void operator()(Vec3& value) {
        std::array<double, 3> xyz{};
        (*this)(xyz);
        value = {xyz[0], xyz[1], xyz[2]};
    }
    void operator()(V3f& value) {
        std::array<float, 3> xyz{};
        (*this)(xyz);
        value = {xyz[0], xyz[1], xyz[2]};
    }
    template <class Value>
    void operator()(Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        is_good_ = is_good_ && source_(std::as_writable_bytes(std::span(&value, 1)));
    }

    /// Grows the list as its values arrive, so that a wrong length takes no memory.
    template <class Value>
    void list(std::vector<Value>& values) {
        std::uint64_t count = 0;
        (*this)(count);
        for (; count > 0 && is_good_; --count) {
            (*this)(values.emplace_back());
        }
    }

    void halves(std::array<PixelFeatures, 2>& values) {
        std::uint8_t are_used = 0;
        (*this)(are_used);
        if (are_used != 0) {
            (*this)(values);
        }
    }

  private:
    const FrameSums::Source& source_;
    bool is_good_ = true;
};

}  // namespace

FrameSums::FrameSums() : data_(std::make_unique<Data>()) {}
FrameSums::~FrameSums() = default;
FrameSums::FrameSums(FrameSums&&) noexcept = default;
FrameSums& FrameSums::operator=(FrameSums&&) noexcept = default;

std::uint64_t FrameSums::samples() const {
    std::uint64_t sum = 0;
    for (const PixelSums& pixel : data_->pixels) {
        sum += static_cast<std::uint64_t>(pixel.samples);
    }
    return sum;
}

void FrameSums::save(const Sink& sink) const {
    Writer write(sink);
    write(kMagic);
    write(std::uint64_t{data_->pixels.size()});
    write(data_->statistics);
    write.list(data_->plan);
    write.list(data_->features);
    write.list(data_->seconds);
    for (const PixelSums& pixel : data_->pixels) {
        for_each_value(write, pixel);
        write.list(pixel.objects);
        write.halves(pixel.halves);
    }
    write.flush();
}

std::optional<FrameSums> FrameSums::load(const Source& source, std::size_t pixels) {
    FrameSums sums;
    Data& data = *sums.data_;
    Reader read(source);
    std::array<char, 8> magic{};
    read(magic);
    std::uint64_t count = 0;
    read(count);
    if (!read.is_good() || magic != kMagic || count != pixels) {
        return std::nullopt;
    }
    read(data.statistics);
    read.list(data.plan);
    read.list(data.features);
    read.list(data.seconds);
    data.pixels.resize(pixels);
    for (PixelSums& pixel : data.pixels) {
        for_each_value(read, pixel);
        read.list(pixel.objects);
        read.halves(pixel.halves);
    }
    const auto fits = [&](std::size_t size) { return size == 0 || size == pixels; };
    if (!read.is_good() || !fits(data.plan.size()) || !fits(data.features.size())) {
        return std::nullopt;
    }
    return sums;
}

}  // namespace carom::render
