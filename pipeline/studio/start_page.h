// What the start page offers: templates, examples and the shots that were opened last, each with a
// picture.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/studio/messages.h"

namespace carom::studio {

/// A file or its bytes, and their type.
struct Still {
    std::string type;
    std::string path;                          // of a file, or empty
    std::shared_ptr<const std::string> bytes;  // else these
};

/// Examples have pictures of their films. Of other shots the tables with the paths of their balls
/// are drawn by a thread of its own. All functions may be called from any thread.
class StartPage {
  public:
    /// `changed` is called from that thread when more pictures are there.
    explicit StartPage(std::function<void()> changed);
    /// Waits for the end of the drawing under way.
    ~StartPage();
    StartPage(const StartPage&) = delete;
    StartPage& operator=(const StartPage&) = delete;
    StartPage(StartPage&&) = delete;
    StartPage& operator=(StartPage&&) = delete;

    /// The message with the pictures that there are, and begins to draw the others.
    [[nodiscard]] Start offer(const std::vector<std::string>& recent);

    /// Draws nothing more until the next offer.
    void rest();

    /// Whether the file is a template or an example.
    [[nodiscard]] bool has(const std::string& file) const;

    /// The picture of an address "/still/…".
    [[nodiscard]] std::optional<Still> find(std::string_view address) const;

  private:
    class Artist;
    std::unique_ptr<Artist> artist_;
};

/// The first sentence of the comment at the beginning of a shot, without "#".
[[nodiscard]] std::string first_sentence(std::string_view text);

}  // namespace carom::studio
