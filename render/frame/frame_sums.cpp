#include "render/frame/frame_sums.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "render/frame/frame_sums_data.h"

namespace carom::render {
namespace {

constexpr std::array<char, 8> kMagic{'c', 'a', 'r', 'o', 'm', 's', 'u', '6'};
constexpr std::size_t kPiece = std::size_t{1} << 20;  // bytes

template <class Kind, class Visit>
void for_each_flag(Kind&& kind, Visit& visit) {
    visit(kind.halves);
    visit(kind.variance);
    visit(kind.surfaces);
    visit(kind.features);
    visit(kind.objects);
}

/// Collects small values into pieces.
class Writer {
  public:
    explicit Writer(const FrameSums::Sink& sink) : sink_(sink) { buffer_.reserve(kPiece); }

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
        const auto bytes = std::as_bytes(std::span(values));
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
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

    void operator()(bool& value) {
        std::uint8_t byte = 0;
        (*this)(byte);
        value = byte != 0;
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
        while (count > values.size() && is_good_) {
            const std::size_t known = values.size();
            values.resize(known + std::min<std::size_t>(count - known, kPiece / sizeof(Value)));
            is_good_ = source_(std::as_writable_bytes(std::span(values).subspan(known)));
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
    return data_->statistics.camera_rays;
}

void FrameSums::save(const Sink& sink) const {
    Writer write(sink);
    write(kMagic);
    write(std::uint64_t{data_->pixels});
    write(data_->statistics);
    write(data_->has_plan);
    write.list(data_->seconds);
    write(std::uint64_t{data_->tiles.size()});
    for (const TileSums& tile : data_->tiles) {
        write(std::uint64_t{tile.size()});
        for_each_flag(tile.kind(), write);
        TileSums::for_each_plane(tile, [&](const auto& plane) { write.list(plane); });
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
    data.pixels = pixels;
    std::uint64_t tiles = 0;
    read(data.statistics);
    read(data.has_plan);
    read.list(data.seconds);
    read(tiles);
    std::size_t known = 0;
    for (; tiles > 0 && read.is_good(); --tiles) {
        std::uint64_t size = 0;
        SumsKind kind;
        read(size);
        for_each_flag(kind, read);
        known += size;
        if (!read.is_good() || known > pixels) {
            return std::nullopt;
        }
        TileSums& tile = data.tiles.emplace_back(size, kind);
        TileSums::for_each_plane(tile, [&](auto& plane) {
            plane.clear();
            read.list(plane);
        });
        if (!read.is_good() || tile.size() != size || !tile.is_valid(data.has_plan)) {
            return std::nullopt;
        }
    }
    if (!read.is_good() || data.seconds.size() != data.tiles.size()) {
        return std::nullopt;
    }
    return sums;
}

}  // namespace carom::render
