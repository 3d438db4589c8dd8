// A web server for one user on the same machine: HTTP/1.1 and WebSocket on the loopback interface.
// It does not know what it serves. docs/developers/studio_security.md lists the rules that it
// follows and their reasons.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace carom::server {

/// The WebSocket of a page: 1, 2, ... in the order of opening, never used twice. 0: all sockets.
using SocketId = std::uint64_t;

/// A message to a page.
struct Message {
    bool binary = false;
    std::string data;
    /// A newer message of the same slot replaces one that waits to be sent. It takes its place in
    /// the queue, unless it would overtake a message without a slot. Empty: every message is
    /// delivered, in order.
    std::string slot;
};

/// The answer to a GET.
struct Resource {
    std::string type;                          // "text/html; charset=utf-8"
    std::shared_ptr<const std::string> bytes;  // null: the file at `path`
    std::string path;  // served in parts, with byte ranges, and never read as a whole: for films
};

/// What a server serves besides its fixed files. All functions are called on the thread of
/// Server::run, and must return at once and not throw.
class Site {
  public:
    virtual ~Site() = default;

    /// The resource at a path, such as "/scene/HASH.glb", for a client that has the key; empty
    /// if there is none. The path has only letters, digits and "-_./", and no part of it is empty
    /// or begins with a dot.
    virtual std::optional<Resource> find(std::string_view path) = 0;

    /// For each socket: opened once, then received for each text, then closed once.
    virtual void opened(SocketId socket) = 0;
    virtual void received(SocketId socket, std::string text) = 0;
    virtual void closed(SocketId socket) = 0;
};

/// What a client may demand of the server, which closes a connection that goes beyond.
struct Limits {
    std::size_t header_bytes = 16 << 10;
    std::size_t message_bytes = 4 << 20;   // of a message from a page
    std::size_t connections = 8;           // HTTP, of clients that have shown the key
    std::size_t strangers = 32;            // HTTP, of those that have not, the newest
    std::size_t sockets = 4;               // WebSockets
    std::size_t waiting_messages = 256;    // without a slot, for one socket
    std::size_t waiting_bytes = 64 << 20;  // of these
    std::chrono::milliseconds request_time{
        30'000};  // from the end of one request to that of the next
    std::chrono::milliseconds stranger_time{5'000};  // the same without the key
    std::chrono::milliseconds answer_time{60'000};   // in which a client takes a part of an answer
    std::chrono::milliseconds socket_time{300'000};  // in which a page answers at least a ping
    /// In which a client closes its side, after the last answer or the end of its socket.
    std::chrono::milliseconds linger_time{2'000};
};

struct ServerOptions {
    std::uint16_t port = 0;  // 0: any free port
    /// The files of the page by their path in kPageFolder: "/", "/main.js". They are no secret:
    /// whoever asks gets them. In HTML, kNoncePlaceholder is replaced.
    std::map<std::string, Resource> files;
    /// run() ends if for so long nothing was asked, received or sent; empty: it does not.
    std::optional<std::chrono::milliseconds> idle;
    Limits limits{};
};

/// Where the page is: its address in the browser.
inline constexpr std::string_view kPageFolder = "/studio/";

/// The path at which a page opens its WebSocket. It offers two protocols: kProtocol, which the
/// server takes, and kKeyProtocol with the key behind it.
inline constexpr std::string_view kSocketPath = "/socket";
inline constexpr std::string_view kProtocol = "carom";
inline constexpr std::string_view kKeyProtocol = "carom.key.";

/// In fixed HTML files the server replaces this text by the nonce with which the page may add style
/// elements (Content-Security-Policy: style-src).
inline constexpr std::string_view kNoncePlaceholder = "CAROM_NONCE";

class Server {
  public:
    /// Binds 127.0.0.1, and nothing else. Throws Error if that is not possible, for instance
    /// because the port is in use. `site` must outlive the server.
    Server(ServerOptions options, Site& site);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    [[nodiscard]] std::uint16_t port() const;

    /// "http://127.0.0.1:PORT/?key=...". Whoever knows the key may do all that the page may do.
    [[nodiscard]] std::string address() const;

    /// Sends a message to a page, or to all. Any thread may call; the function never blocks. A
    /// message to a socket that is closed is dropped. A page that takes no messages until too many
    /// wait (Limits) loses its socket.
    void send(SocketId to, Message message);

    /// Serves until the token is triggered or the server was idle. Call it once. Throws Error.
    void run(const std::stop_token& stop);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::server
