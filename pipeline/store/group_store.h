// Stores that the users of a group share.
#pragma once

#include <stop_token>
#include <string>

namespace carom::pipeline {

/// Makes the store's folder the group's (core/group_folder.h), which is all that marks such a
/// store, and also what this user has in it already: folders get the mode 2775, files 0664. The
/// store's own folder and that of the jobs (STORE/farm) also get the sticky bit, so that no member
/// can put another folder in the place of farm/ or of somebody's job. Both are created if they do
/// not exist; a store that is the group's already may keep all others out (mode 3770) and stays so.
/// The jobs (STORE/farm/NAME) stay as they are, since their scripts run as their owners. Throws
/// Error if there is no such group, if this user is not in it, if the store is another user's and
/// not yet the group's, or if a folder cannot be read to its end; Stopped.
void give_to_group(const std::string& store, const std::string& group, const std::stop_token& stop);

}  // namespace carom::pipeline
