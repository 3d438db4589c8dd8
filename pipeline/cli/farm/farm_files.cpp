#include "pipeline/cli/farm/farm_files.h"

#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include <fmt/core.h>

#include "core/error.h"
#include "core/hash.h"
#include "pipeline/config/emit_yaml.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "files";

/// The name of a copy, which no other copy has. Its extension is that of the file, by which readers
/// choose the format.
std::string name_of_copy(const fs::path& original, std::set<std::string>& taken) {
    const std::string stem = farm::simple_name(original.stem().string());
    const std::string given = original.extension().string();
    const std::string extension = given.empty() ? "" : "." + farm::simple_name(given.substr(1));
    std::string name = stem + extension;
    for (int number = 2; !taken.insert(name).second; ++number) {
        name = fmt::format("{}-{}{}", stem, number, extension);
    }
    return name;
}

void copy(const sim::Asset& asset, const std::string& target) {
    std::error_code failure;
    fs::copy_file(asset.path, target, failure);
    if (failure) {
        throw Error("'" + asset.path + "' cannot be copied to '" + target +
                    "': " + failure.message());
    }
    if (hash_file(target) != asset.content_hash) {
        throw Error("'" + asset.path + "' has changed since the shot was read; try again");
    }
}

}  // namespace

void copy_files(const pipeline::Shot& shot, const pipeline::ShotSource& source, sim::Bake& bake,
                const std::string& folder) {
    std::map<std::string, std::string> copies;  // by the path of the original
    std::set<std::string> taken;
    bake.assets = shot.assets;
    if (!bake.assets.empty()) {
        pipeline::create_folder(folder + "/" + kFolder);
    }
    for (sim::Asset& asset : bake.assets) {
        const std::string path = fmt::format("{}/{}", kFolder, name_of_copy(asset.path, taken));
        copy(asset, fmt::format("{}/{}", folder, path));
        copies[asset.path] = path;
        asset.path = path;
    }
    std::map<const pipeline::config::Node*, std::string> names;
    for (const auto& [node, original] : source.replaced()) {
        const auto copy = copies.find(original);  // moments stay as they are written
        if (copy != copies.end()) {
            names[node] = copy->second;
        }
    }
    bake.shot_text = pipeline::config::emit_yaml(source.root(), names);
}

}  // namespace carom::cli
