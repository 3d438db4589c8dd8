// The exit codes of carom.
#pragma once

namespace carom::cli {

enum ExitCode : int {
    kDone = 0,
    kFailed = 1,      // while running, such as a full disk or an error of a library
    kWrongUsage = 2,  // an invalid command line or input
    kInterrupted = 130,
};

}  // namespace carom::cli
