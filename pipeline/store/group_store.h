// Stores that the users of a group share.
#pragma once

#include <string>

namespace carom::pipeline {

/// Makes the store's folder the group's (core/group_folder.h), which is all that marks such a
/// store, and also what this user has in it already: folders get the mode 2775, files 0664. The
/// store's own folder also gets the sticky bit, so that no member can put another folder of jobs
/// in the place of farm/. The folder is created if it does not exist. The jobs of the farm
/// (STORE/farm/NAME) stay as they are, since their scripts run as their owners. Throws Error if
/// there is no such group, if this user is not in it, or if the store is another user's and not yet
/// the group's.
void give_to_group(const std::string& store, const std::string& group);

}  // namespace carom::pipeline
