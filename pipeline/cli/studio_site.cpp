#include "pipeline/cli/studio_site.h"

#include <utility>

namespace carom::cli {

std::optional<server::Resource> StudioSite::find(std::string_view path) {
    std::optional<studio::Download> download = session_->find(path);
    if (!download) {
        return std::nullopt;
    }
    return server::Resource{std::move(download->type), std::move(download->bytes),
                            std::move(download->path)};
}

}  // namespace carom::cli
