// Exceptions for failures. Functions of carom print nothing and never exit.
#pragma once

#include <stdexcept>
#include <string>

namespace carom {

/// A failure at run time (a file, a library, a limit). what() is a complete sentence for the user
/// that names the path or object; exit code 1.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The caller's stop token was triggered. The work ended early without incomplete files; exit code
/// 130.
class Stopped : public Error {
  public:
    Stopped() : Error("stopped on request") {}
};

}  // namespace carom
