// How failures travel. Functions of carom print nothing and never exit.
#pragma once

#include <stdexcept>
#include <string>

namespace carom {

/// Something failed while running (a file, a library, a limit). what() is a whole sentence for the
/// user, with the path or object it is about; exit code 1.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The caller's stop token was triggered and the work ended early, leaving nothing half-written;
/// exit code 130.
class Stopped : public Error {
  public:
    Stopped() : Error("stopped on request") {}
};

}  // namespace carom
