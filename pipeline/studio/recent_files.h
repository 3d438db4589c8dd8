// The shots that were opened last.
#pragma once

#include <string>
#include <vector>

namespace carom::studio {

/// $XDG_STATE_HOME/carom, else ~/.local/state/carom; empty if none of both is set.
[[nodiscard]] std::string default_state_folder();

/// A list in a file of the user's, which several studios may change. One that cannot be read or
/// written is empty; nothing else fails then.
class RecentFiles {
  public:
    /// `folder`: where the file is; empty: there is no list.
    explicit RecentFiles(const std::string& folder);

    /// The absolute paths, the last one opened first. Files that do not exist are left out.
    [[nodiscard]] std::vector<std::string> list() const;

    /// Puts a file to the front.
    void add(const std::string& file);

    void remove(const std::string& file);

  private:
    [[nodiscard]] std::vector<std::string> read() const;
    void write(const std::vector<std::string>& files) const;

    std::string path_;
};

}  // namespace carom::studio
