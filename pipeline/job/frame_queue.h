// The queue between the rendering and the encoding thread of a job.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/film/film.h"

namespace carom::pipeline {

/// Records which pictures the store has, by index. A picture that the encoder waits for is handed
/// over in memory when it is rendered. The encoder reads all others from the store, so that no
/// pictures accumulate here.
class FrameQueue {
  public:
    explicit FrameQueue(std::size_t pictures) : is_ready_(pictures, false) {}

    // For the rendering thread:
    /// Marks a picture as stored. `film` is the picture as stored, if it was rendered just now.
    void mark_ready(std::size_t picture, std::optional<render::Film> film = {});
    /// Removes and returns a picture that the encoder could not read, if there is one.
    [[nodiscard]] std::optional<std::size_t> take_request();
    /// Whether the encoder needs no more pictures, or has failed.
    [[nodiscard]] bool reader_is_done();
    /// Returns when there is a request, `longest` has passed or `stop` is triggered.
    void wait_for_request(std::chrono::milliseconds longest, const std::stop_token& stop);
    /// Returns when there is a request, the reader is done or `stop` is triggered.
    void wait_for_reader(const std::stop_token& stop);

    // For the encoding thread:
    /// Returns false if stopped before the picture is ready.
    [[nodiscard]] bool wait_until_ready(std::size_t picture, const std::stop_token& stop);
    /// Waits until the picture is ready. Returns the picture if it is rendered during the wait, and
    /// nothing if it has to be read from the store. Throws Stopped.
    [[nodiscard]] std::optional<render::Film> receive(std::size_t picture,
                                                      const std::stop_token& stop);
    /// Requests a picture that was marked as ready but is missing or damaged in the store.
    void request_again(std::size_t picture);
    void mark_reader_done();

  private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::vector<bool> is_ready_;
    std::deque<std::size_t> requests_;
    std::optional<std::size_t> awaited_;  // by receive()
    std::optional<render::Film> film_;    // the picture that is awaited
    bool reader_is_done_ = false;
};

}  // namespace carom::pipeline
