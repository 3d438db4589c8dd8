// The page's types of the messages.
#pragma once

#include <string>

namespace carom::studio {

/// The text of studio/src/protocol.ts: an interface for each struct of message_fields.h, unions of
/// the messages of message_lists.h, and their constants.
[[nodiscard]] std::string protocol_types();

}  // namespace carom::studio
