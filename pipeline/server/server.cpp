#include "pipeline/server/server.h"

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <fcntl.h>

#include "core/error.h"
#include "pipeline/server/boost.h"
#include "pipeline/server/connection.h"
#include "pipeline/server/hub.h"
#include "pipeline/server/page.h"

namespace carom::server {

namespace {

constexpr std::chrono::milliseconds kAcceptPause{100};   // after an error, such as too many files
constexpr std::chrono::milliseconds kFarewellTime{300};  // for pages to hear that the server ends

/// A program that is started later does not inherit the socket: it would stay open with that
/// program.
void keep_from_children(int socket) {
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);
}

}  // namespace

struct Server::State : Hub {
    State(ServerOptions server_options, Site& served_site)
        : Hub(std::move(server_options), served_site), acceptor(io), pause(io), idle_timer(io) {
        const tcp::endpoint wanted(asio::ip::address_v4::loopback(), options.port);
        try {
            acceptor.open(wanted.protocol());
            keep_from_children(acceptor.native_handle());
            acceptor.set_option(asio::socket_base::reuse_address(true));
            acceptor.bind(wanted);
            acceptor.listen();
        } catch (const boost::system::system_error& error) {
            throw Error("the server cannot listen on port " + std::to_string(options.port) + ": " +
                        error.code().message());
        }
        responder = std::make_unique<Responder>(acceptor.local_endpoint().port(),
                                                std::move(options.files), site);
    }

    void accept() {
        acceptor.async_accept([this](error_code error, tcp::socket socket) {
            if (error == asio::error::operation_aborted) {
                return;
            }
            if (error) {
                pause.expires_after(kAcceptPause);
                return pause.async_wait([this](error_code aborted) {
                    if (!aborted) {
                        accept();
                    }
                });
            }
            begin(std::move(socket));
            accept();
        });
    }

    void begin(tcp::socket&& socket) {
        error_code ignored;
        keep_from_children(socket.native_handle());
        socket.set_option(tcp::no_delay(true), ignored);
        make_room_for_stranger();
        std::make_shared<Connection>(std::move(socket), *this)->read();
    }

    /// Sends what was added to the outbox since the last call.
    void flush() {
        is_flush_posted.store(false);
        const Outbox::Changes changes = outbox.take_changes();
        for (const SocketId id : changes.filled) {
            if (const auto page = pages.find(id); page != pages.end()) {
                page->second->write_next();
            }
        }
        for (const SocketId id : changes.overfilled) {
            if (const auto page = pages.find(id); page != pages.end()) {
                page->second->drop();
            }
        }
    }

    /// Ends run() if nothing happened for the time of the option.
    void watch_idleness() {
        const Clock::time_point end =
            Clock::time_point(Clock::duration(last_activity.load())) + *options.idle;
        if (end <= Clock::now()) {
            return io.stop();
        }
        idle_timer.expires_at(end);
        idle_timer.async_wait([this](error_code aborted) {
            if (!aborted) {
                watch_idleness();
            }
        });
    }

    void close_all() {
        error_code ignored;
        acceptor.close(ignored);
        pause.cancel();
        idle_timer.cancel();
        while (!connections.empty()) {
            (*connections.begin())->drop();
        }
        for (const auto& [id, page] : pages) {
            page->end(websocket::close_code::going_away);
        }
        io.restart();
        io.run_for(kFarewellTime);
        for (const auto& [id, page] : pages) {
            page->finish();
            page->drop();  // also one that did not close its side
        }
    }

    std::atomic<bool> is_flush_posted = false;
    tcp::acceptor acceptor;
    asio::steady_timer pause;
    asio::steady_timer idle_timer;
};

Server::Server(ServerOptions options, Site& site)
    : state_(std::make_unique<State>(std::move(options), site)) {}

Server::~Server() = default;

std::uint16_t Server::port() const {
    return state_->acceptor.local_endpoint().port();
}

std::string Server::address() const {
    const Access& access = state_->responder->access();
    return "http://" + access.host() + access.key_path();
}

void Server::send(SocketId to, Message message) {
    state_->touch();
    state_->outbox.add(to, std::move(message));
    if (!state_->is_flush_posted.exchange(true)) {
        asio::post(state_->io, [state = state_.get()] { state->flush(); });
    }
}

void Server::run(const std::stop_token& stop) {
    state_->touch();
    if (state_->options.idle) {
        state_->watch_idleness();
    }
    state_->accept();
    const std::stop_callback on_stop(stop, [this] { state_->io.stop(); });
    state_->io.run();
    state_->close_all();
}

}  // namespace carom::server
