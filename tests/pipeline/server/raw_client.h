// A client that writes any bytes to a server at 127.0.0.1 and reads what comes back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace carom::testing {

struct HttpAnswer {
    int status = 0;  // 0: the connection was closed without an answer
    std::string head;
    std::string body;

    /// The value of a field of the head; empty if there is none.
    [[nodiscard]] std::string field(const std::string& name) const;
};

struct Frame {
    int operation = 0;  // 1 text, 2 binary, 8 close, 9 ping, 10 pong; 0: a continuation
    std::string payload;

    /// The code in a frame that closes; 0 if there is none.
    [[nodiscard]] int close_code() const;
};

/// A frame of a client. `is_masked`: as the standard demands.
[[nodiscard]] std::string frame_bytes(int operation, std::string_view payload, bool is_final = true,
                                      bool is_masked = true);

/// Every wait fails after 30 s: reading then acts as if the connection were closed.
class RawClient {
  public:
    /// Throws std::runtime_error if it cannot connect. A small receive buffer makes the server see
    /// early that the client does not read.
    explicit RawClient(std::uint16_t port, int receive_buffer_bytes = 0,
                       const char* address = "127.0.0.1");
    ~RawClient();
    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    /// Writes all bytes, unless the server closes before.
    void send(std::string_view bytes) const;

    /// Reads one answer with the length that it announces. `has_body`: false after HEAD.
    [[nodiscard]] HttpAnswer read_answer(bool has_body = true);

    /// Reads the next frame; empty if the connection is closed.
    [[nodiscard]] std::optional<Frame> read_frame();

    /// Reads and ignores what comes, and returns true as soon as the server closes.
    [[nodiscard]] bool is_closed_by_server();

  private:
    bool receive();  // more bytes into received_; false: closed
    bool receive_at_least(std::size_t size);
    [[nodiscard]] std::string take(std::size_t size);

    int descriptor_ = -1;
    std::string received_;
    bool has_timed_out_ = false;
};

}  // namespace carom::testing
