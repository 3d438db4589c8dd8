// What the samples of a frame add up to, so that a frame that was stopped can be resumed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace carom::render {

/// Filled by render_frame: 32 to 190 bytes a pixel, as the frame needs (tile_sums.h). A frame that
/// resumes from the sums of an earlier attempt, of whatever process, has the same bytes as one that
/// was never stopped.
class FrameSums {
  public:
    /// Takes the next bytes, at least one.
    using Sink = std::function<void(std::span<const std::byte>)>;
    /// Fills the whole span with the bytes that come next; false if there are not that many.
    using Source = std::function<bool(std::span<std::byte>)>;

    FrameSums();
    ~FrameSums();
    FrameSums(FrameSums&&) noexcept;
    FrameSums& operator=(FrameSums&&) noexcept;
    FrameSums(const FrameSums&) = delete;
    FrameSums& operator=(const FrameSums&) = delete;

    /// The samples of all pixels.
    [[nodiscard]] std::uint64_t samples() const;

    /// Hands the sums to `sink` in pieces. Throws what it throws.
    void save(const Sink& sink) const;
    /// The sums that save() wrote, or nothing if these are not such of a frame with that number of
    /// pixels. That they are of the same frame is for the caller to know.
    [[nodiscard]] static std::optional<FrameSums> load(const Source& source, std::size_t pixels);

    struct Data;  // frame_sums_data.h
    [[nodiscard]] Data& data() { return *data_; }

  private:
    std::unique_ptr<Data> data_;
};

}  // namespace carom::render
