#include "pipeline/cli/farm/store_path.h"

#include <filesystem>

#include "pipeline/store/cache_folder.h"

namespace carom::cli {

std::string absolute_path(const std::string& path) {
    return std::filesystem::absolute(path).lexically_normal().string();
}

std::string store_of(const FarmCommand& command) {
    return absolute_path(command.store.empty() ? pipeline::default_cache_folder() : command.store);
}

}  // namespace carom::cli
