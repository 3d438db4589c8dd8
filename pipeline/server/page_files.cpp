#include "pipeline/server/page_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/file_reader.h"

namespace carom::server {

namespace {

constexpr std::array kMediaTypes = std::to_array<std::pair<std::string_view, std::string_view>>({
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".txt", "text/plain; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".wasm", "application/wasm"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".webp", "image/webp"},
    {".ico", "image/x-icon"},
    {".woff", "font/woff"},
    {".woff2", "font/woff2"},
    {".ttf", "font/ttf"},
    {".glb", "model/gltf-binary"},
    {".mp4", "video/mp4"},
    {".webm", "video/webm"},
});

std::string read_file(const std::string& path) {
    FileReader reader(path);
    std::string text(reader.size().value_or(0), '\0');
    text.resize(reader.read(std::as_writable_bytes(std::span(text))));
    return text;
}

}  // namespace

std::string media_type(std::string_view name) {
    const auto* const found =
        std::find_if(kMediaTypes.begin(), kMediaTypes.end(),
                     [&](const auto& type) { return name.ends_with(type.first); });
    return std::string(found == kMediaTypes.end() ? "application/octet-stream" : found->second);
}

std::map<std::string, Resource> read_page_files(const std::string& folder) {
    std::map<std::string, Resource> files;
    std::error_code error;
    std::filesystem::recursive_directory_iterator entries(folder, error);
    for (; !error && entries != std::filesystem::recursive_directory_iterator();
         entries.increment(error)) {
        if (entries->is_regular_file()) {
            const std::string path = entries->path().string();
            const std::string name =
                "/" + entries->path().lexically_relative(folder).generic_string();
            files[name] = {media_type(name), std::make_shared<const std::string>(read_file(path)),
                           ""};
        }
    }
    if (error) {
        throw Error("'" + folder + "': the folder cannot be read: " + error.message());
    }
    if (const auto index = files.find("/index.html"); index != files.end()) {
        files["/"] = index->second;
    }
    return files;
}

}  // namespace carom::server
