#include "pipeline/job/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/error.h"

namespace carom::pipeline {

ScratchFolder::ScratchFolder() {
    std::error_code error;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
    folder_ = (parent / "carom-XXXXXX").string();
    if (error || ::mkdtemp(folder_.data()) == nullptr) {
        const std::string reason = error ? error.message() : std::generic_category().message(errno);
        throw Error("cannot create a temporary folder '" + folder_ + "': " + reason);
    }
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace carom::pipeline
