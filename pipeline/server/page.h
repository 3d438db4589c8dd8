// The WebSocket of a page. Part of server.cpp.
#pragma once

#include <memory>
#include <utility>

#include "pipeline/server/boost.h"
#include "pipeline/server/hub.h"

namespace carom::server {

/// Kept alive by the handlers that wait for its socket.
class Page : public std::enable_shared_from_this<Page> {
  public:
    Page(tcp::socket&& socket, Hub& hub)
        : socket_(std::move(socket)), hub_(hub), id_(++hub.last_id), watch_(hub.io) {
        hub_.pages.emplace(id_, this);
    }
    ~Page() { hub_.pages.erase(id_); }
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;

    void accept(const http::request<http::empty_body>& request) {
        websocket::stream_base::timeout times{};
        times.handshake_timeout = hub_.limits.request_time;
        times.idle_timeout = hub_.limits.socket_time;
        times.keep_alive_pings = true;
        socket_.set_option(times);
        socket_.set_option(websocket::permessage_deflate{});  // off, as it is by default
        socket_.read_message_max(hub_.limits.message_bytes);
        socket_.set_option(
            websocket::stream_base::decorator([](websocket::response_type& response) {
                response.set(http::field::sec_websocket_protocol, std::string(kProtocol));
            }));
        socket_.auto_fragment(false);  // else a picture is sent in frames of 4 KiB
        socket_.async_accept(request, [self = shared_from_this()](error_code error) {
            if (!error) {
                self->open();
            }
        });
    }

    /// Sends what waits, one message after the other.
    void write_next() {
        if (!is_open_ || current_) {
            return;
        }
        current_ = hub_.outbox.next(id_);
        if (!current_) {
            return;
        }
        socket_.binary(current_->binary);
        socket_.async_write(asio::buffer(current_->data),
                            [self = shared_from_this()](error_code error, std::size_t /*size*/) {
                                self->current_ = nullptr;
                                if (error) {
                                    self->drop();
                                } else {
                                    self->hub_.touch();
                                    self->write_next();
                                }
                            });
    }

    /// Says goodbye; the page closes its side.
    void end(websocket::close_code code) {
        if (!is_open_) {
            return drop();
        }
        socket_.async_close(code, [self = shared_from_this()](error_code /*error*/) {});
    }

    /// Closes at once. The waiting read ends with an error, which finishes the page.
    void drop() { beast::get_lowest_layer(socket_).close(); }

    /// Tells the site that the page is closed. More calls do nothing.
    void finish() {
        if (std::exchange(is_open_, false)) {
            watch_.cancel();
            hub_.outbox.close(id_);
            hub_.site.closed(id_);
        }
    }

  private:
    void open() {
        is_open_ = true;
        hub_.touch();
        hub_.outbox.open(id_);
        hub_.site.opened(id_);
        read();
        write_next();
        watch();
    }

    /// Drops the page if it was told that its socket ends and does not close its side. Beast 1.74
    /// waits for that without a limit after a message that breaks the rules.
    void watch() {
        watch_.expires_after(hub_.limits.linger_time);
        watch_.async_wait([self = shared_from_this()](error_code aborted) {
            if (aborted || !self->is_open_) {
                return;
            }
            if (self->socket_.is_open()) {
                self->watch();
            } else {
                self->drop();
            }
        });
    }

    void read() {
        socket_.async_read(buffer_,
                           [self = shared_from_this()](error_code error, std::size_t /*size*/) {
                               if (error) {
                                   self->finish();
                               } else {
                                   self->take_message();
                               }
                           });
    }

    void take_message() {
        if (!socket_.got_text()) {
            end(websocket::close_code::unknown_data);
            return finish();
        }
        hub_.touch();
        hub_.site.received(id_, beast::buffers_to_string(buffer_.data()));
        buffer_.consume(buffer_.size());
        read();
    }

    websocket::stream<beast::tcp_stream> socket_;
    beast::flat_buffer buffer_;
    Hub& hub_;
    SocketId id_;
    asio::steady_timer watch_;
    std::shared_ptr<const Message> current_;  // being sent
    bool is_open_ = false;
};

}  // namespace carom::server
