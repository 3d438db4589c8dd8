#include "pipeline/server/private_page.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <system_error>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/write_all.h"

namespace carom::server {

namespace {

/// Whether this is a folder of this user that others cannot open.
bool is_private_folder(const char* path) {
    struct stat status {};
    return path != nullptr && *path == '/' && ::stat(path, &status) == 0 &&
           S_ISDIR(status.st_mode) && status.st_uid == ::geteuid() && (status.st_mode & 077) == 0;
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what + ": " + std::generic_category().message(errno));
}

std::string make_folder() {
    std::error_code ignored;
    std::filesystem::path folder = std::filesystem::temp_directory_path(ignored);
    std::string name = (folder.empty() ? "/tmp" : folder.string()) + "/carom_studio_XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) {  // with mode 0700
        fail(name, "the folder cannot be created");
    }
    return name;
}

std::string page_text(const std::string& address) {
    return "<!DOCTYPE html><meta charset=utf-8><title>carom studio</title>\n"
           "<meta name=referrer content=no-referrer>\n"
           "<meta http-equiv=refresh content=\"0;url=" +
           address + "\">\n<p><a href=\"" + address + "\">Open the studio</a>\n";
}

}  // namespace

PrivatePage::PrivatePage(const std::string& address) {
    const char* runtime_folder = std::getenv("XDG_RUNTIME_DIR");
    std::string name;
    if (is_private_folder(runtime_folder)) {
        name = runtime_folder;
    } else {
        name = folder_ = make_folder();
    }
    name += "/carom_studio_XXXXXX.html";
    const int descriptor = ::mkostemps(name.data(), 5, O_CLOEXEC);  // with mode 0600
    const std::string text = page_text(address);
    const bool is_written =
        descriptor >= 0 && write_all(descriptor, std::as_bytes(std::span(text)));
    const int reason = errno;
    if (descriptor >= 0) {
        path_ = name;
        ::close(descriptor);
    }
    if (!is_written) {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
        std::filesystem::remove(folder_, ignored);
        errno = reason;
        fail(name, "the file cannot be written");
    }
}

PrivatePage::~PrivatePage() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    if (!folder_.empty()) {
        std::filesystem::remove(folder_, ignored);
    }
}

}  // namespace carom::server
