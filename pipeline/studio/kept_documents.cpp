#include "pipeline/studio/kept_documents.h"

#include <algorithm>
#include <cstddef>
#include <memory>

#include "pipeline/studio/paths.h"
#include "pipeline/video/picture_kind.h"

namespace carom::studio {
namespace {

constexpr std::size_t kMaxKept = 24;

std::string type_of(const std::string& file) {
    return media_type_of(file, "text/plain; charset=utf-8");
}

}  // namespace

Made KeptDocuments::keep(const Make& request, std::int64_t v, const std::string& extension,
                         std::string bytes) {
    Made made = add(
        request, extension,
        Download{
            type_of("x" + extension), std::make_shared<const std::string>(std::move(bytes)), {}});
    made.v = v;
    return made;
}

Made KeptDocuments::keep_file(const Make& request, const std::string& file) {
    Made made = add(request, pipeline::extension_of(file), Download{type_of(file), nullptr, file});
    made.file = file;
    return made;
}

Made KeptDocuments::add(const Make& request, const std::string& extension, Download download) {
    const std::lock_guard lock(mutex_);
    Made made{request.q, 0, request.what, "/made/" + std::to_string(number_++) + extension, ""};
    kept_.emplace_back(made.address, std::move(download));
    if (kept_.size() > kMaxKept) {
        kept_.pop_front();
    }
    return made;
}

std::optional<Download> KeptDocuments::find(std::string_view address) {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(kept_, address, &std::pair<std::string, Download>::first);
    return found == kept_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace carom::studio
