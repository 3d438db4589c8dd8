// The exit codes of carom.
#pragma once

namespace carom::cli {

enum ExitCode : int {
    kDone = 0,
    kFailed = 1,       // while running, such as a full disk or an error of a library
    kWrongUsage = 2,   // an invalid command line or input
    kTryAgain = 75,    // EX_TEMPFAIL of sysexits.h: the same command may succeed later
    kOutOfTime = 124,  // a task of the farm stopped because its time limit was over
    kInterrupted = 130,
    kOutOfMemory = 137,  // a task of the farm had too little memory, as if it was killed
};

}  // namespace carom::cli
