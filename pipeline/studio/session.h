// A session of the studio: one shot and the pages that show it. It has no socket: the server passes
// the texts of its pages in, and sends what the session gives it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom::studio {

using PageId = std::uint64_t;  // 0: all pages

/// A message to a page.
struct Outgoing {
    PageId to = 0;
    bool binary = false;
    std::string data;
    /// Of two messages that wait for the same page and have the same slot, only the later one has
    /// to be sent. Empty: all of them.
    std::string slot;
};

/// What a GET returns.
struct Download {
    std::string type;                          // "application/json"
    std::shared_ptr<const std::string> bytes;  // null: the contents of the file `path`
    std::string path;
};

struct SessionOptions {
    std::string shot{};                    // the path of its file; empty: the start page
    std::vector<std::string> overrides{};  // as given to --set
    std::string quality{};                 // a preset, or empty
    std::string root{};          // the folder below which files are read and written; empty: that
                                 // of shot_root.h, or the current one
    std::string output{};        // the folder of films; empty: that of the shot
    std::string cache_folder{};  // empty: the usual one
    std::string state_folder{};  // of the list of recent files; empty: the usual one
    std::string program{};       // carom itself, which makes films and documents
};

/// All functions may be called from any thread, and return without waiting for work.
class Session {
  public:
    /// Called from any thread, one call at a time. It must not call the session.
    using Send = std::function<void(Outgoing)>;

    /// Throws Error if the shot's file cannot be read.
    Session(SessionOptions options, Send send);
    /// Stops all work and waits for its end.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    Session(Session&&) = delete;
    Session& operator=(Session&&) = delete;

    /// A page connected, or is gone.
    void opened(PageId page);
    void closed(PageId page);

    /// A text that the page sent. One that cannot be understood is answered with Failed.
    void received(PageId page, const std::string& text);

    /// What a GET of that path ("/schema.json", "/configs.json", "/scene/HASH.glb") returns; empty:
    /// there is no such file.
    [[nodiscard]] std::optional<Download> find(std::string_view path);

    /// The folder below which files may be read and written now.
    [[nodiscard]] std::string files_root() const;

  private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::studio
