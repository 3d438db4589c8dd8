// The film of a session: `carom render` runs as a program of its own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/studio/film_request.h"
#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/session.h"

namespace carom::studio {

/// All functions may be called from any thread, one call at a time, and return without waiting for
/// the program.
class FilmRun {
  public:
    struct Output {
        /// Sends to a page, or to all (0). Called from any thread. It must not call the run.
        std::function<void(PageId page, const ServerMessage& message)> send;
        /// Whether a film is being made from now on. As above.
        std::function<void(bool running)> running;
    };

    FilmRun(ProgramOptions options, Output output);
    /// Stops the film and waits for its end.
    ~FilmRun();
    FilmRun(const FilmRun&) = delete;
    FilmRun& operator=(const FilmRun&) = delete;
    FilmRun(FilmRun&&) = delete;
    FilmRun& operator=(FilmRun&&) = delete;

    /// Makes a film of that file of a shot, below `root` or the folder of films. What fails later
    /// is told as Failed, Exists or a FilmState. Throws Error if a film is being made.
    void start(PageId page, const StartFilm& request, const std::string& shot,
               const std::string& root);
    void stop();

    /// Tells a page of the last film.
    void tell(PageId page);

    /// The film at "/film/…" once it is done, and its frames at "/film_frame/…".
    [[nodiscard]] std::optional<Download> find(std::string_view address) const;

  private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::studio
