// The finished frames of a film, with small pictures of them.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "pipeline/studio/film_request.h"
#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/session.h"

namespace carom::studio {

/// Keeps the frames of one film after the other. All functions may be called from any thread; only
/// draw() takes a while.
class FilmArtist {
  public:
    /// Sends to a page, or to all (0). Called from any thread. It must not call the artist.
    using Send = std::function<void(PageId page, const ServerMessage& message)>;

    FilmArtist(std::string cache_folder, Send send)
        : cache_folder_(std::move(cache_folder)), send_(std::move(send)) {}

    /// Another film begins; the frames of the one before are forgotten. `film`: its number, for
    /// addresses. draw() must not run.
    void begin(int film);

    /// A frame is finished; draw() sends it to the pages.
    void add(FilmFrame frame);

    /// Draws the frames that were added and tells the pages of them, until all are drawn and
    /// `ended`, or `cancelled`. Runs beside the reading of the log, which must not wait.
    void draw(const PreparedFilm& film, const std::stop_token& ended,
              const std::stop_token& cancelled);

    /// Tells a page of the frames of which the others were told.
    void tell(PageId page);

    /// The picture at "/film_frame/…".
    [[nodiscard]] std::optional<Download> find(std::string_view address);

  private:
    [[nodiscard]] std::optional<FilmFrame> next(const std::stop_token& ended,
                                                const std::stop_token& cancelled);

    std::string cache_folder_;
    Send send_;

    std::mutex mutex_;  // of the members below; held while sending, so that tell() misses nothing
    std::condition_variable_any added_;
    int film_ = 0;                   // its number
    std::deque<FilmFrame> waiting_;  // for their pictures
    std::map<std::int64_t, FilmFrame> frames_;
    std::map<std::string, std::shared_ptr<const std::string>, std::less<>> pictures_;
};

}  // namespace carom::studio
