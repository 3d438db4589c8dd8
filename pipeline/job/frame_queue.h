// What the rendering and the encoding thread of a job tell each other.
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

/// Which pictures the store has, by index. A picture that the encoder waits for is handed over in
/// memory when it is rendered; it reads all others from the store, so that nothing piles up here.
class FrameQueue {
  public:
    explicit FrameQueue(std::size_t pictures) : is_ready_(pictures, false) {}

    // The rendering side.
    /// The store has the picture. `film`: as the store holds it, if it was rendered just now.
    void mark_ready(std::size_t picture, std::optional<render::Film> film = {});
    /// A picture that the encoder could not read, if there is one.
    [[nodiscard]] std::optional<std::size_t> take_request();
    /// Whether the encoder has all that it needs, or has given up.
    [[nodiscard]] bool reader_is_done();
    /// Returns when there is a request, `longest` is over or `stop` triggered.
    void wait_for_request(std::chrono::milliseconds longest, const std::stop_token& stop);
    /// Returns when there is a request, the reader is done or `stop` triggered.
    void wait_for_reader(const std::stop_token& stop);

    // The encoding side.
    /// False if stopped before.
    [[nodiscard]] bool wait_until_ready(std::size_t picture, const std::stop_token& stop);
    /// The picture, if it is rendered while this waits for it; nothing if only the store has it.
    /// Throws Stopped.
    [[nodiscard]] std::optional<render::Film> receive(std::size_t picture,
                                                      const std::stop_token& stop);
    /// The picture was announced but is not in the store, or not whole.
    void request_again(std::size_t picture);
    void reader_done();

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
