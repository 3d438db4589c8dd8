// A file that sends a browser to an address which nobody else may learn. The address would be seen
// in the list of processes if the browser got it as an argument.
#pragma once

#include <string>

namespace carom::server {

class PrivatePage {
  public:
    /// Writes an HTML file that only this user can read (mode 0600), in $XDG_RUNTIME_DIR or,
    /// without it, in a new folder for temporary files that only this user can open. Throws Error.
    explicit PrivatePage(const std::string& address);
    /// Removes the file.
    ~PrivatePage();
    PrivatePage(const PrivatePage&) = delete;
    PrivatePage& operator=(const PrivatePage&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string folder_;  // to be removed as well; empty: none
    std::string path_;
};

}  // namespace carom::server
