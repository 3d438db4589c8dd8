// A frame that cannot be filmed.
#pragma once

#include "core/error.h"

namespace carom::pipeline {

/// A camera has no valid view in a frame: a fault of the shot.
class NoView : public Error {
  public:
    using Error::Error;
};

}  // namespace carom::pipeline
