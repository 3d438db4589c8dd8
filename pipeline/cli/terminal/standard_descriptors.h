// Standard input, output and error of a process that was started without them.
#pragma once

namespace carom::cli {

/// Gives descriptors 0 to 2 that are closed (`carom … 2>&-`) to something that can be neither read
/// from nor written to. Otherwise the next file that is opened would get the number, and messages
/// would end up in a film. Call it before anything is opened.
void hold_standard_descriptors();

}  // namespace carom::cli
