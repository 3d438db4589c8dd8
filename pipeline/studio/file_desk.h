// Files beside those of the open shot: what the start page offers, new shots, other folders, scenes
// to import, and parts of other shots.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "pipeline/config/config_files.h"
#include "pipeline/studio/errands.h"
#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/recent_files.h"
#include "pipeline/studio/start_page.h"

namespace carom::studio {

/// The texts of the open shot.
struct OpenShot {
    std::string file{};  // absolute path; empty: none is open
    std::string root{};  // the folder below which files are written
    std::shared_ptr<const pipeline::config::OpenTexts> texts{};
};

/// All functions may be called from any thread, one call at a time.
class FileDesk {
  public:
    /// Sends to the page of that number, or to all (0). Called from any thread.
    using Send = std::function<void(std::uint64_t page, const ServerMessage& message)>;

    FileDesk(const std::string& state_folder, Send send);

    /// What the start page offers; more pictures follow by themselves.
    [[nodiscard]] Start start();
    /// A shot was opened: it becomes the first of the recent ones, and no pictures are drawn.
    void opened(const std::string& file);
    void forget(const std::string& file);
    [[nodiscard]] std::optional<Still> find_still(std::string_view address) const;

    /// The absolute path of the shot that is to be opened; it is written before if the request says
    /// so. Throws Error.
    [[nodiscard]] std::variant<std::string, Exists> file_to_open(const Open& request,
                                                                 const std::string& root);

    /// The same for a copy of the open shot.
    [[nodiscard]] std::variant<std::string, Exists> save_as(const SaveAs& request,
                                                            const OpenShot& shot);

    /// These are answered later. What fails is answered with Failed.
    void answer(std::uint64_t page, const ListFolder& request, const OpenShot& shot);
    void answer(std::uint64_t page, const Import& request, const OpenShot& shot);
    void answer(std::uint64_t page, const ReadParts& request, const OpenShot& shot);
    void answer(std::uint64_t page, const AddParts& request, const OpenShot& shot);

    /// Does something later, after what waits already.
    void later(std::function<void()> work);

    /// Waits for the end of what is being done. Nothing is sent afterwards.
    void end();

  private:
    template <class Request, class Work>
    void do_later(std::uint64_t page, const Request& request, Work work);

    Send send_;
    RecentFiles recent_;
    std::unique_ptr<StartPage> page_;
    Errands errands_;  // ends first
};

}  // namespace carom::studio
