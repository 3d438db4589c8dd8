// Tells when files may have changed on disk, also if an editor replaces them by renaming others.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace carom::studio {

/// Watches the folders of files with inotify. Where the system refuses that (there is no inotify,
/// there are too many watches, or a folder may not be read), it looks every two seconds. All
/// functions may be called from any thread.
class DiskWatch {
  public:
    /// `look` is called from a thread of the watch soon after something happened to a file. It
    /// returns whether it wants to be called again a little later, because a file is missing that
    /// may be about to be replaced.
    explicit DiskWatch(std::function<bool()> look);
    /// Waits for the end of a call.
    ~DiskWatch();
    DiskWatch(const DiskWatch&) = delete;
    DiskWatch& operator=(const DiskWatch&) = delete;
    DiskWatch(DiskWatch&&) = delete;
    DiskWatch& operator=(DiskWatch&&) = delete;

    /// The absolute paths of the files to watch from now on, instead of those before. They need not
    /// exist.
    void watch(const std::vector<std::string>& files);

    /// Waits for the end of a call; there will be no other.
    void end();

  private:
    class Thread;
    std::unique_ptr<Thread> thread_;
};

}  // namespace carom::studio
