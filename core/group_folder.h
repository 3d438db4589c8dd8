// Folders that a group shares: set-group-ID and writable for the group (mode 2775). New files there
// get the folder's group, and what carom makes there is for the group, whatever the mask of the
// user (umask) is.
#pragma once

#include <string>

namespace carom {

[[nodiscard]] bool is_group_folder(const std::string& path);

/// Lets the group read and write a file of this user (mode 0664) if `folder`, in which it lies, is
/// a group's. A failure is ignored: others of the group meet it with its reason.
void share_file(int descriptor, const std::string& folder);

/// The same for a folder of this user (mode 2775) if the one in which it lies is a group's. One of
/// another user, or a link, is left as it is.
void share_folder(const std::string& path);

}  // namespace carom
