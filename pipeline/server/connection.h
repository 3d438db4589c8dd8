// A connection over which a client sends HTTP requests. Part of server.cpp.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "pipeline/server/boost.h"
#include "pipeline/server/hub.h"
#include "pipeline/server/page.h"

namespace carom::server {

using RequestParser = http::request_parser<http::empty_body>;

inline Request plain_request(RequestParser& parser) {
    const auto& head = parser.get();
    Request request;
    request.method = std::string(head.method_string());
    request.target = std::string(head.target());
    for (const auto& field : head) {
        std::string name(field.name_string());
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        request.fields.emplace_back(std::move(name), std::string(field.value()));
    }
    request.is_upgrade = websocket::is_upgrade(head);
    request.keeps_connection = head.keep_alive();
    return request;
}

/// Kept alive by the handlers that wait for its socket. Until it has shown a key it is a
/// stranger's: such connections have less time, and a new one takes the place of the one that has
/// been idle for longest, so that they keep out nobody who has the key.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(tcp::socket&& socket, Hub& hub) : stream_(std::move(socket)), hub_(hub) {
        hub_.connections.insert(this);
    }
    ~Connection() { hub_.connections.erase(this); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Waits for a request.
    void read() {
        parser_.emplace();
        parser_->header_limit(static_cast<std::uint32_t>(hub_.limits.header_bytes));
        parser_->body_limit(std::numeric_limits<std::uint64_t>::max());  // no body is ever read
        waits_since_ = Clock::now();
        stream_.expires_after(is_known_
                                  ? hub_.limits.request_time
                                  : std::min(hub_.limits.request_time, hub_.limits.stranger_time));
        http::async_read_header(
            stream_, buffer_, *parser_,
            [self = shared_from_this()](error_code error, std::size_t /*size*/) {
                self->waits_since_.reset();
                self->take_request(error);
            });
    }

    /// Since when no byte of a next request has come; empty if one is being read or answered.
    [[nodiscard]] std::optional<Clock::time_point> waits_since() const {
        return buffer_.size() == 0 ? waits_since_ : std::nullopt;
    }

    /// Whether it has shown a key.
    [[nodiscard]] bool is_known() const { return is_known_; }

    /// When it began, or last sent a whole request or took a part of an answer.
    [[nodiscard]] Clock::time_point last_progress() const { return last_progress_; }

    /// From then on it does not count any more.
    void drop() {
        hub_.connections.erase(this);
        stream_.close();
    }

  private:
    static constexpr std::size_t kPartBytes = 64 << 10;   // of an answer, sent at once
    static constexpr std::size_t kLingerBytes = 8 << 20;  // that it may still send meanwhile

    void take_request(error_code error) {
        if (error == http::error::header_limit) {
            return send(hub_.responder->refuse(431, "The request is too long."));
        }
        if (error == http::error::end_of_stream || error == http::error::partial_message) {
            return drop();
        }
        if (error) {  // not HTTP; or a lost connection, where this answer fails as well
            return send(hub_.responder->refuse(400, "The request is not understood."));
        }
        const Request request = plain_request(*parser_);
        last_progress_ = Clock::now();
        const Verdict verdict = hub_.responder->access().judge(request);
        if (verdict == Verdict::allowed) {
            hub_.touch();
        }
        if (!is_known_ && (verdict == Verdict::allowed || verdict == Verdict::welcome)) {
            if (!hub_.has_room_for_known()) {
                return send(hub_.responder->refuse(503, "There are too many connections."));
            }
            is_known_ = true;
        }
        if (hub_.responder->may_open_socket(request)) {
            return open_page();
        }
        send(hub_.responder->answer(request));
    }

    void open_page() {
        if (hub_.pages.size() >= hub_.limits.sockets) {
            return send(hub_.responder->refuse(503, "Too many pages are open."));
        }
        if (buffer_.size() > 0) {  // a client must wait for the answer
            return send(hub_.responder->refuse(400, "Data came before the socket was open."));
        }
        stream_.expires_never();
        std::make_shared<Page>(stream_.release_socket(), hub_)->accept(parser_->release());
    }

    void send(Answer answer) {
        answer_ = std::move(answer);
        part_ = answer_.head;
        write_part();
    }

    /// Writes `part_`, with as much of the body as fits.
    void write_part() {
        const std::size_t size = part_.size();
        part_.resize(size + kPartBytes);
        part_.resize(size + answer_.body.read(std::span(part_).subspan(size)));
        if (part_.empty()) {  // the file became shorter than it was announced
            return drop();
        }
        stream_.expires_after(hub_.limits.answer_time);
        asio::async_write(stream_, asio::buffer(part_),
                          [self = shared_from_this()](error_code error, std::size_t /*size*/) {
                              self->go_on(error);
                          });
    }

    void go_on(error_code error) {
        part_.clear();
        last_progress_ = Clock::now();
        if (error) {
            drop();
        } else if (answer_.body.bytes_left() > 0) {
            write_part();
        } else if (answer_.keeps_connection) {
            answer_ = {};
            read();
        } else {
            error_code ignored;
            stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
            stream_.expires_after(hub_.limits.linger_time);
            part_.resize(kPartBytes);
            linger(kLingerBytes);
        }
    }

    /// Reads until the client closes. Closing while bytes are unread would make its system throw
    /// the answer away.
    void linger(std::size_t left) {
        stream_.async_read_some(asio::buffer(part_), [self = shared_from_this(), left](
                                                         error_code error, std::size_t size) {
            if (!error && size < left) {
                self->linger(left - size);
            }
        });
    }

    beast::tcp_stream stream_;
    beast::flat_buffer buffer_;
    Hub& hub_;
    std::optional<RequestParser> parser_;
    std::optional<Clock::time_point> waits_since_;
    Clock::time_point last_progress_ = Clock::now();
    bool is_known_ = false;
    Answer answer_;
    std::string part_;
};

inline bool Hub::has_room_for_known() {
    const auto is_known = [](const Connection* one) { return one->is_known(); };
    if (std::ranges::count_if(connections, is_known) <
        static_cast<std::ptrdiff_t>(limits.connections)) {
        return true;
    }
    Connection* longest = nullptr;
    for (Connection* connection : connections) {
        const auto since = is_known(connection) ? connection->waits_since() : std::nullopt;
        if (since && (longest == nullptr || *since < *longest->waits_since())) {
            longest = connection;
        }
    }
    if (longest != nullptr) {
        longest->drop();
    }
    return longest != nullptr;
}

inline void Hub::make_room_for_stranger() {
    Connection* slowest = nullptr;
    std::size_t count = 0;
    for (Connection* connection : connections) {
        if (!connection->is_known()) {
            ++count;
            if (slowest == nullptr || connection->last_progress() < slowest->last_progress()) {
                slowest = connection;
            }
        }
    }
    if (count >= limits.strangers) {
        slowest->drop();
    }
}

}  // namespace carom::server
